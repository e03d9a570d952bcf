// In which namespace the command node of each robot of a cell is, and what moves each mechanism.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cobot_command/cell/program/cell.h"
#include "cobot_command/common/result.h"
#include "cobot_command/common/time.h"

namespace cobot_command::ros_adapter {

/// The namespace that the file says, and of a mechanism, of which it says none, its name: until nothing is
/// heard there. Then that of the node that reports for it. One that is heard keeps its node, so that nobody
/// takes it away by a report.
class MoverNamespaces {
 public:
  /// Refused where the namespace of one is no name of ROS, or that of two.
  [[nodiscard]] static Result<MoverNamespaces, std::string> of(const cell::Cell& cell);

  struct Mover {
    std::string name;
    std::string space;  ///< "/RA"
    bool is_mechanism = false;
    std::optional<Instant> heard;
    std::optional<Instant> moved = std::nullopt;  ///< to another namespace than the cell has
  };
  /// Robots, then mechanisms; both in the order of the cell.
  [[nodiscard]] const std::vector<Mover>& movers() const { return movers_; }

  /// Its joints, or its position, came.
  void heard(std::size_t mover, Instant now) { movers_[mover].heard = now; }
  /// That node, "/RA/command_node", reports for the one of that name. Its index, where it is to be listened
  /// to in another namespace from now on; never in that of another one.
  std::optional<std::size_t> reported(const std::string& name, const std::string& node, Instant now);

 private:
  explicit MoverNamespaces(std::vector<Mover> movers) : movers_(std::move(movers)) {}

  std::vector<Mover> movers_;
};

}  // namespace cobot_command::ros_adapter
