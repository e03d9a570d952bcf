// The action run_cell: a run_program of each robot, and what became of them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "supervision/robot_contact.h"
#include <ros/node_handle.h>

#include "cobot_command/CellState.h"
#include "cobot_command/RunCellAction.h"
#include "cobot_command/cell/supervision/cell_state.h"
#include "cobot_command/common/time.h"
#include "cobot_command/ros/shared/tidy_action_server.h"

namespace cobot_command::ros_adapter {

/// To be spun by one thread.
class ProgramRuns {
 public:
  /// `contacts`: by robot, in the order of the cell; they outlive this.
  ProgramRuns(const ros::NodeHandle& node, const ActionQueues& queues, std::vector<std::string> robots,
              const std::vector<std::unique_ptr<RobotContact>>& contacts);

  /// The cell as it is told now.
  void follow(const cell::CellStatus& status, const cobot_command::CellState& told, Instant now);
  /// Until follow() takes over another state of the cell: no goal begins.
  void refuse(const std::string& why);
  /// The least of any two robots or mechanisms, as the monitor has measured it now [m].
  void heardDistance(double distance);
  /// It is silent: what was measured before is not all of it.
  void lostMonitor() { has_lost_monitor_ = true; }
  /// Why the monitor has stopped all; empty: it has not.
  void heardAlarm(std::string why) { alarm_ = std::move(why); }

 private:
  using Server = TidyActionServer<cobot_command::RunCellAction>;
  using Handle = Server::GoalHandle;

  struct Member {
    std::size_t robot = 0;
    std::shared_ptr<RobotContact::ProgramClient> client = {};  ///< outlives the handle; nullptr: not sent yet
    RobotContact::ProgramHandle handle = {};
    bool is_open = true;
    bool is_done = false;       ///< it SUCCEEDED
    std::uint64_t session = 0;  ///< of its node, when its goal was sent
  };
  struct Fault {
    int id = 0;
    std::string found;
    std::string remedy;
  };

  void onGoal(Handle goal);
  void onCancel(const Handle& goal);
  [[nodiscard]] std::optional<Fault> objectionTo(const cobot_command::RunCellGoal& goal) const;
  [[nodiscard]] std::optional<Fault> objectionTo(std::size_t robot) const;
  /// Those of the goal, in the order of the cell; precondition: all are known.
  [[nodiscard]] std::vector<std::size_t> membersOf(const cobot_command::RunCellGoal& goal) const;
  /// The goals of those whose node answers by now.
  void sendGoals();
  void onProgram(std::size_t member, const RobotContact::ProgramHandle& handle);
  /// Those of whose goals nothing will be told any more.
  void giveUpLost();
  void fail(Fault fault);
  void tell();
  void endIfOver();
  void begin(const Handle& goal);
  [[nodiscard]] int open() const;

  std::vector<std::string> robots_;
  const std::vector<std::unique_ptr<RobotContact>>& contacts_;
  cell::CellStatus status_;
  std::string alarm_;
  Instant now_;

  // Of the goal that is under way.
  std::optional<Handle> goal_;
  std::vector<Member> members_;
  std::optional<Fault> fault_;  ///< the first one
  cobot_command::RunCellFeedback feedback_;
  bool is_cancelled_ = false;
  bool has_lost_monitor_ = false;  ///< since it was sent
  cobot_command::RunCellResult result_;
  Instant begun_;

  Server server_;  // last: its callbacks need all the others
};

}  // namespace cobot_command::ros_adapter
