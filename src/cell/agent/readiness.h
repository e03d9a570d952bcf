// Whether a robot can go on with its program, and what it reports of that.
#pragma once

#include <string>

#include "cobot_command/cell/supervision/report.h"
#include "cobot_command/robot/robot_watch.h"

namespace cobot_command::cell {

class Readiness {
 public:
  /// Why the program does not go on until a person has let it.
  enum class Halt {
    None,
    Stopped,  ///< where it cannot begin again
    Stuck,    ///< it was recovered within a step that nothing goes on from within
    OffPath,
    Error  ///< of the robot, or an emergency stop
  };

  void halt(Halt why) { halt_ = why; }
  [[nodiscard]] Halt halted() const { return halt_; }
  [[nodiscard]] bool isHalted() const { return halt_ != Halt::None; }

  /// Why nothing can be sent to the robot; empty: it can. True: that is news.
  bool unlinked(const std::string& why) {
    const bool is_news = why != unlinked_;
    unlinked_ = why;
    return is_news;
  }

  [[nodiscard]] RobotCondition condition(const robot::RobotWatch& watch) const {
    const bool has_error = watch.showsError() || watch.emergencyStop();
    switch (halt_) {
      case Halt::OffPath:
        return RobotCondition::OffPath;
      case Halt::Error:
        // Once it is over at the robot, a person may say that the program goes on.
        return has_error ? RobotCondition::Error : RobotCondition::Stopped;
      case Halt::Stopped:
      case Halt::Stuck:
        return RobotCondition::Stopped;
      case Halt::None:
        break;
    }
    if (watch.manualMode()) return RobotCondition::Manual;
    if (!unlinked_.empty()) return RobotCondition::Unlinked;
    return watch.held() ? RobotCondition::Paused : RobotCondition::Ok;
  }

  /// For people.
  [[nodiscard]] std::string text() const {
    if (halt_ == Halt::Stopped) return "its program was stopped on a path";
    if (halt_ == Halt::Stuck) {
      return "only a motion of joints can be continued from within its step: bring it to a station by hand, "
             "and recover it there";
    }
    return halt_ == Halt::None ? unlinked_ : "";
  }

 private:
  Halt halt_ = Halt::None;
  std::string unlinked_ = "it has not been connected yet";
};

}  // namespace cobot_command::cell
