// A cell of config/cells, with all that is made of it up to its program.
#pragma once

#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "source_tree.h"

#include "cobot_command/cell/claims/claims.h"
#include "cobot_command/cell/plan/planned_cell.h"
#include "cobot_command/cell/program/cell_file.h"
#include "cobot_command/cell/zones/holds.h"
#include "cobot_command/cell/zones/zones.h"

namespace cobot_command::cell {

inline Cell readCell(const std::string& text) {
  auto cell = parseCell(text, "cell.yaml",
                        [](const std::string&) { return refuse(std::string("there are no other files")); });
  if (!cell) throw std::runtime_error(describe(cell.error().front()));
  return *cell;
}

/// As the oracles have them: joints are followed exactly, and motions not cut.
inline Cell cellOf(const std::string& name) {
  std::stringstream text;
  text << std::ifstream(test_support::inSourceTree("config/cells/" + name + ".yaml")).rdbuf();
  Cell cell = readCell(text.str());
  cell.parameters.tracking = 0.0;
  cell.parameters.split = Split::Never;
  return cell;
}

template <class Value, class Faults>
Value orThrow(Result<Value, Faults> result) {
  if (result) return std::move(*result);
  if constexpr (std::is_same_v<Faults, std::string>) {
    throw std::runtime_error(result.error());
  } else if constexpr (std::is_same_v<Faults, std::vector<std::string>>) {
    throw std::runtime_error(result.error().front());
  } else {
    throw std::runtime_error(describe(result.error().front()));
  }
}

struct ZonedCell {
  explicit ZonedCell(Cell of)
      : cell(std::move(of)),
        planned(orThrow(planCell(cell))),
        claims(orThrow(claimCell(cell, planned))),
        zones(orThrow(findZones(claims, cell.parameters))),
        held(orThrow(holdZones(cell, planned, claims, zones))) {}

  /// In litres.
  [[nodiscard]] double volume(const VoxelSet& voxels) const {
    const double edge = cell.parameters.voxel;
    return 1000.0 * edge * edge * edge * static_cast<double>(voxels.count());
  }
  /// Where on its motion a piece ends or begins, 0..1 of the way in joints of a frame with one motion.
  [[nodiscard]] double progress(RobotIndex robot, std::size_t path, const Piece& piece, Duration when) const {
    return planned[robot].paths[path].frames[piece.frame].motions[piece.motion].trajectory->progress(when);
  }

  Cell cell;
  std::vector<PlannedRobot> planned;
  std::vector<RobotClaim> claims;
  std::vector<Zone> zones;
  HeldCell held;
};

}  // namespace cobot_command::cell
