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

class CycleWriter {
 public:
  CycleWriter(const Artifact& artifact, const CellModel& model, RobotIndex robot)
      : artifact_(artifact), model_(model), robot_(robot), cycle_{robot, {}} {}

  Result<RobotCycle, std::string> write() {
    const RobotProgram& program = model_.program.robots[robot_];
    std::size_t station = program.home;
    for (std::size_t count = 0; count <= program.stations.size(); ++count) {
      const auto path = std::find_if(program.paths.begin(), program.paths.end(),
                                     [station](const PathProgram& one) { return one.from == station; });
      if (path == program.paths.end()) break;
      addPath(static_cast<PathIndex>(path - program.paths.begin()));
      station = path->to;
      if (station == program.home) return std::move(cycle_);
    }
    return refuse(fmt::format("{}: the first path of each station does not lead back home", program.name));
  }

 private:
  void addPath(PathIndex index) {
    const ArtifactPath& path = artifact_.robots[robot_].paths[index];
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
          add(event, path.duration);
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

Result<RobotCycle, std::string> cycleOf(const Artifact& artifact, const CellModel& model, RobotIndex robot) {
  return CycleWriter(artifact, model, robot).write();
}

}  // namespace cobot_command::cell
