#include "cobot_command/cell/agent/agent.h"

#include <algorithm>
#include <utility>

#include "agent/agent_parts.h"
#include "agent/frame_gate.h"
#include "agent/report_head.h"
#include <fmt/format.h>

#include "cobot_command/blocks/shared/error_ids.h"
#include "cobot_command/cell/artifact/place_fit.h"
#include "cobot_command/common/foreign_text.h"

namespace cobot_command::cell {

Result<std::shared_ptr<Agent>, std::string> Agent::of(std::shared_ptr<const Artifact> artifact,
                                                      const std::string& robot, std::uint64_t session) {
  const auto& robots = artifact->program.robots;
  const auto found = std::find_if(robots.begin(), robots.end(),
                                  [&](const RobotProgram& program) { return program.name == robot; });
  if (found == robots.end()) {
    std::vector<std::string> names;
    names.reserve(robots.size());
    for (const RobotProgram& program : robots) names.push_back(program.name);
    return refuse(fmt::format("the artifact has no robot \"{}\"; it has {}", foreignText(robot, kQuoteLimit),
                              fmt::join(names, ", ")));
  }
  const auto index = static_cast<RobotIndex>(found - robots.begin());
  auto model = modelOf(artifact->program);
  if (!model) return refuse(model.error().front());
  auto zones = ZoneWatch::of(*artifact, index);
  if (!zones) return refuse(zones.error());
  return std::shared_ptr<Agent>(new Agent(
      std::make_unique<Parts>(std::move(artifact), std::move(*model), index, session, std::move(*zones))));
}

Agent::Agent(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}
Agent::~Agent() = default;

void Agent::observe(const link::RobotStatus& status, Instant now) {
  parts_->observe(status, now);
}
void Agent::linked(const std::string& why_not, Instant now) {
  parts_->linked(why_not, now);
}
void Agent::hear(const CellStatus& state, std::uint64_t number, Instant now) {
  parts_->hear(state, number, now);
}
void Agent::advance(Instant now) {
  parts_->settle(now);
}
std::optional<blocks::Failure> Agent::objectionTo(const command::Departure& departure, Instant now) const {
  return parts_->objectionTo(departure, now);
}
std::optional<RobotReport> Agent::takeReport(Instant now) {
  return parts_->takeReport(now);
}
Instant Agent::nextReport() const {
  return parts_->nextReport();
}

bool Agent::isLetIn() const {
  return parts_->isJoined();
}

// --- run_program.

std::optional<blocks::Failure> Agent::objectionTo(const blocks::ProgramRequest& request) const {
  if (const auto why = Itinerary::objectionTo(parts_->program(), request)) {
    return blocks::Failure{blocks::own_error::kProgramUnknown, *why, ""};
  }
  return std::nullopt;
}
std::optional<blocks::Failure> Agent::begin(const blocks::ProgramRequest& request, Instant now) {
  return parts_->begin(request, now);
}
const blocks::ProgramFrame* Agent::permitted() const {
  return parts_->permitted();
}
void Agent::sent(Instant now) {
  parts_->sent(now);
}
void Agent::refused(Instant now) {
  parts_->settle(now);
}
void Agent::done(Instant now) {
  parts_->done(now);
}
bool Agent::isOver() const {
  return parts_->isOver();
}
const std::optional<blocks::Failure>& Agent::failure() const {
  return parts_->failure();
}
bool Agent::stopsRobot() const {
  return parts_->stopsRobot();
}
void Agent::finish() {
  parts_->finish();
}
std::vector<Duration> Agent::end(Instant now) {
  return parts_->end(now);
}
blocks::ProgramStand Agent::stand(Instant now) const {
  return parts_->stand(now);
}
std::optional<Instant> Agent::nextDeadline() const {
  return parts_->nextDeadline();
}

// --- Where it is.

Agent::Parts::Parts(std::shared_ptr<const Artifact> artifact, CellModel model, RobotIndex robot,
                    std::uint64_t session, ZoneWatch zones)
    : artifact_(std::move(artifact)),
      model_(std::move(model)),
      robot_(robot),
      session_(session),
      walk_(model_, robot),
      states_(program().name, session, artifact_->digest, artifact_->parameters.lease),
      where_(artifact_, robot, std::move(zones)),
      itinerary_(program()) {}

void Agent::Parts::observe(const link::RobotStatus& status, Instant now) {
  watch_.update(status);
  if (!status.joints) return;
  measured_at_ = now;
  lookAtZones(*status.joints);
  if (isJoined()) watchPath();
  if (!readiness_.isHalted() && (watch_.showsError() || watch_.emergencyStop())) {
    readiness_.halt(Halt::Error);
    has_news_ = true;
  }
  settle(now);
}

void Agent::Parts::linked(const std::string& why_not, Instant now) {
  if (readiness_.unlinked(why_not)) has_news_ = true;
  settle(now);
}

void Agent::Parts::lookAtZones(const arm::JointVector& joints) {
  const bool is_anywhere = readiness_.halted() == Halt::OffPath || watch_.manualMode();
  const auto whose = is_anywhere ? ZoneWatch::Of::Everyone : ZoneWatch::Of::Users;
  if (where_.lookAtZones(walk_.place(), joints, whose)) has_news_ = true;
}

/// Two frames in a row, as the first may be of before a frame that is just under way.
void Agent::Parts::watchPath() {
  if (readiness_.halted() == Halt::OffPath) return;
  off_frames_ = where_.see(walk_.place(), *watch_.joints()) ? 0 : off_frames_ + 1;
  if (off_frames_ < 2) return;
  readiness_.halt(Halt::OffPath);
  has_news_ = true;
  if (!is_running_) return;
  failure_ =
      blocks::Failure{blocks::own_error::kOffPath,
                      fmt::format("the joint angles do not match the path at {}", walk_.place().name), ""};
}

void Agent::Parts::hear(const CellStatus& state, std::uint64_t number, Instant now) {
  if (states_.hear(state, number, now)) followState(now);
  settle(now);
}

void Agent::Parts::followState(Instant now) {
  const RobotStatus* const mine = states_.mine();
  if (mine == nullptr || mine->session != session_) {
    joins_.reset();
    return;
  }
  if (joins_ != mine->joins) {
    restart(*mine);
    joins_ = mine->joins;
    has_news_ = true;
    return;
  }
  walk_.acknowledge(mine->acknowledged);
  if (is_running_ && states_.isFinishing()) itinerary_.finish();
  // Whoever holds the whole cell holds another path, too.
  const bool is_its_path = mine->reason != WaitReason::None && mine->reason != WaitReason::Holding;
  if (is_its_path) tryAnotherPath(now);
  if (states_.mode() == SupervisorMode::Holding) undoUnused();
}

/// It was let in, or a person has said where it is: whatever was before is over.
void Agent::Parts::restart(const RobotStatus& mine) {
  const std::string before = walk_.place().name;
  if (!walk_.restart(mine.place, mine.acknowledged)) return;
  if (is_running_ && mine.place != before) {
    failure_ = blocks::Failure{
        blocks::own_error::kRecoveryNeeded,
        fmt::format("it was recovered at {}, but this goal started at {}", mine.place, before), ""};
  }
  where_.startAnew();
  readiness_.halt(Halt::None);
  off_frames_ = 0;
  is_busy_ = false;
  permit_.reset();
  const CellPlace& place = walk_.place();
  if (place.station || !watch_.joints()) return;
  if (!where_.locate(place, *watch_.joints())) readiness_.halt(Halt::Stuck);
}

// --- What it says.

std::optional<blocks::Failure> Agent::Parts::objectionTo(const command::Departure& departure,
                                                         Instant now) const {
  const auto& tracker = where_.tracker();
  const bool is_permitted = tracker && permit_;
  return FrameGate{*artifact_,
                   robot_,
                   states_,
                   watch_,
                   measured_at_,
                   isJoined(),
                   tracker ? &*tracker : nullptr,
                   is_permitted ? &tracker->path().frames[permit_->frame_index] : nullptr}
      .objectionTo(departure, now);
}

std::optional<RobotReport> Agent::Parts::takeReport(Instant now) {
  if (!has_news_ && now < nextReport()) return std::nullopt;
  RobotReport report = headOf(program().name, *artifact_, session_, states_, walk_);
  report.number = ++report_number_;
  if (const auto joints = watch_.joints()) Eigen::Map<arm::JointVector>(report.joints.data()) = *joints;
  report.status_age = measured_at_ ? toSeconds(now - *measured_at_) : 0.0;
  report.condition = readiness_.condition(watch_);
  report.moving = watch_.moving().value_or(true);
  for (const ZoneIndex zone : where_.zones()) {
    report.touched_zones.push_back(static_cast<std::uint32_t>(zone));
  }
  report.text = foreignText(failure_ ? failure_->found : readiness_.text(), kLongestText - kCutMark);
  reported_at_ = now;
  has_news_ = false;
  if (!measured_at_) return std::nullopt;  // nobody knows where it is: it is not there yet
  states_.told(report.number, now);
  return report;
}

Instant Agent::Parts::nextReport() const {
  return reported_at_ ? *reported_at_ + artifact_->parameters.report_period : Instant{};
}

}  // namespace cobot_command::cell
