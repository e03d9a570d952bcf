#include "exchange/exchange_desk.h"

#include <chrono>
#include <limits>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "cobot_command/blocks/list/goal.h"
#include "cobot_command/blocks/shared/error_ids.h"
#include "cobot_command/capabilities/functions.h"
#include "cobot_command/command/waiting_goals.h"
#include "cobot_command/common/deadline.h"
#include "cobot_command/script/script_command.h"
#include "cobot_command/tables/entries.h"

namespace cobot_command::command {
namespace {

constexpr blocks::Block kBlock = blocks::kBlock<blocks::ExchangeConfigurationGoal>;
constexpr Duration kPatience = std::chrono::seconds(5);
constexpr Duration kTellPeriod = std::chrono::seconds(1);
constexpr std::size_t kAddTextBytes = 40;
/// The step of SRCI's example in which it waits.
constexpr const char* kWaitingStep = "_stepCmd = 2";

Duration milliseconds(int count) {
  return std::chrono::milliseconds(count);
}

blocks::SyncReaction reactionOf(const blocks::ExchangeSettings& settings) {
  return static_cast<blocks::SyncReaction>(settings.sync_reaction);
}

}  // namespace

void ExchangeDesk::useSettings(const link::LinkSettings& node, Instant now) {
  node_ = node;
  rule(now);
}

// --- The goal.

void ExchangeDesk::execute(blocks::GoalId id, const blocks::ExchangeConfigurationGoal& goal, Instant now) {
  std::vector<blocks::Failure> failures;
  if (state_ != State::Disabled) failures.push_back({blocks::exchange_error::kOnlyOneInstance, "", ""});
  for (blocks::Failure& failure : check(goal)) failures.push_back(std::move(failure));
  if (auto fault = faultIn(rules_)) {
    failures.push_back({blocks::exchange_error::kSyncMode, *std::move(fault), ""});
  }
  if (!failures.empty()) {
    blocks::Outcome refusal = toRejection(kBlock, failures);
    blocks::ExchangeReport report;
    report.error_add_txt = failures.front().found.substr(0, kAddTextBytes);
    refusal.detail = blocks::Detail(std::move(report));
    core_.board.reject(kBlock, id, std::move(refusal));
    return;
  }
  id_ = id;
  goal_ = goal;
  fire(Event::Execute, now);
}

void ExchangeDesk::cancel(Instant now) {
  fire(Event::Cancel, now);
}

ExchangeAnswer ExchangeDesk::update(const blocks::ExchangeSettings& settings, Instant now) {
  ExchangeAnswer answer;
  if (!isEnabled()) {
    answer.error_id = blocks::exchange_error::kNotEnabled;
    answer.message = "no exchange_configuration goal is enabled: send one, and wait until it is enabled";
    return answer;
  }
  if (const auto failures = check(settings); !failures.empty()) {
    const blocks::Outcome refusal = toRejection(kBlock, {failures.front()});
    answer.error_id = refusal.error_id;
    answer.message = fmt::format("{}. {}. The previous settings remain in effect", refusal.error_description,
                                 refusal.remedy);
    return answer;
  }
  update_ = settings;
  fire(Event::Update, now);
  answer.success = true;
  answer.message = fmt::format("they are in effect, as par_seq {}", report_.par_seq);
  return answer;
}

void ExchangeDesk::shutDown(const std::string& why, Instant now) {
  why_ = why;
  fire(Event::ShutDown, now);
}

// --- Events.

void ExchangeDesk::look(Instant now) {
  if (state_ == State::Disabled) return;
  const link::ScriptLink& script = core_.links.script();
  if (const auto heard = script.heardAt()) life_sign_.heard(*heard);
  if (!script.established()) linkLost(script.diagnosis(), now);
  if (core_.keeper.run().ready()) fire(Event::Ready, now);
  if (state_ == State::Disabling) fire(Event::Restored, now);
  if (isEnabled()) noteSync();
  if (state_ != State::Disabled) report(now);
}

/// Also of a link that was closed on purpose.
void ExchangeDesk::linkLost(const std::string& reason, Instant now) {
  why_ = reason;
  fire(std::exchange(life_sign_lost_, false) ? Event::LifeSignLost : Event::ConnectionLost, now);
}

void ExchangeDesk::advance(Instant now) {
  if (deadline_ && now >= *deadline_) fire(Event::TimedOut, now);
  if (const auto limit = life_sign_.deadline(); limit && now >= *limit) loseLifeSign(now);
  if (tell_at_ && now >= *tell_at_) tell(now);
}

std::optional<Instant> ExchangeDesk::nextDeadline() const {
  return earlier(deadline_, earlier(life_sign_.deadline(), tell_at_));
}

/// The stop may still be heard: a controller goes on without its client.
void ExchangeDesk::loseLifeSign(Instant now) {
  link::ScriptLink& script = core_.links.script();
  life_sign_.end();
  if (!script.established()) return;
  life_sign_lost_ = true;
  script.sendScript(toText(script::StopAndClearBuffer{}), now);
  script.giveUp(fmt::format("no life sign of the controller for {} ms; it was sent a stop command, which it "
                            "may not have received: it does not stop automatically when its client is gone",
                            goal_.settings.life_sign_time_out),
                now);
}

void ExchangeDesk::fire(Event event, Instant now) {
  const auto row = findTransition<ExchangeTable>(state_, event);
  if (!row) return;
  state_ = row->to;
  act(row->action, now);
}

void ExchangeDesk::act(ExchangeAction action, Instant now) {
  using Do = ExchangeAction;
  switch (action) {
    case Do::Begin:
      begin(now);
      return;
    case Do::Enable:
      enable(now);
      return;
    case Do::TakeUpdate:
      takeUpdate(now);
      return;
    case Do::Restore:
      disabled_ = report_.enabled;
      report_.busy = true;
      report_.enabled = report_.parameter_accepted = false;
      deadline_ = now + kPatience;
      restore(now);
      tell(now);
      return;
    case Do::EndDone:
      endDone();
      return;
    case Do::EndTimedOut:
      restore(now);
      end(blocks::Ending::Aborted, {blocks::exchange_error::kTimedOut,
                                    fmt::format("{}: {}", kWaitingStep, core_.keeper.diagnosis()), ""});
      return;
    case Do::EndConnectionLost:
      restore(now);
      end(blocks::Ending::Aborted, {blocks::exchange_error::kConnectionLost, why_, ""});
      return;
    case Do::EndLifeSignLost:
      restore(now);
      end(blocks::Ending::Aborted, {blocks::exchange_error::kLifeSignLost, why_, ""});
      return;
    case Do::EndShutDown:
      restore(now);
      end(blocks::Ending::Aborted, {blocks::own_error::kShutDown, why_, ""});
      return;
  }
}

void ExchangeDesk::begin(Instant now) {
  core_.board.accept(kBlock, *id_, 0);
  life_sign_lost_ = false;
  report_ = {};
  report_.busy = true;
  report_.unsupported = capabilities::beyondTheController();
  report_.without_effect = withoutEffect(goal_);
  deadline_ = now + kPatience;
  tell(now);
}

void ExchangeDesk::enable(Instant now) {
  deadline_.reset();
  report_.busy = false;
  report_.enabled = report_.command_buffered = report_.parameter_accepted = true;
  report_.par_seq = 1;
  blocks::ExchangeOutCmd& out = report_.out_cmd;
  out.length_acr = static_cast<int>(kMostWaiting) + 1;
  out.highest_tool_index = out.highest_frame_index = out.highest_load_index = tables::kEntryCount - 1;
  core_.sync.begin(rules_, goal_.settings, now);
  core_.guard.begin(milliseconds(goal_.settings.sync_delay), reactionOf(goal_.settings));
  noteSync();
  life_sign_.begin(milliseconds(goal_.settings.life_sign_time_out), now);
  rule(now);
  tell(now);
}

void ExchangeDesk::noteSync() {
  report_.ri_state = core_.sync.riState();
  report_.warning_id = core_.sync.warningId();
  if (report_.warning_id == 0 && queue_is_nearly_full_) {
    report_.warning_id = blocks::exchange_note::kQueueUsage;
  }
  report_.info_id = core_.sync.infoId();
  report_.local_sets = core_.sync.localSets();
  blocks::ExchangeOutCmd& out = report_.out_cmd;
  out.tells_motion_state = tellsMotionState();
  out.data_in_sync = core_.sync.controllersHalf();
  out.change_index_tool = core_.sync.changed().tools;
  out.change_index_frame = core_.sync.changed().frames;
  out.change_index_load = core_.sync.changed().loads;
}

bool ExchangeDesk::tellsMotionState() const {
  const auto& status = core_.robot.status();
  return status && status->tool_speed;
}

void ExchangeDesk::takeUpdate(Instant now) {
  report_.parameter_accepted = false;
  tell(now);
  goal_.settings = *std::exchange(update_, std::nullopt);
  life_sign_.change(milliseconds(goal_.settings.life_sign_time_out));
  core_.sync.change(goal_.settings);
  core_.guard.change(milliseconds(goal_.settings.sync_delay), reactionOf(goal_.settings));
  noteSync();
  rule(now);
  report_.without_effect = withoutEffect(goal_);
  report_.parameter_accepted = true;
  ++report_.par_seq;
  tell(now);
}

void ExchangeDesk::rule(Instant now) {
  core_.settings = node_;
  if (isEnabled()) {
    const blocks::ExchangeSettings& wanted = goal_.settings;
    core_.settings.supervision_period = LifeSign::periodOf(milliseconds(wanted.life_sign_time_out));
    core_.settings.supervision_misses = std::numeric_limits<int>::max();
    core_.messages.keep(static_cast<Severity>(wanted.log_level));
    core_.hold.use(milliseconds(wanted.delay_time), wanted.wait_for_nr_of_cmd);
  }
  core_.links.script().settingsChanged(now);
}

void ExchangeDesk::restore(Instant now) {
  life_sign_.end();
  core_.settings = node_;
  core_.messages.keepAsAtTheStart();
  core_.hold.end();
  core_.sync.end();
  core_.guard.end();
  core_.links.script().settingsChanged(now);
}

// --- What is told.

void ExchangeDesk::end(blocks::Ending ending, const blocks::Failure& failure) {
  deadline_.reset();
  tell_at_.reset();
  blocks::Outcome outcome = toOutcome(kBlock, ending, failure);
  blocks::ExchangeReport report;
  report.par_seq = report_.par_seq;
  report.unsupported = report_.unsupported;
  report.without_effect = report_.without_effect;
  report.life_sign_worst_gap = report_.life_sign_worst_gap;
  report.error_add_txt = failure.found.substr(0, failure.error_id == blocks::exchange_error::kTimedOut
                                                     ? std::string_view(kWaitingStep).size()
                                                     : kAddTextBytes);
  outcome.detail = blocks::Detail(std::move(report));
  core_.board.end(kBlock, *std::exchange(id_, std::nullopt), std::move(outcome));
}

void ExchangeDesk::endDone() {
  deadline_.reset();
  tell_at_.reset();
  blocks::Outcome outcome;
  outcome.error_description = "disabled on request";
  blocks::ExchangeReport report;
  report.par_seq = report_.par_seq;
  report.life_sign_worst_gap = report_.life_sign_worst_gap;
  outcome.detail = blocks::Detail(std::move(report));
  core_.board.end(kBlock, *std::exchange(id_, std::nullopt), std::move(outcome));
}

void ExchangeDesk::report(Instant now) {
  if (!report_.tellsTheSame(told_)) tell(now);
}

void ExchangeDesk::tell(Instant now) {
  report_.life_sign_worst_gap = 1000 * toSeconds(life_sign_.worstGap());
  told_ = report_;
  tell_at_ = now + kTellPeriod;
  blocks::Progress progress;
  if (report_.enabled) {
    progress.phase = blocks::Phase::Connected;
    const std::string why_not = core_.sync.whyNot();
    progress.text = why_not.empty() ? "enabled" : "enabled, and out of sync: " + why_not;
  } else if (state_ == State::Disabling) {
    progress.phase = blocks::Phase::Stopping;
    progress.text = "is being disabled";
  } else {
    progress.phase = blocks::Phase::Connecting;
    progress.text = "waits until the link is ready: " + core_.keeper.diagnosis();
  }
  progress.detail = blocks::Detail(report_);
  core_.board.progress(kBlock, *id_, std::move(progress));
}

}  // namespace cobot_command::command
