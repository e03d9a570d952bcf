// One path of a program, planned step by step.
#pragma once

#include <chrono>
#include <set>
#include <string>
#include <vector>

#include "cobot_command/cell/plan/planned_cell.h"
#include "cobot_command/planning/script_planner.h"

namespace cobot_command::cell {

/// Behind the end of the motion before: it has stood then.
inline constexpr Duration kLate = std::chrono::seconds(1);

/// What counts where a robot stands.
struct Standing {
  arm::Pose base = arm::Pose::Identity();
  arm::Pose tcp = arm::Pose::Identity();
  std::set<std::string> carried;
};
[[nodiscard]] arm::Pose tcpOf(const Robot& robot);

class PathPlanning {
 public:
  struct Begin {
    const arm::ArmModel& arm;
    double speed_override = 1.0;
    arm::JointVector joints;
    Standing standing;
  };

  /// `field`: of the path in its file.
  PathPlanning(const Begin& begin, std::string field);

  /// `end`: the joints of the station that it leads to.
  [[nodiscard]] PlannedPath plan(const Path& path, const arm::JointVector& end);
  [[nodiscard]] Standing end() const;
  [[nodiscard]] const std::vector<Fault>& faults() const { return faults_; }

 private:
  void planStep(const Step& step, std::size_t index, PlannedPath& path);
  /// False: a fault was told.
  [[nodiscard]] bool planCommand(const script::ScriptCommand& command, const Step& step, PlannedFrame& frame);
  void fault(const Place& place, const std::string& field, std::string found, std::string advice);
  void checkEnd(const Path& path, const arm::JointVector& end);

  planning::ScriptPlanner separate_;  ///< each motion from rest
  planning::ScriptPlanner flowing_;   ///< as it goes where nothing waits
  Duration ready_{};                  ///< when what stands is done with its dwell
  std::set<std::string> carried_;
  std::string field_;
  std::size_t step_ = 0;
  std::vector<Fault> faults_;
};

}  // namespace cobot_command::cell
