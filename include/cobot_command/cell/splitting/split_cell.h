// Cuts motions before they enter a zone, so that the zone is booked later if that saves time (doc/cell.md).
//
// SI [m, rad].
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "cobot_command/cell/claims/claims.h"
#include "cobot_command/cell/plan/planned_cell.h"
#include "cobot_command/cell/plan/step_cut.h"
#include "cobot_command/cell/program/cell.h"
#include "cobot_command/cell/zones/holds.h"
#include "cobot_command/cell/zones/zones.h"
#include "cobot_command/common/result.h"
#include "cobot_command/common/time.h"

namespace cobot_command::cell {

/// A cut must shorten a hold by at least this time.
inline constexpr Duration kLeastSaved = std::chrono::milliseconds(500);

struct CutReport {
  std::string robot;
  std::string path;
  std::size_t step = 0;            ///< of the given path, from 0
  std::size_t behind = 0;          ///< step of the resulting path that books
  std::vector<std::string> zones;  ///< booked there, and not with the step before it
  double progress = 0.0;           ///< share of the path of the given step, 0..1
  Duration saved{};                ///< holding time, without waiting
  CutMeasure measure;              ///< deviations from the given step
};

/// A cell with cut programs, and all results for it: as from planCell(), claimCell(), findZones() and
/// holdZones().
struct SplitCell {
  Cell cell;
  std::vector<CutReport> cuts;  ///< by robots, paths and steps
  std::vector<PlannedRobot> planned;
  std::vector<RobotClaim> claims;
  std::vector<Zone> zones;
  HeldCell held;
};

/// Cuts each PTP, line and arc that books a zone at the end of the last piece before the first piece that
/// touches the zone, if that saves kLeastSaved and the halves keep the path. The cut is some pieces earlier
/// if the pieces of the half differ and touch the zone. No cuts with Split::Never.
///
/// Only the time by which an unhindered robot books later counts as saved holding time: the second half is
/// sent when the first one starts to decelerate.
///
/// The same cell gives the same result on any number of threads. Faults, one sentence each: those of the
/// stages for the given cell.
[[nodiscard]] Result<SplitCell, std::vector<std::string>> splitCell(const Cell& cell, unsigned threads = 1);
/// The same for a cell with all results except the cuts. Claims are large and are not copied.
[[nodiscard]] Result<SplitCell, std::vector<std::string>> splitCell(SplitCell whole, unsigned threads);

}  // namespace cobot_command::cell
