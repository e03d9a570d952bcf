// The parameters of a cell (doc/cell.md). Each has a row, by which it is read, checked, echoed and
// documented.
#pragma once

#include <string>

#include "cobot_command/common/setting.h"
#include "cobot_command/common/time.h"
#include "cobot_command/common/units.h"

namespace cobot_command::cell {

/// Whether motions are cut before they enter a zone.
enum class Split { Auto, Never };

/// In SI [m, rad, s]; files have mm and degrees. The rows of parameterTable() have the meanings.
struct Parameters {
  double voxel = 0.02;
  double step_bound = 0.01;
  double margin = 0.02;
  double tracking = degToRad(0.1);
  double body_tolerance = 0.0;
  double body_cell = 0.03;
  double speed_override = 1.0;
  double zone_size = 1.0;
  double zone_overlap = 0.5;
  Split split = Split::Auto;
  int max_zones = 256;
  int max_states = 5000000;
  Duration lease = std::chrono::milliseconds(500);
  Duration report_period = std::chrono::milliseconds(50);
  Duration lookahead = std::chrono::milliseconds(500);
  Duration wait_timeout = std::chrono::seconds(60);
  Duration aging = std::chrono::seconds(10);
};

/// Name, range, unit and meaning of each, bound to `parameters`, which must outlive the table.
[[nodiscard]] SettingTable parameterTable(Parameters& parameters);

/// All of them as reports echo them, one line each: "voxel 20 mm".
[[nodiscard]] std::string describe(const Parameters& parameters);

}  // namespace cobot_command::cell
