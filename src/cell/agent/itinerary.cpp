#include "agent/itinerary.h"

#include <algorithm>
#include <cassert>

#include <fmt/format.h>

#include "cobot_command/common/foreign_text.h"

namespace cobot_command::cell {
namespace {

std::optional<PathIndex> pathNamed(const RobotProgram& program, const std::string& name) {
  for (PathIndex path = 0; path < program.paths.size(); ++path) {
    if (program.paths[path].name == name) return path;
  }
  return std::nullopt;
}

std::string namesOf(const RobotProgram& program) {
  std::vector<std::string> names;
  names.reserve(program.paths.size());
  for (const PathProgram& path : program.paths) names.push_back(path.name);
  return fmt::format("{}", fmt::join(names, ", "));
}

}  // namespace

std::optional<std::string> Itinerary::objectionTo(const RobotProgram& program,
                                                  const blocks::ProgramRequest& request) {
  std::optional<PathIndex> before;
  for (const std::string& name : request.paths) {
    const auto path = pathNamed(program, name);
    if (!path) {
      return fmt::format("the program of {} has no path \"{}\"; it has {}", program.name,
                         foreignText(name, kQuoteLimit), namesOf(program));
    }
    if (before && program.paths[*before].to != program.paths[*path].from) {
      return fmt::format("path {} starts at {}, but {} ends at {}", name,
                         program.stations[program.paths[*path].from], program.paths[*before].name,
                         program.stations[program.paths[*before].to]);
    }
    before = path;
  }
  if (request.paths.empty() || request.cycles == 1) return std::nullopt;
  const PathProgram& first = program.paths[*pathNamed(program, request.paths.front())];
  if (program.paths[*before].to == first.from) return std::nullopt;
  return fmt::format("paths for more than one cycle must form a loop: {} starts at {}, but {} ends at {}",
                     first.name, program.stations[first.from], program.paths[*before].name,
                     program.stations[program.paths[*before].to]);
}

std::optional<std::string> Itinerary::begin(const blocks::ProgramRequest& request, std::size_t station,
                                            std::optional<PathIndex> under_way) {
  std::vector<PathIndex> paths;
  for (const std::string& name : request.paths) paths.push_back(*pathNamed(*program_, name));
  if (!paths.empty() && under_way && paths.front() != *under_way) {
    return fmt::format("the robot is on path {}, not on {}", program_->paths[*under_way].name,
                       request.paths.front());
  }
  if (!paths.empty() && !under_way && program_->paths[paths.front()].from != station) {
    return fmt::format("the robot is at {}, but {} starts at {}", program_->stations[station],
                       request.paths.front(), program_->stations[program_->paths[paths.front()].from]);
  }
  paths_ = std::move(paths);
  next_ = under_way && !paths_.empty() ? 1 : 0;
  cycles_ = request.cycles;
  cycles_done_ = 0;
  tried_ = 0;
  is_between_ = !under_way;
  is_over_ = false;
  return std::nullopt;
}

std::vector<PathIndex> Itinerary::pathsFrom(std::size_t station) const {
  std::vector<PathIndex> paths;
  for (PathIndex path = 0; path < program_->paths.size(); ++path) {
    if (program_->paths[path].from == station) paths.push_back(path);
  }
  return paths;
}

bool Itinerary::hasOthers(std::size_t station) const {
  return paths_.empty() && pathsFrom(station).size() > 1;
}

PathIndex Itinerary::next(std::size_t station) const {
  assert(!is_over_);
  if (!paths_.empty()) return paths_[next_ % paths_.size()];
  const auto paths = pathsFrom(station);
  return paths[tried_ % paths.size()];
}

void Itinerary::setOut() {
  tried_ = 0;
  ++next_;
  is_between_ = false;
}

void Itinerary::reached(std::size_t station) {
  if (is_over_) return;
  is_between_ = paths_.empty() ? station == program_->home : next_ % paths_.size() == 0;
  if (!is_between_) return;
  ++cycles_done_;
  is_over_ = cycles_ != 0 && cycles_done_ >= cycles_;
}

void Itinerary::finish() {
  is_over_ = is_over_ || is_between_;
  cycles_ = cycles_done_ + 1;
}

}  // namespace cobot_command::cell
