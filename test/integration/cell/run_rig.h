// A cell of the demos that runs in one process, and what has to hold of it at every moment.
#pragma once

#include <functional>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "agent/zone_watch.h"
#include <gmock/gmock.h>

#include "cobot_command/blocks/run_program.h"
#include "cobot_command/blocks/shared/error_ids.h"
#include "cobot_command/trial/cell_trial.h"

namespace cobot_command::trial {

using namespace std::chrono_literals;

using Change = std::function<void(cell::Parameters&)>;

/// The artifact of a cell of config/cells, with coarse voxels so that it is soon there.
[[nodiscard]] std::shared_ptr<const cell::Artifact> artifactOf(const std::string& name,
                                                               const Change& change = {});

/// The same of a cell's text; nothing of it is made coarser.
[[nodiscard]] std::shared_ptr<const cell::Artifact> artifactOfText(
    const std::string& text, const Change& change = {}, cell::Policy policy = cell::Policy::Supervisor);

/// Looks at a trial while time passes: no zone ever has two holders by what the robots themselves believe, no
/// robot is in a zone that the supervisor last gave to another one or to nobody, and the arms keep the
/// margin.
class RunRig {
 public:
  explicit RunRig(std::shared_ptr<const cell::Artifact> made, const TrialSettings& settings = {});

  /// All are let in, and each has its goal of so many cycles.
  void begin(int cycles);
  /// Passes time, and looks.
  void pass(Duration duration);
  /// False: that did not come.
  bool passUntil(const std::function<bool()>& done, Duration most = std::chrono::minutes(5));
  /// All goals are at their end, and each was done.
  [[nodiscard]] bool endsAll(Duration most = std::chrono::minutes(20));
  /// As above, of one robot. False, too: another end.
  [[nodiscard]] bool ends(cell::RobotIndex robot, Duration most = std::chrono::minutes(5));
  /// Another goal for a robot.
  void order(cell::RobotIndex robot, int cycles, std::vector<std::string> paths = {});

  /// Somebody beside the cell has a robot's controller carry out these lines.
  void commandByOther(cell::RobotIndex robot, const std::vector<std::string>& lines);

  [[nodiscard]] TrialRobot& robot(cell::RobotIndex index) { return trial->robot(index); }
  [[nodiscard]] cell::Supervision& supervision() { return trial->supervision(); }
  [[nodiscard]] cell::RobotStatus of(cell::RobotIndex index) const { return trial->status().robots[index]; }
  [[nodiscard]] cell::ZoneStatus zone(cell::ZoneIndex index) const { return trial->status().zones[index]; }
  [[nodiscard]] cell::SupervisorMode mode() const { return trial->status().mode; }
  [[nodiscard]] bool isMoving(cell::RobotIndex index) { return robot(index).state().in_motion; }
  /// The robot's arm is truly in that zone.
  [[nodiscard]] bool isIn(cell::RobotIndex index, cell::ZoneIndex zone);
  /// The place by the robot's own side.
  [[nodiscard]] std::string placeOf(cell::RobotIndex index);
  /// The arm is in motion, and truly in that zone, with its holder's permit.
  bool goesInto(cell::RobotIndex index, cell::ZoneIndex zone);
  /// Of its last goal; 0: it has none.
  [[nodiscard]] int errorOf(cell::RobotIndex index);

  /// Is looked at no more: who is in zones that are not their own. For tests in which arms are moved by
  /// others.
  bool looks_at_zones = true;
  /// What a robot believes that is dead is nothing to anyone.
  std::set<cell::RobotIndex> dead;
  std::shared_ptr<const cell::Artifact> artifact;
  std::unique_ptr<CellTrial> trial;

 private:
  void look();
  void lookAtBeliefs();
  void lookAtBodies();

  cell::CellModel model_;
  std::vector<cell::ZoneWatch> watches_;
  std::vector<std::string> places_;
  Instant looked_at_{};
};

}  // namespace cobot_command::trial
