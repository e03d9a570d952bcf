// What brings about the rows of the error catalogue, by block and id.
#pragma once

#include <functional>
#include <map>
#include <utility>

#include "cobot_command/blocks/list/goal.h"
#include "cobot_command/blocks/shared/error_catalogue.h"
#include "cobot_command/blocks/shared/outcome.h"

namespace cobot_command::testing {

using Row = std::pair<blocks::Block, int>;
/// How a goal ends that meets the condition of the row.
using Scenario = std::function<blocks::Outcome()>;
using Scenarios = std::map<Row, Scenario>;

/// The goal in that mode, if its block has modes.
[[nodiscard]] blocks::Goal inMode(blocks::BufferMode mode, blocks::Goal goal);

[[nodiscard]] Scenarios connectScenarios();
/// The settings of the interface, and how they cease to rule.
[[nodiscard]] Scenarios exchangeScenarios();
/// What the interface has against a goal that may move the robot.
[[nodiscard]] Scenarios interfaceScenarios(const blocks::Goal& goal);
/// To resume a robot that it has interrupted.
[[nodiscard]] Scenarios resumeScenarios();
/// Goals of all command blocks with one bad parameter.
[[nodiscard]] Scenarios parameterScenarios();
/// Moves, and scripts of them, that the arm cannot make, or of which that is not known.
[[nodiscard]] Scenarios planningScenarios();

// The same for any command, `goal` being one that may be sent.
/// There is no connection on which it could be tried.
[[nodiscard]] Scenarios triedScenarios(const blocks::Goal& goal);
/// It cannot be told to the controller.
[[nodiscard]] Scenarios linkScenarios(const blocks::Goal& goal);
/// It is not its turn, or not the time for any command.
[[nodiscard]] Scenarios turnScenarios(const blocks::Goal& goal);
/// The controller, or the wire, fails a command that was sent.
[[nodiscard]] Scenarios replyScenarios(const blocks::Goal& goal);
/// The way of a motion from its acceptance to its end.
[[nodiscard]] Scenarios motionScenarios(const blocks::Goal& goal);
/// A stop, or the stop after a cancel, that nobody answers.
[[nodiscard]] Scenarios stopScenarios(const blocks::Goal& goal);
/// A target in a tf frame that has moved when the goal's turn comes.
[[nodiscard]] Scenarios movedFrameScenarios();
/// The ends of a wait for an input, or for a time.
[[nodiscard]] Scenarios waitScenarios();
/// Paths: their points, plans, and ways on the wire.
[[nodiscard]] Scenarios pathScenarios();
/// Trajectories, the same.
[[nodiscard]] Scenarios trajectoryScenarios();
/// Jogs, the same.
[[nodiscard]] Scenarios jogScenarios();
/// Ways back to where the robot was interrupted: their goals and plans.
[[nodiscard]] Scenarios returnScenarios();
/// Ways back along a path: their goals and plans, and how they end on the wire.
[[nodiscard]] Scenarios retraceScenarios();
/// Programs in a cell: their goals, permits and frames.
[[nodiscard]] Scenarios programScenarios();
/// What moves a robot in a cell, and is no program of that.
[[nodiscard]] Scenarios cellScenarios(const blocks::Goal& goal);
/// Sequences and cycles of them.
[[nodiscard]] Scenarios sequenceScenarios();

}  // namespace cobot_command::testing
