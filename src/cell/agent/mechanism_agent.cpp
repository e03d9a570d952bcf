#include "cobot_command/cell/agent/mechanism_agent.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>
#include <vector>

#include "agent/program_walk.h"
#include "agent/report_head.h"
#include "agent/state_watch.h"
#include <fmt/format.h>

#include "cobot_command/cell/artifact/place_fit.h"
#include "cobot_command/common/foreign_text.h"

namespace cobot_command::cell {
namespace {

/// The first measurement may be of before what has just changed.
constexpr int kMeasurementsInARow = 2;

}  // namespace

class MechanismAgent::Parts {
 public:
  Parts(std::shared_ptr<const Artifact> artifact, CellModel model, RobotIndex user, std::uint64_t session)
      : artifact_(std::move(artifact)),
        model_(std::move(model)),
        user_(user),
        session_(session),
        walk_(model_, user),
        states_(program().name, session, artifact_->digest, artifact_->parameters.lease) {}

  void measure(double position, bool moving, Instant now);
  void hear(const CellStatus& state, std::uint64_t number, Instant now);
  void run(bool on) {
    is_running_ = on;
    goOn();
  }
  /// Until it was recovered.
  void stop() {
    is_stopped_ = true;
    stop_report_ = report_number_ + 1;
    stays_at_ = position_;
    has_news_ = true;
  }
  [[nodiscard]] std::optional<double> target() const;
  [[nodiscard]] std::optional<RobotReport> takeReport(Instant now);
  [[nodiscard]] Instant nextReport() const {
    return reported_at_ ? *reported_at_ + artifact_->parameters.report_period : Instant{};
  }
  [[nodiscard]] const std::string& place() const { return walk_.place().name; }
  [[nodiscard]] int cyclesDone() const { return cycles_done_; }

 private:
  [[nodiscard]] const RobotProgram& program() const { return artifact_->program.robots[user_]; }
  [[nodiscard]] const ArtifactMechanism& made() const {
    return artifact_->mechanisms[user_ - artifact_->robots.size()];
  }
  void goOn();
  /// False: there is nothing more that can be said of its program now.
  [[nodiscard]] bool goOnAtStation();
  [[nodiscard]] bool goOnPath();
  void tell(automata::EventIndex event, bool is_asked_for);
  /// The piece of the path that it is on, by its position; nothing: on none.
  [[nodiscard]] std::optional<std::size_t> piece() const;
  [[nodiscard]] bool isAt(std::size_t station) const;
  [[nodiscard]] bool isWhereItHasToBe() const;
  [[nodiscard]] std::set<ZoneIndex> zonesAnywhere() const;
  [[nodiscard]] std::vector<std::uint32_t> touched() const;
  [[nodiscard]] RobotCondition condition() const;
  /// On its path it turned round, or was put back.
  [[nodiscard]] bool hasGoneBack() const;
  /// From the beginning of its path [m or rad].
  [[nodiscard]] double progress() const;
  void follow();
  void forgetProgress();
  [[nodiscard]] bool mayMove() const { return joins_ && !rests_ && condition() == RobotCondition::Ok; }
  void restart(const RobotStatus& mine);

  std::shared_ptr<const Artifact> artifact_;
  CellModel model_;
  RobotIndex user_;
  std::uint64_t session_;
  ProgramWalk walk_;
  StateWatch states_;
  std::optional<std::uint32_t> joins_;  ///< known to have been let in so often
  std::optional<double> position_;
  std::optional<Instant> measured_at_;
  bool is_moving_ = true;
  int behind_ = 0;                  ///< measurements in a row by which the next event has happened
  int off_path_ = 0;                ///< measurements in a row by which it is where it may not be
  std::optional<double> stays_at_;  ///< where it is since it may not go on
  std::optional<double> farthest_;  ///< progress on its path
  std::optional<double> last_;      ///< the same as measured last
  bool rests_ = false;              ///< it was recovered while the cell was held
  bool is_stopped_ = false;
  std::uint64_t stop_report_ = 0;  ///< the first that told of the stop
  bool is_running_ = false;
  int cycles_done_ = 0;
  std::uint64_t report_number_ = 0;
  std::optional<Instant> reported_at_;
  bool has_news_ = true;
};

Result<std::unique_ptr<MechanismAgent>, std::string> MechanismAgent::of(
    std::shared_ptr<const Artifact> artifact, const std::string& mechanism, std::uint64_t session) {
  const auto& users = artifact->program.robots;
  const auto first = users.begin() + static_cast<std::ptrdiff_t>(artifact->robots.size());
  const auto found =
      std::find_if(first, users.end(), [&](const RobotProgram& user) { return user.name == mechanism; });
  if (found == users.end()) {
    std::vector<std::string> names;
    for (auto user = first; user != users.end(); ++user) names.push_back(user->name);
    return refuse(fmt::format("the artifact has no mechanism \"{}\"; it has {}",
                              foreignText(mechanism, kQuoteLimit),
                              names.empty() ? "none" : fmt::format("{}", fmt::join(names, ", "))));
  }
  auto model = modelOf(artifact->program);
  if (!model) return refuse(model.error().front());
  const auto user = static_cast<RobotIndex>(found - users.begin());
  return std::unique_ptr<MechanismAgent>(
      new MechanismAgent(std::make_unique<Parts>(std::move(artifact), std::move(*model), user, session)));
}

MechanismAgent::MechanismAgent(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}
MechanismAgent::~MechanismAgent() = default;

void MechanismAgent::measure(double position, bool moving, Instant now) {
  parts_->measure(position, moving, now);
}
void MechanismAgent::hear(const CellStatus& state, std::uint64_t number, Instant now) {
  parts_->hear(state, number, now);
}
void MechanismAgent::run(bool on) {
  parts_->run(on);
}
void MechanismAgent::stop() {
  parts_->stop();
}
std::optional<double> MechanismAgent::target() const {
  return parts_->target();
}
std::optional<RobotReport> MechanismAgent::takeReport(Instant now) {
  return parts_->takeReport(now);
}
Instant MechanismAgent::nextReport() const {
  return parts_->nextReport();
}
const std::string& MechanismAgent::place() const {
  return parts_->place();
}
int MechanismAgent::cyclesDone() const {
  return parts_->cyclesDone();
}

// --- What happens.

void MechanismAgent::Parts::measure(double position, bool moving, Instant now) {
  if (!std::isfinite(position)) return;  // it becomes old, and in the end lost
  const bool was_silent = measured_at_ && now - *measured_at_ > artifact_->parameters.lease;
  position_ = position;
  measured_at_ = now;
  is_moving_ = moving;
  off_path_ = isWhereItHasToBe() ? 0 : off_path_ + 1;
  // What was heard before it fell silent tells nothing of the first that is heard again.
  if (off_path_ != 0 && was_silent) off_path_ = std::max(off_path_, kMeasurementsInARow);
  if (off_path_ == kMeasurementsInARow) has_news_ = true;
  // Whoever moves it: it is never told to go back.
  const bool has_moved = !stays_at_ || std::abs(position - *stays_at_) > kMechanismWithin;
  if (mayMove() || moving || has_moved) stays_at_ = position;
  if (off_path_ == 0) follow();
  ++behind_;
  goOn();
}

void MechanismAgent::Parts::hear(const CellStatus& state, std::uint64_t number, Instant now) {
  if (!states_.hear(state, number, now)) return;
  const RobotStatus* const mine = states_.mine();
  if (mine == nullptr || mine->session != session_ || mine->state == RobotState::Out) {
    if (joins_) stays_at_ = position_;
    joins_.reset();
  } else if (joins_ != mine->joins) {
    restart(*mine);
  }
  const bool is_let_go_on =
      states_.mode() == SupervisorMode::Ready || states_.mode() == SupervisorMode::Running;
  // What is granted counts while the supervisor knows how things stand, and lets the cell go on.
  if (joins_ && is_let_go_on && !states_.objection(now)) walk_.acknowledge(mine->acknowledged);
  if (is_let_go_on) rests_ = false;
  goOn();
}

/// It was let in, or a person has said where it is. On its way it does not go on before the cell does.
void MechanismAgent::Parts::restart(const RobotStatus& mine) {
  if (walk_.restart(mine.place, mine.acknowledged)) off_path_ = 0;
  // A stop that came after what this answers counts.
  if (mine.report >= stop_report_) is_stopped_ = false;
  rests_ = !walk_.place().station;
  stays_at_ = position_;
  forgetProgress();
  joins_ = mine.joins;
  has_news_ = true;
}

void MechanismAgent::Parts::goOn() {
  if (!position_ || !mayMove()) return;
  while (!walk_.waits() && (walk_.place().station ? goOnAtStation() : goOnPath())) has_news_ = true;
}

bool MechanismAgent::Parts::goOnAtStation() {
  if (!is_running_) return false;
  const std::size_t station = *walk_.place().station;
  const auto& paths = program().paths;
  const auto path =
      std::find_if(paths.begin(), paths.end(), [&](const PathProgram& one) { return one.from == station; });
  if (path == paths.end()) return false;
  tell(walk_.goOf(static_cast<PathIndex>(path - paths.begin())), !path->uncontrollable_go);
  return true;
}

bool MechanismAgent::Parts::goOnPath() {
  const automata::EventIndex event = walk_.next();
  const CellPlace& where = walk_.place();
  const PathProgram& path = program().paths[where.path];
  const auto kind = walk_.meaning(event).kind;
  if (kind == CellEvent::Kind::Book) {
    tell(event, !path.steps[where.behind].uncontrollable);
    return true;
  }
  const auto passed = piece();
  const bool has_happened = kind == CellEvent::Kind::Reached
                                ? !is_moving_ && isAt(path.to)
                                : passed && *passed > made().paths[where.path].places[where.behind].piece;
  if (!has_happened) behind_ = 0;
  if (behind_ < kMeasurementsInARow) return false;
  tell(event, false);
  if (walk_.place().station == program().home) ++cycles_done_;
  return true;
}

void MechanismAgent::Parts::tell(automata::EventIndex event, bool is_asked_for) {
  behind_ = 0;
  if (walk_.place().station) forgetProgress();
  if (is_asked_for) {
    walk_.want(event);
  } else {
    walk_.happened(event);
  }
}

// --- Where it is.

std::optional<std::size_t> MechanismAgent::Parts::piece() const {
  const auto& pieces = made().paths[walk_.place().path].pieces;
  const bool has_arrived = isAt(program().paths[walk_.place().path].to);
  if (has_arrived && !is_moving_) return pieces.size() - 1;
  // Of two pieces that meet the first: a zone is given back late rather than early.
  for (std::size_t piece = 0; piece < pieces.size(); ++piece) {
    const auto [low, high] = std::minmax(pieces[piece].from, pieces[piece].to);
    if (*position_ >= low && *position_ <= high) return piece;
  }
  return has_arrived ? std::optional(pieces.size() - 1) : std::nullopt;
}

bool MechanismAgent::Parts::isAt(std::size_t station) const {
  return std::abs(*position_ - made().stations[station].value) <= kMechanismWithin;
}

bool MechanismAgent::Parts::isWhereItHasToBe() const {
  arm::JointVector joints = arm::JointVector::Zero();
  joints[0] = *position_;
  return !joins_ || (placeFits(*artifact_, user_, walk_.place(), joints) && !hasGoneBack());
}

/// One measurement that is far ahead may be wrong: it counts with the next one.
void MechanismAgent::Parts::follow() {
  if (walk_.place().station) return forgetProgress();
  const double now = progress();
  const double sure = std::min(now, last_.value_or(now));
  farthest_ = std::max(sure, farthest_.value_or(sure));
  last_ = now;
}

void MechanismAgent::Parts::forgetProgress() {
  farthest_.reset();
  last_.reset();
}

bool MechanismAgent::Parts::hasGoneBack() const {
  return farthest_ && !walk_.place().station && progress() < *farthest_ - kMechanismWithin;
}

double MechanismAgent::Parts::progress() const {
  const PathProgram& path = program().paths[walk_.place().path];
  const double from = made().stations[path.from].value;
  return std::copysign(1.0, made().stations[path.to].value - from) * (*position_ - from);
}

/// Where it is not where its program is, whatever it may be in by its position; by none that its paths pass,
/// in all that it uses.
std::set<ZoneIndex> MechanismAgent::Parts::zonesAnywhere() const {
  std::set<ZoneIndex> here;
  std::set<ZoneIndex> all;
  const auto add = [&](double from, double to, const std::vector<ZoneIndex>& zones) {
    all.insert(zones.begin(), zones.end());
    const bool is_in = *position_ >= std::min(from, to) - kMechanismWithin &&
                       *position_ <= std::max(from, to) + kMechanismWithin;
    if (is_in) here.insert(zones.begin(), zones.end());
    return is_in;
  };
  bool is_anywhere = false;
  for (const ArtifactPosition& station : made().stations) {
    is_anywhere = add(station.value, station.value, station.zones) || is_anywhere;
  }
  for (const ArtifactMechanismPath& path : made().paths) {
    for (const ArtifactAxisPiece& piece : path.pieces) {
      is_anywhere = add(piece.from, piece.to, piece.zones) || is_anywhere;
    }
  }
  return is_anywhere ? here : all;
}

std::vector<std::uint32_t> MechanismAgent::Parts::touched() const {
  const bool is_on_its_way = joins_ && off_path_ == 0;
  if (is_on_its_way && walk_.place().station) {
    const auto& zones = made().stations[*walk_.place().station].zones;
    return {zones.begin(), zones.end()};
  }
  if (const auto at = is_on_its_way ? piece() : std::nullopt) {
    const auto& zones = made().paths[walk_.place().path].pieces[*at].zones;
    return {zones.begin(), zones.end()};
  }
  const auto zones = zonesAnywhere();
  return {zones.begin(), zones.end()};
}

// --- What follows.

std::optional<double> MechanismAgent::Parts::target() const {
  if (!position_) return std::nullopt;
  if (!mayMove()) return stays_at_;
  const CellPlace& place = walk_.place();
  if (place.station) return made().stations[*place.station].value;
  const PathProgram& path = program().paths[place.path];
  const bool has_booked = walk_.meaning(walk_.next()).kind != CellEvent::Kind::Book;
  return made().stations[has_booked ? path.to : path.from].value;
}

RobotCondition MechanismAgent::Parts::condition() const {
  if (off_path_ >= kMeasurementsInARow) return RobotCondition::OffPath;
  return is_stopped_ ? RobotCondition::Stopped : RobotCondition::Ok;
}

std::optional<RobotReport> MechanismAgent::Parts::takeReport(Instant now) {
  if (!position_ || (!has_news_ && now < nextReport())) return std::nullopt;
  // Nobody knows where it is any more: it falls silent, as what it would tell may be wrong.
  if (now - *measured_at_ > artifact_->parameters.lease) return std::nullopt;
  RobotReport report = headOf(program().name, *artifact_, session_, states_, walk_);
  report.number = ++report_number_;
  states_.told(report.number, now);
  report.joints[0] = *position_;
  report.status_age = toSeconds(now - *measured_at_);
  report.condition = condition();
  report.moving = is_moving_;
  report.touched_zones = touched();
  reported_at_ = now;
  has_news_ = false;
  return report;
}

}  // namespace cobot_command::cell
