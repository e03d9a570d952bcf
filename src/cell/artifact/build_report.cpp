// What the stages of a build found, for people.
#include <algorithm>

#include <fmt/format.h>

#include "cobot_command/cell/artifact/cell_build.h"
#include "cobot_command/cell/artifact/cycle_times.h"
#include "cobot_command/common/units.h"

namespace cobot_command::cell {

namespace {

std::vector<std::string> linesOf(const std::vector<CutReport>& cuts) {
  if (cuts.empty()) return {"no motion is cut"};
  std::vector<std::string> lines;
  lines.reserve(cuts.size());
  for (const CutReport& cut : cuts) {
    lines.push_back(fmt::format("{} {}, step {}: cut at {:.0f} % before {}, which saves {:.2f} s of holding",
                                cut.robot, cut.path, cut.step + 1, 100.0 * cut.progress,
                                fmt::join(cut.zones, ", "), toSeconds(cut.saved)));
  }
  return lines;
}

std::vector<std::string> linesOf(const Soundness& soundness, double margin) {
  std::vector<std::string> lines{
      fmt::format("{} pairs of pieces that no zone separates; least distance {:.1f} mm, margin {:.1f} mm",
                  soundness.pairs, mToMm(soundness.least), mToMm(margin))};
  if (!soundness.worst.empty()) lines.push_back("the worst: " + soundness.worst);
  return lines;
}

std::vector<std::string> linesOf(const std::vector<automata::Verification>& verified) {
  std::vector<std::string> lines;
  lines.reserve(verified.size());
  for (const auto& part : verified) {
    lines.push_back(fmt::format(
        "{} states of plants and specs, {} dead, {} blocking; {} reached, {} refused by zones and "
        "{} beyond: as synthesized",
        part.counts.plant_and_spec, part.counts.dead, part.counts.blocking, part.counts.states,
        part.counts.refused_by_spec, part.counts.refused_beyond_spec));
  }
  return lines;
}

}  // namespace

std::vector<std::string> CellBuild::report(BuildStage stage) const {
  switch (stage) {
    case BuildStage::Plan:
      return reportPlan();
    case BuildStage::Sweep:
      return reportSweep();
    case BuildStage::Zones:
      return reportZones();
    case BuildStage::Split:
      return linesOf(cuts_);
    case BuildStage::Soundness:
      return linesOf(soundness_, cell_.parameters.margin);
    case BuildStage::Instrument:
      return {fmt::format("{} events, {} automata", model_.events.size(), model_.problem.automata.size())};
    case BuildStage::Synthesize:
      return reportSupervisors();
    case BuildStage::Verify:
      return linesOf(verified_);
  }
  return {};
}

std::vector<std::string> CellBuild::reportPlan() const {
  std::vector<std::string> lines;
  for (const PlannedRobot& robot : planned_) {
    std::size_t frames = 0;
    Duration all{};
    for (const PlannedPath& path : robot.paths) {
      frames += path.frames.size();
      all += path.duration;
    }
    lines.push_back(fmt::format("{}: {} paths, {} frames, {:.1f} s in all", robot.name, robot.paths.size(),
                                frames, toSeconds(all)));
  }
  for (const Mechanism& mechanism : cell_.mechanisms) {
    const auto stations = stationsOf(mechanism);
    const auto [low, high] = std::minmax_element(
        stations.begin(), stations.end(), [](const auto& a, const auto& b) { return a.value < b.value; });
    const bool turns = mechanism.axis == Mechanism::Axis::Revolute;
    const auto shown = [turns](double value) { return turns ? radToDeg(value) : mToMm(value); };
    lines.push_back(fmt::format("{}: a mechanism, {} paths between {} positions, {:.1f} to {:.1f} {}",
                                mechanism.name, mechanism.program.size(), stations.size(), shown(low->value),
                                shown(high->value), turns ? "deg" : "mm"));
  }
  return lines;
}

std::vector<std::string> CellBuild::reportSweep() const {
  std::vector<std::string> lines;
  const double edge = 1000.0 * cell_.parameters.voxel / 100.0;  // [dm], so that its cube is in litres
  for (const RobotClaim& claim : claims_) {
    lines.push_back(fmt::format("{}: {} pieces, {} voxels, {:.1f} l", claim.name, claim.pieces(),
                                claim.all.count(),
                                edge * edge * edge * static_cast<double>(claim.all.count())));
  }
  lines.push_back(fmt::format("a claimed point is at most {:.1f} mm from a position that a body reaches",
                              mToMm(claimError(cell_.parameters))));
  return lines;
}

std::vector<std::string> CellBuild::reportZones() const {
  std::vector<std::string> lines;
  for (const Zone& zone : zones_) {
    std::vector<std::string> users;
    for (const RobotIndex user : zone.users) users.push_back(claims_[user].name);
    lines.push_back(fmt::format("{} of {}: {} voxels, {}", zone.name, fmt::join(users, " and "),
                                zone.voxels.count(), boxOf(zone, cell_.parameters.voxel)));
  }
  for (const RobotProgram& robot : held_.program.robots) {
    for (const PathProgram& path : robot.paths) {
      std::string line = fmt::format("{} {}{}:", robot.name, path.name,
                                     path.uncontrollable_go ? " (starts automatically)" : "");
      for (const ZoneStep& step : path.steps) {
        line += step.uncontrollable ? " enter automatically" : step.books ? " book" : " release";
        for (const ZoneIndex zone : step.zones) line += " " + held_.program.zones[zone];
        line += ",";
      }
      if (line.back() == ',') line.pop_back();
      lines.push_back(path.steps.empty() ? line + " no zone" : line);
    }
  }
  if (zones_.empty()) lines.emplace_back("no zones: the robots never come near each other");
  return lines;
}

std::vector<std::string> CellBuild::reportSupervisors() const {
  std::vector<std::string> lines;
  for (const PartSupervisor& part : supervisors_) {
    std::vector<std::string> robots;
    for (const std::size_t automaton : part.automata) {
      if (automaton < model_.robots()) robots.push_back(model_.program.robots[automaton].name);
    }
    if (part.policy != Policy::Supervisor) {
      lines.push_back(
          fmt::format("{}: {}{}", fmt::join(robots, ", "), toString(part.policy),
                      policy_ == Policy::Supervisor
                          ? fmt::format(" decides without a table, and refuses slightly more than a "
                                        "supervisor: a supervisor has more than max_states = {} states",
                                        cell_.parameters.max_states)
                          : std::string()));
      continue;
    }
    lines.push_back(
        fmt::format("{}: {} states, {} transitions{}; avoids {} states; refuses {} by zones, {} beyond",
                    fmt::join(robots, ", "), part.counts.states, part.counts.transitions,
                    part.is_compressed ? " (compressed)" : "", part.counts.frontier,
                    part.counts.refused_by_spec, part.counts.refused_beyond_spec));
    if (part.never.empty()) continue;
    lines.push_back(fmt::format(
        "  {} never happens: paths that contain it are never taken, because no sequence would lead home",
        fmt::join(part.never, ", ")));
  }
  for (const RobotProgram& robot : model_.program.robots) {
    if (wayHome(robot)) continue;
    lines.push_back(
        fmt::format("{}: the first path of each station does not lead back home: without `paths` it never "
                    "ends a cycle, unless another robot blocks its path; list another path first",
                    robot.name));
  }
  lines.push_back(fmt::format("{} bytes", bytes_.size()));
  return lines;
}

}  // namespace cobot_command::cell
