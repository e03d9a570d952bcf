// The part of its paths on which a robot or mechanism holds each zone, and the resulting program
// (doc/cell.md).
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "cobot_command/cell/claims/claims.h"
#include "cobot_command/cell/model/cell_program.h"
#include "cobot_command/cell/plan/planned_cell.h"
#include "cobot_command/cell/zones/zones.h"
#include "cobot_command/common/result.h"

namespace cobot_command::cell {

/// The hold of a zone on one path. It starts with the first frame that enters the zone, because this frame is
/// sent only if the robot holds the zone. It ends after the last piece that touches the zone.
struct Hold {
  ZoneIndex zone = 0;
  std::optional<std::size_t> first_frame;  ///< std::nullopt: held since before the path
  std::size_t first_piece = 0;             ///< the first piece of that frame
  std::optional<std::size_t> last_piece;   ///< std::nullopt: also held at the station after it

  [[nodiscard]] bool covers(std::size_t piece) const {
    return piece >= first_piece && (!last_piece || piece <= *last_piece);
  }
};

/// The position of a zone step on its path.
struct ZonePlace {
  std::size_t frame = 0;  ///< a booking: before this frame is sent
  std::size_t piece = 0;  ///< a release: after this piece
};

struct HeldPath {
  std::vector<Hold> holds;
  std::vector<ZonePlace> places;  ///< by step of the path's program
};

struct HeldRobot {
  std::vector<HeldPath> paths;
  std::vector<std::vector<ZoneIndex>> at_stations;  ///< [station]: zones that its rest touches, ascending
};

struct HeldCell {
  std::vector<HeldRobot> robots;  ///< then mechanisms
  CellProgram program;
};

/// Faults, one sentence each: a zone that contains the home of a robot without `holds`, or that a robot never
/// leaves.
[[nodiscard]] Result<HeldCell, std::vector<std::string>> holdZones(const Cell& cell,
                                                                   const std::vector<PlannedRobot>& planned,
                                                                   const std::vector<RobotClaim>& claims,
                                                                   const std::vector<Zone>& zones);

}  // namespace cobot_command::cell
