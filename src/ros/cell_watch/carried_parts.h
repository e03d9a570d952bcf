// What each robot carries, as far as the supervisor's state can be relied on and the measured joints agree.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cobot_command/CellState.h"
#include "cobot_command/arm/types.h"
#include "cobot_command/cell/artifact/artifact.h"
#include "cobot_command/cell/bodies/part_tree.h"
#include "cobot_command/cell/model/cell_model.h"
#include "cobot_command/common/result.h"
#include "cobot_command/common/time.h"

namespace cobot_command::ros_adapter {

/// The state says at which place of its program a robot is, and the artifact what it carries there. That
/// counts only while the robot is measured at that place, the state is younger than the lease, in a mode in
/// which places are certain, and nobody else tells another one. Else nothing is known, and all that the robot
/// may carry is to be taken for carried.
class CarriedParts {
 public:
  /// Faults are sentences: as of cell::modelOf().
  [[nodiscard]] static Result<CarriedParts, std::vector<std::string>> of(
      std::shared_ptr<const cell::Artifact> artifact);

  /// `publisher`: the node that it came from.
  void hear(const cobot_command::CellState& state, const std::string& publisher, Instant now);
  /// Where the robot of that name was measured [rad].
  void measured(const std::string& robot, const arm::JointVector& joints, Instant now);

  /// Whether its program has it carry anything at all.
  [[nodiscard]] bool mayCarry(const std::string& robot) const;

  struct Belief {
    cell::Carried parts;
    Instant until;  ///< if nothing is heard
  };
  /// What it carries by what is known; nothing: nobody can tell.
  [[nodiscard]] std::optional<Belief> beliefOf(const std::string& robot, Instant now) const;

 private:
  struct Robot {
    std::map<std::string, const cell::CellPlace*> places;
    const cell::CellPlace* place = nullptr;  ///< by the state; none: that does not say
    std::optional<Instant> measured;
    arm::JointVector joints;
  };
  /// Whose state is heard, and which one.
  struct Source {
    std::string publisher;
    std::uint64_t instance = 0;
    std::pair<std::uint64_t, std::uint64_t> number;  ///< epoch, and number in it
    Instant heard;
  };

  CarriedParts(std::shared_ptr<const cell::Artifact> artifact, cell::CellModel model);

  [[nodiscard]] std::optional<std::size_t> indexOf(const std::string& robot) const;
  [[nodiscard]] bool isFromAnother(const cobot_command::CellState& state, const std::string& publisher) const;
  void place(const cobot_command::CellState& state);
  [[nodiscard]] std::optional<cell::Carried> partsOf(cell::RobotIndex index, const Robot& robot) const;

  std::shared_ptr<const cell::Artifact> artifact_;
  std::unique_ptr<const cell::CellModel> model_;  ///< stays where it is: places are pointed to
  std::vector<Robot> robots_;                     ///< in the order of the artifact
  std::optional<Source> source_;
  std::optional<Instant> heard_another_;
};

}  // namespace cobot_command::ros_adapter
