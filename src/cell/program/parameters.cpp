#include "cobot_command/cell/program/parameters.h"

#include "cobot_command/common/setting_kinds.h"

namespace cobot_command::cell {

namespace {

constexpr double kMmInM = 1000;
constexpr double kDegreesInRadian = 180 / kPi;

SettingKind length(double& value, double lowest, double highest) {
  return setting_kinds::realIn(value, lowest, highest, "mm", kMmInM);
}

SettingTable geometryRows(Parameters& p) {
  return {
      {"voxel", length(p.voxel, 5, 100),
       "edge of a voxel; the origin of the grid is the origin of the world"},
      {"step_bound", length(p.step_bound, 1, 50), "maximum displacement of a body in one piece of a motion"},
      {"margin", length(p.margin, 0, 200), "least distance of two robots that the zones guarantee"},
      {"tracking", setting_kinds::realIn(p.tracking, 0, 2, "deg", kDegreesInRadian),
       "allowed deviation of each measured joint from the planned path; a larger one is a fault"},
      {"body_tolerance", length(p.body_tolerance, 0, 50),
       "tolerance of bodies, calibration and placement; a real arm differs from the nominal one by 1 to 6 "
       "mm, so use at least 6"},
      {"body_cell", length(p.body_cell, 5, 100), "radius of the capsules that cover a box"},
      {"speed_override", setting_kinds::real(p.speed_override, 0.05, 1),
       "highest project speed for which the claims are valid"}};
}

SettingTable zoneRows(Parameters& p) {
  return {
      {"zone_size", length(p.zone_size, 50, 5000), "a longer zone is split"},
      {"zone_overlap", setting_kinds::real(p.zone_overlap, 0, 1),
       "zones of different robots are merged if they overlap by at least this share of the smaller zone; 1: "
       "never"},
      {"split", setting_kinds::choice<Split>(p.split, {{"auto", Split::Auto}, {"never", Split::Never}}),
       "whether motions are cut before they enter a zone"},
      {"max_zones", setting_kinds::whole(p.max_zones, 1, 65535), "maximum number of zones; more are refused"},
      {"max_states", setting_kinds::whole(p.max_states, 1, 1000000000),
       "maximum number of states of a supervisor; above it, events that affect no other robot are left out, "
       "then safe orders decide; the cell is refused if these cannot decide"}};
}

SettingTable timeRows(Parameters& p) {
  return {{"lease", setting_kinds::seconds(p.lease, 0.1, 10),
           "a robot or supervisor from which no message arrives for longer is lost"},
          {"report_period", setting_kinds::seconds(p.report_period, 0.01, 1),
           "time between reports of a robot; at most half of the lease"},
          {"lookahead", setting_kinds::seconds(p.lookahead, 0, 10),
           "maximum time before a corner at which a booking is requested"},
          {"wait_timeout", setting_kinds::seconds(p.wait_timeout, 1, 3600),
           "if a booking waits for longer, its goal ends"},
          {"aging", setting_kinds::seconds(p.aging, 0, 3600),
           "a robot that has waited for longer is served before later requests"}};
}

}  // namespace

SettingTable parameterTable(Parameters& parameters) {
  return joined({geometryRows(parameters), zoneRows(parameters), timeRows(parameters)});
}

std::string describe(const Parameters& parameters) {
  Parameters shown = parameters;
  std::string text;
  for (const Setting& row : parameterTable(shown)) {
    const std::string unit = row.kind.unit.empty() ? "" : ' ' + row.kind.unit;
    text += row.name + ' ' + row.kind.show() + unit + '\n';
  }
  return text;
}

}  // namespace cobot_command::cell
