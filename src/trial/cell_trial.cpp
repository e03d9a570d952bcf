#include "cobot_command/trial/cell_trial.h"

#include <algorithm>
#include <cassert>
#include <iterator>
#include <utility>

#include "mail.h"
#include <fmt/format.h>

#include "cobot_command/blocks/run_program.h"
#include "cobot_command/cell/artifact/artifact_rules.h"
#include "cobot_command/cell/artifact/artifact_schedule.h"
#include "cobot_command/cell/artifact/place_fit.h"
#include "cobot_command/cell/artifact/start_setting.h"
#include "cobot_command/cell/bodies/robot_bodies.h"

namespace cobot_command::trial {
namespace {

/// So often distances are measured, and something random may happen.
constexpr Duration kMeasureEvery = std::chrono::milliseconds(20);
constexpr Duration kDisturbEvery = std::chrono::milliseconds(500);
/// Nothing has happened for so long, though goals are open.
constexpr Duration kStuckAfter = std::chrono::seconds(40);
/// At 5 % of the speed, and with pauses, everything takes longer, but nobody gives up.
constexpr Duration kRandomPatience = std::chrono::minutes(30);

std::shared_ptr<const cell::Artifact> withPatience(std::shared_ptr<const cell::Artifact> artifact,
                                                   const TrialSettings& settings) {
  if (!settings.is_random) return artifact;
  auto patient = std::make_shared<cell::Artifact>(*artifact);
  patient->parameters.wait_timeout = std::max(patient->parameters.wait_timeout, 2 * kRandomPatience);
  return patient;
}

}  // namespace

Result<std::unique_ptr<CellTrial>, std::string> CellTrial::of(std::shared_ptr<const cell::Artifact> artifact,
                                                              const TrialSettings& settings) {
  const auto rules = cell::rulesOf(*artifact, settings.policy);
  if (!rules) return refuse(rules.error());
  auto trial = std::unique_ptr<CellTrial>(new CellTrial(std::move(artifact), settings));
  for (cell::RobotIndex robot = 0; robot < trial->artifact_->robots.size(); ++robot) {
    auto agent = cell::Agent::of(trial->artifact_, trial->artifact_->program.robots[robot].name, 1);
    if (!agent) return refuse(agent.error());
    trial->robots_.push_back(std::make_unique<TrialRobot>(trial->artifact_, robot, settings.seed + robot + 1,
                                                          trial->now_, settings.not_streamed));
  }
  for (std::size_t mechanism = 0; mechanism < trial->artifact_->mechanisms.size(); ++mechanism) {
    trial->mechanisms_.push_back(std::make_unique<TrialMechanism>(
        trial->artifact_, mechanism, settings.seed + trial->robots_.size() + mechanism + 1));
  }
  if (settings.by_schedule) {
    auto turns = cell::turnsOf(*trial->artifact_, trial->model_, {});
    if (!turns) return refuse(turns.error());
    trial->turns_ = std::move(*turns);
  }
  trial->startSupervisor();
  return trial;
}

CellTrial::CellTrial(std::shared_ptr<const cell::Artifact> artifact, const TrialSettings& settings)
    : artifact_(withPatience(std::move(artifact), settings)),
      settings_(settings),
      model_(*cell::modelOf(artifact_->program)),
      mail_(std::make_unique<Mail>(settings.seed,
                                   settings.is_random && settings.delay == Duration::zero()
                                       ? std::chrono::milliseconds(200)
                                       : settings.delay,
                                   settings.loss, settings.doubled)),
      cut_(artifact_->program.robots.size(), false),
      places_(artifact_->program.robots.size()),
      now_(std::chrono::seconds(1000)) {}

CellTrial::~CellTrial() = default;

void CellTrial::startSupervisor() {
  cell::SupervisionPorts ports;
  ports.append = [this](const std::string& line) { return append(line); };
  ports.replace = [this](const std::string& line) { return replace(line); };
  ports.fits = [this](cell::RobotIndex robot, automata::StateIndex place,
                      const std::array<double, 6>& joints) {
    const cell::CellPlace& where = model_.places[robot][place];
    return cell::placeFits(*artifact_, robot, where, Eigen::Map<const arm::JointVector>(joints.data()));
  };
  ports.stop = [this](const cell::StopOrder& order) { stop_orders_.push_back(order); };
  const auto contents = cell::journal::read(journal_);
  assert(contents);
  journal_.resize(journal_.size() - contents->torn);
  supervision_ = std::make_unique<cell::Supervision>(
      *cell::rulesOf(*artifact_, settings_.policy), artifact_->digest, settings_.seed + 1, contents->records,
      cell::SupervisionSettings{artifact_->parameters.lease, artifact_->parameters.aging, turns_,
                                settings_.most_records},
      std::move(ports));
}

bool CellTrial::append(const std::string& line) {
  const std::size_t end = journal_.size() + line.size();
  journal_ += line;
  if (!journal_limit_ || end <= *journal_limit_) return true;
  journal_.resize(std::max(*journal_limit_, end - line.size()));
  return false;
}

bool CellTrial::replace(const std::string& line) {
  if (journal_limit_ && line.size() > *journal_limit_) return false;
  journal_ = line;
  return true;
}

bool CellTrial::start() {
  for (auto& robot : robots_) robot->connect();
  return passUntil(
      [this] {
        return supervision_->status(now_).mode == cell::SupervisorMode::Ready &&
               std::all_of(robots_.begin(), robots_.end(),
                           [](const auto& one) { return one->isReady() && one->isLetIn(); });
      },
      std::chrono::seconds(30));
}

void CellTrial::runAll(int cycles) {
  blocks::RunProgramGoal goal;
  goal.cycles = cycles;
  for (auto& robot : robots_) static_cast<void>(robot->submit(goal));
  for (auto& mechanism : mechanisms_) mechanism->run();
  changed_at_ = now_;
}

Instant CellTrial::nextEvent() const {
  Instant next =
      std::min({mail_->next(), told_at_ + artifact_->parameters.report_period, measured_at_ + kMeasureEvery});
  if (supervision_) next = std::min(next, supervision_->nextDeadline().value_or(Instant::max()));
  for (const auto& robot : robots_) next = std::min(next, robot->nextEvent());
  for (const auto& mechanism : mechanisms_) next = std::min(next, mechanism->nextEvent());
  return std::max(next, now_ + Duration(1));
}

void CellTrial::stepTo(Instant instant) {
  now_ = instant;
  for (auto& robot : robots_) robot->advanceTo(now_);
  for (auto& mechanism : mechanisms_) mechanism->advanceTo(now_);
  exchange();
  if (now_ >= measured_at_ + kMeasureEvery) measure();
  if (settings_.is_random && now_ >= disturbed_at_ + kDisturbEvery) disturb();
}

void CellTrial::exchange() {
  for (cell::RobotIndex user = 0; user < cut_.size(); ++user) {
    auto report = takeReport(user);
    if (report && !cut_[user]) mail_->send(*report, now_);
  }
  if (supervision_) {
    const auto reports = mail_->takeReports(now_);
    for (const auto& report : reports) supervision_->take(report, now_);
    const bool is_late = supervision_->nextDeadline().value_or(Instant::max()) <= now_;
    if (is_late || !reports.empty()) supervision_->tick(now_);
    for (const auto& order : std::exchange(stop_orders_, {})) {
      if (order.robot < robots_.size()) {
        static_cast<void>(robots_[order.robot]->submit(blocks::StopGoal{}));
      } else {
        mechanisms_[order.robot - robots_.size()]->stop();
      }
    }
    const bool is_due = now_ >= told_at_ + artifact_->parameters.report_period;
    if (is_due || !reports.empty()) tellNews(is_due);
  } else {
    static_cast<void>(mail_->takeReports(now_));  // nobody hears them
    told_at_ = now_;
  }
  for (auto& told : mail_->takeStates(now_)) {
    if (!cut_[told.robot]) hear(told.robot, *told.state, told.number);
  }
}

std::optional<cell::RobotReport> CellTrial::takeReport(cell::RobotIndex user) {
  if (user < robots_.size()) return robots_[user]->takeReport();
  return mechanisms_[user - robots_.size()]->takeReport(now_);
}

void CellTrial::hear(cell::RobotIndex user, const cell::CellStatus& state, std::uint64_t number) {
  if (user < robots_.size()) return robots_[user]->hear(state, number);
  mechanisms_[user - robots_.size()]->hear(state, number, now_);
}

void CellTrial::tellNews(bool is_due) {
  auto status = std::make_shared<const cell::CellStatus>(supervision_->status(now_));
  if (told_ && !is_due && cell::areAlike(*told_, *status)) return;
  told_at_ = now_;
  ++state_number_;
  tellEvents(*status);
  for (cell::RobotIndex user = 0; user < cut_.size(); ++user) {
    mail_->send(Mail::Told{user, status, state_number_}, now_);
  }
  told_ = std::move(status);
}

void CellTrial::tellEvents(const cell::CellStatus& status) {
  for (cell::RobotIndex robot = 0; robot < status.robots.size(); ++robot) {
    const cell::RobotStatus& mine = status.robots[robot];
    std::string text = mine.place;
    if (mine.reason != cell::WaitReason::None) {
      text += fmt::format(", waits: {} by {}", toString(mine.reason), fmt::join(mine.blocked_by, ", "));
    }
    if (text == places_[robot]) continue;
    places_[robot] = text;
    changed_at_ = now_;
    if (observer) observer({now_, mine.name + ": " + text});
  }
}

/// Between the true bodies, whatever anyone believes.
void CellTrial::measure() {
  measured_at_ = now_;
  std::vector<cell::Capsules> bodies;
  for (auto& robot : robots_) bodies.push_back(robot->bodies());
  for (std::size_t mechanism = 0; mechanism < mechanisms_.size(); ++mechanism) {
    bodies.push_back(artifact_->mechanisms[mechanism].bodies.at(mechanisms_[mechanism]->position()));
  }
  std::vector<cell::AlignedBox> boxes;
  std::transform(bodies.begin(), bodies.end(), std::back_inserter(boxes), cell::boxAround);
  for (std::size_t one = 0; one < bodies.size(); ++one) {
    for (std::size_t other = one + 1; other < bodies.size(); ++other) {
      if (cell::leastDistance(boxes[one], boxes[other]) >= least_.distance) continue;
      const double distance = cell::nearestOf(bodies[one], bodies[other]).distance;
      if (distance >= least_.distance) continue;
      const auto& users = artifact_->program.robots;
      least_ = {users[one].name, users[other].name, distance};
    }
  }
}

void CellTrial::disturb() {
  disturbed_at_ = now_;
  for (auto& robot : robots_) {
    if (mail_->share() < 0.1) {
      const int steps = cell::highestProjectSpeed(*artifact_) / 5;
      robot->operate(simulator::SetProjectSpeed{5 * (1 + static_cast<int>(mail_->share() * steps))});
    }
    if (mail_->share() < 0.05) robot->operate(simulator::PauseProject{});
    if (mail_->share() < 0.3) robot->operate(simulator::ResumeProject{});
  }
}

bool CellTrial::step(Instant until) {
  const Instant next = nextEvent();
  if (next > until) return false;
  stepTo(next);
  return true;
}

void CellTrial::pass(Duration duration) {
  const Instant until = now_ + duration;
  while (step(until)) {
  }
  if (now_ < until) stepTo(until);
}

bool CellTrial::passUntil(const std::function<bool()>& done, Duration most) {
  const Instant until = now_ + most;
  while (!done()) {
    if (!step(until)) return false;
  }
  return true;
}

bool CellTrial::isStuck() const {
  return now_ - changed_at_ > (settings_.is_random ? kRandomPatience : kStuckAfter);
}

TrialResult CellTrial::run() {
  TrialResult result;
  if (!start()) {
    result.faults.push_back("the cell does not become ready: " + status().diagnosis);
    return result;
  }
  const Instant began = now_;
  runAll(settings_.cycles);
  const auto all_ended = [this] {
    return std::all_of(robots_.begin(), robots_.end(), [](const auto& one) { return one->hasEnded(); });
  };
  static_cast<void>(passUntil([&] { return all_ended() || isStuck(); }, settings_.most));
  result.makespan = now_ - began;
  result.all_done = true;
  result.least = least_;
  for (const auto& robot : robots_) {
    const auto* outcome = robot->lastOutcome();
    const auto report =
        outcome != nullptr ? outcome->detail.as<blocks::ProgramReport>() : blocks::ProgramReport();
    result.cycles.push_back(report.cycles_done);
    Duration waited{};
    for (const Duration one : report.waited) waited += one;
    result.waited.push_back(waited);
    const bool is_done = outcome != nullptr && outcome->ending == blocks::Ending::Done;
    result.all_done = result.all_done && is_done;
    if (outcome != nullptr && !is_done) {
      result.faults.push_back(fmt::format("{}: {}", robot->name(), outcome->error_description));
    }
  }
  result.is_dead = result.faults.empty() && !result.all_done;
  return result;
}

}  // namespace cobot_command::trial
