// From where to where on its paths a robot or mechanism holds each zone, and the program that follows of that
// (cell.md, M13 to M16).
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

/// On one path. It begins with the frame that enters first, as that is sent only with the zone, and ends
/// behind the last piece that touches it.
struct Hold {
  ZoneIndex zone = 0;
  std::optional<std::size_t> first_frame;  ///< nothing: held since before the path
  std::size_t first_piece = 0;             ///< the first one of that frame
  std::optional<std::size_t> last_piece;   ///< nothing: held at the station behind it, too

  [[nodiscard]] bool covers(std::size_t piece) const {
    return piece >= first_piece && (!last_piece || piece <= *last_piece);
  }
};

/// Where on a path a zone step of its program has its place.
struct ZonePlace {
  std::size_t frame = 0;  ///< a booking: before it is sent
  std::size_t piece = 0;  ///< a release: behind it
};

struct HeldPath {
  std::vector<Hold> holds;
  std::vector<ZonePlace> places;  ///< by step of the path's program
};

struct HeldRobot {
  std::vector<HeldPath> paths;
  std::vector<std::vector<ZoneIndex>> at_stations;  ///< by station: zones that its rest touches, ascending
};

struct HeldCell {
  std::vector<HeldRobot> robots;  ///< then mechanisms
  CellProgram program;
};

/// Faults, each a sentence: a zone that contains the home of a robot without `holds`, or that a robot never
/// leaves.
[[nodiscard]] Result<HeldCell, std::vector<std::string>> holdZones(const Cell& cell,
                                                                   const std::vector<PlannedRobot>& planned,
                                                                   const std::vector<RobotClaim>& claims,
                                                                   const std::vector<Zone>& zones);

}  // namespace cobot_command::cell
