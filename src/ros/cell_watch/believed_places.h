// Where each robot and mechanism is in its program, as far as the supervisor's state can be relied on and
// what is measured agrees: so what a robot carries, and what it may do next.
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
#include "cobot_command/cell/monitor/monitor.h"
#include "cobot_command/common/result.h"
#include "cobot_command/common/time.h"

namespace cobot_command::ros_adapter {

/// The state says at which place of its program a robot is, and the artifact what it carries and holds there.
/// That counts only while the robot is measured at that place, the state is younger than the lease, in a mode
/// in which places are certain, and nobody else tells another one. Else nothing is known: all that the robot
/// may carry is to be taken for carried, and it may go anywhere.
class BelievedPlaces {
 public:
  /// Faults are sentences: as of cell::modelOf().
  [[nodiscard]] static Result<BelievedPlaces, std::vector<std::string>> of(
      std::shared_ptr<const cell::Artifact> artifact);

  /// `publisher`: the node that it came from.
  void hear(const cobot_command::CellState& state, const std::string& publisher, Instant now);
  /// Where the robot of that name was measured [rad]; of a mechanism the first one is its position [m or
  /// rad].
  void measured(const std::string& mover, const arm::JointVector& joints, Instant now);

  /// Whether its program has it carry anything at all.
  [[nodiscard]] bool mayCarry(const std::string& robot) const;

  struct Belief {
    cell::Carried parts;  ///< none of a mechanism
    cell::Permit permit;
    Instant until;  ///< if nothing is heard
  };
  /// What is so by what is known; nothing: nobody can tell.
  [[nodiscard]] std::optional<Belief> beliefOf(const std::string& mover, Instant now) const;

 private:
  /// A robot or a mechanism.
  struct Mover {
    std::map<std::string, const cell::CellPlace*> places;
    std::vector<double> most_speeds;         ///< as of Permit, anywhere in its program
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

  BelievedPlaces(std::shared_ptr<const cell::Artifact> artifact, cell::CellModel model);

  [[nodiscard]] std::optional<std::size_t> indexOf(const std::string& mover) const;
  [[nodiscard]] bool isFromAnother(const cobot_command::CellState& state, const std::string& publisher) const;
  void place(const cobot_command::CellState& state);
  [[nodiscard]] std::optional<cell::Carried> partsOf(cell::RobotIndex index, const Mover& mover) const;
  [[nodiscard]] cell::Carried carriedAt(cell::RobotIndex index, const cell::CellPlace& place) const;

  std::shared_ptr<const cell::Artifact> artifact_;
  std::unique_ptr<const cell::CellModel> model_;  ///< stays where it is: places are pointed to
  std::vector<Mover> movers_;                     ///< robots, then mechanisms, as in the program
  std::optional<Source> source_;
  std::optional<Instant> heard_another_;
};

}  // namespace cobot_command::ros_adapter
