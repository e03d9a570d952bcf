// Motions cut before they enter a zone, so that it is booked as late as that saves something (cell.md, M14).
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

/// A cut has to make a hold at least so much shorter.
inline constexpr Duration kLeastSaved = std::chrono::milliseconds(500);

struct CutReport {
  std::string robot;
  std::string path;
  std::size_t step = 0;            ///< of the path as it was given, from 0
  std::size_t behind = 0;          ///< step of the path as it is now, which books
  std::vector<std::string> zones;  ///< that are booked there, and not with the step before it
  double progress = 0.0;           ///< of the way of the step as it was given, 0..1
  Duration saved{};                ///< of holding, when nothing waits
  CutMeasure measure;              ///< deviations are those from the step as it was given
};

/// A cell with cut programs, and all that is made of it: as planCell(), claimCell(), findZones() and
/// holdZones() find it.
struct SplitCell {
  Cell cell;
  std::vector<CutReport> cuts;  ///< by robots, paths and steps
  std::vector<PlannedRobot> planned;
  std::vector<RobotClaim> claims;
  std::vector<Zone> zones;
  HeldCell held;
};

/// Each PTP, line and arc with which a zone is booked is cut at the end of the last piece in front of the
/// first one that touches the zone, where that saves kLeastSaved and the halves keep the path; or some pieces
/// before it, where the pieces of the half are others and touch. Nothing with Split::Never.
///
/// Of the holding that is saved only the time counts by which a robot that nothing stops books later: the
/// second half is sent when the first one begins to slow down.
///
/// The same cell, the same result, on any number of threads. Faults, each a sentence: those of the stages for
/// the cell as it is given.
[[nodiscard]] Result<SplitCell, std::vector<std::string>> splitCell(const Cell& cell, unsigned threads = 1);
/// The same of a cell of which all is made already but for its cuts. Claims are large: they are not copied.
[[nodiscard]] Result<SplitCell, std::vector<std::string>> splitCell(SplitCell whole, unsigned threads);

}  // namespace cobot_command::cell
