// What the status stream has to say of one command: that the robot is where its tag says, or that it has come
// to rest before.
//
// It only sees and judges; what follows of that is the run's (command_run.h).
#pragma once

#include <optional>
#include <string>

#include "cobot_command/arm/arm_model.h"
#include "cobot_command/link/connection.h"
#include "cobot_command/robot/arrival.h"
#include "cobot_command/robot/robot_watch.h"
#include "cobot_command/robot/stall_watch.h"

namespace cobot_command::command {

class Evidence {
 public:
  /// `target`: where the command leaves the robot, if that is certain. What it refers to has to live longer;
  /// `arm`: nullptr without a model.
  Evidence(const robot::RobotWatch& robot, const link::LinkSettings& settings, const arm::ArmModel* arm,
           std::optional<robot::Target> target)
      : robot_(robot), settings_(settings), arm_(arm), target_(std::move(target)) {}

  // --- Before its tag.
  /// With each frame since it was sent.
  void watch(Instant now) { stall_.see(robot_, now); }
  /// The robot has moved and come to rest, and nothing is seen to hold it.
  [[nodiscard]] bool stalled() const { return stall_.stalled(settings_.evidence_timeout); }
  /// The robot has been at standstill for as long as the evidence for a tag may take: not only in one frame,
  /// which may be between two motions. Without joint angles the last frame has to do.
  [[nodiscard]] bool rests() const {
    return robot_.joints() ? stall_.rests(settings_.evidence_timeout) : robot_.moving() == false;
  }
  /// stalled(), and not at its target. A stop by somebody else is reported to nobody, but looks so; the
  /// controller, asked, then no longer knows the tag. The question alone changes nothing, so it needs no
  /// certainty.
  [[nodiscard]] bool stalledOnTheWay() const;
  /// It was looked into: the rest begins anew.
  void lookedInto() { stall_.lookedInto(); }
  /// For people: it was stopped by somebody else.
  [[nodiscard]] std::string stallText(int tag) const;

  // --- Behind its tag.
  /// With each frame. True: the robot is where it should be, or nobody can tell where it is. The first frames
  /// may be of before the tag, so that one which tells otherwise tells nothing.
  [[nodiscard]] bool confirms();

  enum class Verdict {
    Confirmed,
    Open,  ///< a slow stream: a few more frames tell it
    Contradicted
  };
  /// When it has had its time: what was seen until now has to do.
  [[nodiscard]] Verdict verdict() const;
  /// Where the robot was by the frame that is the evidence: the one of now, unless it has moved on since.
  [[nodiscard]] robot::StreamedPlace place() const { return reached_.value_or(robot_.place()); }
  /// Why the status stream has not shown that it is at its end, for people; empty: it has, as far as that is
  /// known.
  [[nodiscard]] std::string whyUnseen() const;
  /// For people, of what is contradicted.
  [[nodiscard]] std::string contradiction(int tag) const;

 private:
  [[nodiscard]] std::optional<robot::Gap> gap() const;

  const robot::RobotWatch& robot_;
  const link::LinkSettings& settings_;
  const arm::ArmModel* arm_;
  std::optional<robot::Target> target_;
  robot::StallWatch stall_;
  std::optional<robot::StreamedPlace> reached_;  ///< where it was first seen at its target since its tag
};

}  // namespace cobot_command::command
