#include "cobot_command/cell/artifact/cycle_times.h"

#include <algorithm>

#include <fmt/format.h>

namespace cobot_command::cell {
namespace {

/// When a zone step happens, since its path began.
Duration timeOf(const ArtifactPath& path, const ZonePlace& place, bool books) {
  const ArtifactFrame& frame = path.frames[place.frame];
  if (books) return frame.begin;
  const ArtifactPiece& piece = path.pieces[place.piece];
  const bool rests = piece.kind == Piece::Kind::Rest;
  return rests ? frame.end : std::min(frame.begin + piece.to, frame.end);
}

/// Nobody knows when a mechanism is where: it may be in its zones until it has arrived.
Duration timeOf(const ArtifactMechanismPath& path, const ZonePlace& /*place*/, bool books) {
  return books ? Duration::zero() : *path.duration;
}

Duration lengthOf(const ArtifactPath& path) {
  return path.duration;
}
Duration lengthOf(const ArtifactMechanismPath& path) {
  return *path.duration;
}

class CycleWriter {
 public:
  CycleWriter(const Artifact& artifact, const CellModel& model, RobotIndex robot)
      : artifact_(artifact), model_(model), robot_(robot), cycle_{robot, {}} {}

  Result<RobotCycle, std::string> write() {
    const RobotProgram& program = model_.program.robots[robot_];
    const auto way = wayHome(program);
    if (!way) {
      return refuse(fmt::format("{}: the first path of each station does not lead back home", program.name));
    }
    for (const PathIndex path : *way) {
      if (robot_ < artifact_.robots.size()) {
        addPath(path, artifact_.robots[robot_].paths[path]);
        continue;
      }
      const auto& of_mechanism = artifact_.mechanisms[robot_ - artifact_.robots.size()].paths[path];
      if (!of_mechanism.duration) {
        return refuse(fmt::format("{}: the duration of {} is unknown: set it in the cell file", program.name,
                                  program.paths[path].name));
      }
      addPath(path, of_mechanism);
    }
    return std::move(cycle_);
  }

 private:
  template <class OfPath>
  void addPath(PathIndex index, const OfPath& path) {
    last_ = Duration::zero();
    std::size_t step = 0;
    for (automata::EventIndex event = 0; event < model_.events.size(); ++event) {
      const CellEvent& meaning = model_.events[event];
      if (meaning.robot != robot_ || meaning.path != index) continue;
      switch (meaning.kind) {
        case CellEvent::Kind::Go:
          add(event, Duration::zero());
          break;
        case CellEvent::Kind::Reached:
          add(event, lengthOf(path));
          break;
        case CellEvent::Kind::Book:
        case CellEvent::Kind::Release:
          add(event, timeOf(path, path.places[step++], meaning.kind == CellEvent::Kind::Book));
          break;
      }
    }
  }

  void add(automata::EventIndex event, Duration at) {
    at = std::max(at, last_);
    cycle_.events.push_back({event, at - last_});
    last_ = at;
  }

  const Artifact& artifact_;
  const CellModel& model_;
  RobotIndex robot_;
  RobotCycle cycle_;
  Duration last_{};
};

}  // namespace

std::optional<std::vector<PathIndex>> wayHome(const RobotProgram& program) {
  std::vector<PathIndex> way;
  std::size_t station = program.home;
  while (way.size() <= program.stations.size()) {
    const auto path = std::find_if(program.paths.begin(), program.paths.end(),
                                   [station](const PathProgram& one) { return one.from == station; });
    if (path == program.paths.end()) return std::nullopt;
    way.push_back(static_cast<PathIndex>(path - program.paths.begin()));
    station = path->to;
    if (station == program.home) return way;
  }
  return std::nullopt;
}

Result<RobotCycle, std::string> cycleOf(const Artifact& artifact, const CellModel& model, RobotIndex robot) {
  return CycleWriter(artifact, model, robot).write();
}

}  // namespace cobot_command::cell
