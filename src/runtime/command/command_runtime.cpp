#include "cobot_command/runtime/command/command_runtime.h"

#include <array>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <future>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "shared/alarm.h"
#include "shared/core_thread.h"

#include "cobot_command/blocks/list/goes_first.h"
#include "cobot_command/transport/tcp_connection.h"

namespace cobot_command::runtime {
namespace {

using Clock = Alarm::Clock;

/// Far below what a jog stands within without the next one.
constexpr Duration kKeepAlivesApart = std::chrono::milliseconds(2);

link::OpenFailure toOpenFailure(const transport::NetworkError& error) {
  using From = transport::NetworkError::Kind;
  using To = link::OpenFailure::Kind;
  switch (error.kind) {
    case From::Refused:
      return {To::Refused, error.message};
    case From::Unreachable:
      return {To::Unreachable, error.message};
    case From::UnknownHost:
      return {To::UnknownHost, error.message};
    case From::TimedOut:
      return {To::TimedOut, error.message};
    case From::AddressInUse:
    case From::BadAddress:
    case From::Other:
      break;
  }
  return {To::Other, error.message};
}

}  // namespace

class CommandRuntime::Impl {
 public:
  Impl(std::optional<arm::ArmModel> arm, const link::LinkSettings& settings, Observer observer,
       command::CorePorts ports)
      : observer_(std::move(observer)),
        newest_(ports.newest),
        core_(std::move(arm), settings, std::move(ports), command::Planning::Beside),
        start_(Clock::now()),
        alarm_(thread_.context(), [this] { advance(); }) {
    thread_.post([this] { advance(); });
    for (CoreThread& planner : planners_) planner.start();
    thread_.start();
  }

  ~Impl() { stop(); }

  /// An event for the core, from any thread.
  template <class Event>
  bool post(Event event) {
    return thread_.post([this, event = std::move(event)] { handle(event); });
  }
  /// One that does not wait for those that are not urgent.
  template <class Event>
  bool postUrgent(Event event) {
    return thread_.postUrgent([this, event = std::move(event)] { handle(event); });
  }

  bool submit(blocks::GoalId id, blocks::Goal goal) {
    if (blocks::goesFirst(goal)) {
      return postUrgent(
          [id, goal = std::move(goal)](auto& core, Instant now) { core.submit(id, goal, now); });
    }
    on_the_way_.add(id);
    const bool is_open = thread_.post([this, id, goal = std::move(goal)] {
      if (on_the_way_.take(id)) {
        handle([&](auto& core, Instant now) { core.submit(id, goal, now); });
      } else {
        recall(id, blockOf(goal));
      }
    });
    if (!is_open) static_cast<void>(on_the_way_.take(id));
    return is_open;
  }

  void cancel(blocks::GoalId id, std::optional<blocks::GoalId> newest) {
    if (on_the_way_.cancel(id)) return;
    postUrgent([id, newest](auto& core, Instant now) { core.cancel(id, now, newest); });
  }

  void keepJogging() {
    auto last = kept_at_.load();
    const Instant at = now();
    if (at - last < kKeepAlivesApart || !kept_at_.compare_exchange_strong(last, at)) return;
    postUrgent([](auto& core, Instant now) { core.keepJogging(now); });
  }

  /// Nothing: only the core knows.
  [[nodiscard]] std::optional<blocks::GoalId> newestGoal() const {
    return newest_ ? std::optional(newest_()) : std::nullopt;
  }

  /// False: it has ended already.
  bool retire(const std::function<void()>& begun = {}) {
    return thread_.postUrgent([this, begun] {
      handle([](command::CommandCore& core, Instant now) { core.retire(now); });
      noteBegin();
      if (begun) begun();
    });
  }

  void stop() {
    if (retire()) awaitRetirement();
    thread_.finish([this] {
      core_.shutDown(now());
      carryOut();
      connections_.clear();
    });
    // What they are at was dropped: they end behind their step.
    for (CoreThread& planner : planners_) planner.finish([] {});
  }

  [[nodiscard]] Instant now() const { return Instant(Clock::now() - start_); }

 private:
  /// Goals that were submitted, and that the core's thread has not come to yet: a cancel overtakes them.
  class OnTheWay {
   public:
    void add(blocks::GoalId id) {
      const std::lock_guard<std::mutex> lock(mutex_);
      is_cancelled_[id] = false;
    }
    /// False: it was cancelled.
    [[nodiscard]] bool take(blocks::GoalId id) {
      const std::lock_guard<std::mutex> lock(mutex_);
      const auto found = is_cancelled_.find(id);
      if (found == is_cancelled_.end()) return true;  // the id of two: the first has taken it
      const bool is_wanted = !found->second;
      is_cancelled_.erase(found);
      return is_wanted;
    }
    /// False: it is not on the way.
    [[nodiscard]] bool cancel(blocks::GoalId id) {
      const std::lock_guard<std::mutex> lock(mutex_);
      const auto found = is_cancelled_.find(id);
      if (found == is_cancelled_.end()) return false;
      found->second = true;
      return true;
    }

   private:
    std::mutex mutex_;
    std::map<blocks::GoalId, bool> is_cancelled_;
  };

  /// It ends before the core has heard of it.
  void recall(blocks::GoalId id, blocks::Block block) {
    const blocks::Outcome outcome = blocks::commandAborted("cancelled before it was started");
    observer_(command::GoalEnded{block, id, outcome}, now());
    handle([&](auto& core, Instant now) { core.tellEnd(block, outcome, now); });
  }

  /// The connections have to live until the stop was heard: closed with answers unread, they would be reset,
  /// and some systems then drop what came before.
  void awaitRetirement() {
    std::unique_lock<std::mutex> lock(retiring_);
    retired_changed_.wait(lock, [this] { return begun_; });
    retired_changed_.wait_for(lock, kRetirement, [this] { return retired_; });
  }

  /// The stop is out, if one was due.
  void noteBegin() {
    const std::lock_guard<std::mutex> lock(retiring_);
    begun_ = true;
    retired_changed_.notify_all();
  }

  void noteRetirement() {
    if (!core_.retired()) return;
    const std::lock_guard<std::mutex> lock(retiring_);
    retired_ = true;
    retired_changed_.notify_all();
  }

  template <class Event>
  void handle(const Event& event) {
    event(core_, now());
    carryOut();
    if (const auto deadline = core_.nextDeadline(); deadline && *deadline <= now()) {
      core_.advance(now());  // the time for a reply begins now, as its script is out: that needs no timer
      carryOut();
    }
    noteRetirement();
    if (const auto deadline = core_.nextDeadline()) alarm_.setFor(start_ + deadline->time_since_epoch());
  }

  void advance() {
    handle([](command::CommandCore& core, Instant now) { core.advance(now); });
  }

  /// The wire first: while the controller works on what it got, there is time to tell of it.
  void carryOut() {
    const std::vector<command::Action> actions = core_.takeActions();
    for (const auto& action : actions) {
      std::visit([&](const auto& what) { carryOut(what); }, action);
    }
    for (const auto& action : actions) {
      std::visit([&](const auto& what) { tell(what, action); }, action);
    }
  }

  template <class Told>
  void tell(const Told& /*told*/, const command::Action& action) {
    observer_(action, now());
  }
  void tell(const command::PlanAsked&, const command::Action&) {}
  void tell(const command::OpenConnection&, const command::Action&) {}
  void tell(const command::CloseConnection&, const command::Action&) {}
  void tell(const command::SendBytes&, const command::Action&) {}

  template <class Told>
  void carryOut(const Told& /*told*/) {}
  void carryOut(const command::PlanAsked& plan) {
    planners_.at(static_cast<std::size_t>(plan.lane)).post([this, id = plan.id, work = plan.work] {
      post([id, answer = work()](auto& core, Instant now) { core.planned(id, answer, now); });
    });
  }
  void carryOut(const command::SendBytes& send) {
    if (const auto connection = connections_.find(send.id); connection != connections_.end()) {
      connection->second.send(send.bytes);
    }
  }
  void carryOut(const command::CloseConnection& close) { connections_.erase(close.id); }
  void carryOut(const command::OpenConnection& open) {
    const auto id = open.id;
    transport::TcpConnection::Callbacks callbacks;
    callbacks.opened = [this, id] { handle([&](auto& core, Instant now) { core.opened(id, now); }); };
    callbacks.failed = [this, id](const transport::NetworkError& error) {
      connections_.erase(id);
      handle([&](auto& core, Instant now) { core.openFailed(id, toOpenFailure(error), now); });
    };
    callbacks.received = [this, id](std::string_view bytes) {
      handle([&](auto& core, Instant now) { core.received(id, bytes, now); });
    };
    callbacks.closed = [this, id](const std::string& reason) {
      connections_.erase(id);
      handle([&](auto& core, Instant now) { core.closed(id, reason, now); });
    };
    const auto [connection, is_new] = connections_.try_emplace(id, thread_.context(), std::move(callbacks));
    if (is_new) {
      connection->second.open(open.host, static_cast<std::uint16_t>(open.port), open.timeout);
    }
  }

  std::array<CoreThread, 2> planners_;  ///< of each lane; they outlive the core's thread, which asks them
  CoreThread thread_;  ///< first of the core's: the sockets and the alarm live on its context
  const Observer observer_;
  const command::NewestGoal newest_;
  command::CommandCore core_;
  OnTheWay on_the_way_;
  const Clock::time_point start_;
  Alarm alarm_;
  std::map<link::ConnectionId, transport::TcpConnection> connections_;
  std::mutex retiring_;
  std::condition_variable retired_changed_;
  bool begun_ = false;
  bool retired_ = false;
  std::atomic<Instant> kept_at_{Instant(-kKeepAlivesApart)};
};

/// Has the core's thread call `ask(core, reply, now)`, which calls `reply` once: at once, or later.
template <typename Answer, typename Ask>
std::optional<std::future<Answer>> CommandRuntime::ask(Ask ask) {
  const auto answer = std::make_shared<std::promise<Answer>>();
  auto answered = answer->get_future();
  const auto reply = [answer](const Answer& given) { answer->set_value(given); };
  const bool posted =
      impl_->post([ask = std::move(ask), reply](auto& core, Instant now) { ask(core, reply, now); });
  return posted ? std::optional(std::move(answered)) : std::nullopt;
}

CommandRuntime::CommandRuntime(std::optional<arm::ArmModel> arm, const link::LinkSettings& settings,
                               Observer observer, command::CorePorts ports)
    : impl_(std::make_unique<Impl>(std::move(arm), settings, std::move(observer), std::move(ports))) {}

CommandRuntime::~CommandRuntime() = default;

bool CommandRuntime::submit(blocks::GoalId id, blocks::Goal goal) {
  return impl_->submit(id, std::move(goal));
}

void CommandRuntime::useSettings(const link::LinkSettings& settings) {
  impl_->post([settings](auto& core, Instant now) { core.useSettings(settings, now); });
}

void CommandRuntime::useTables(tables::DataTables tables) {
  impl_->post([tables = std::move(tables)](auto& core, Instant /*now*/) { core.useTables(tables); });
}

void CommandRuntime::useExchangeRules(const command::ExchangeRules& rules) {
  impl_->post([rules](auto& core, Instant /*now*/) { core.useExchangeRules(rules); });
}

std::optional<std::future<command::TableAnswer>> CommandRuntime::writeTable(command::TableWrite write) {
  return ask<command::TableAnswer>(
      [write = std::move(write)](auto& core, const auto& reply, Instant /*now*/) {
        reply(core.writeTable(write));
      });
}

std::optional<std::future<command::TableAnswer>> CommandRuntime::tryTable(command::TableWrite write) {
  return ask<command::TableAnswer>(
      [write = std::move(write)](auto& core, const auto& reply, Instant /*now*/) {
        reply(core.tryTable(write));
      });
}

std::optional<std::future<command::FeedrateAnswer>> CommandRuntime::setFeedrate(
    command::FeedrateRequest request) {
  return ask<command::FeedrateAnswer>(
      [request](auto& core, const auto& reply, Instant now) { core.setFeedrate(request, reply, now); });
}

std::optional<std::future<std::optional<std::string>>> CommandRuntime::switchTracking(
    command::TrackingSwitch request) {
  return ask<std::optional<std::string>>(
      [request](auto& core, const auto& reply, Instant now) { reply(core.switchTracking(request, now)); });
}

std::optional<std::future<command::ExchangeAnswer>> CommandRuntime::updateExchange(
    blocks::ExchangeSettings settings) {
  return ask<command::ExchangeAnswer>(
      [settings](auto& core, const auto& reply, Instant now) { reply(core.updateExchange(settings, now)); });
}

std::optional<std::future<command::OverrideAnswer>> CommandRuntime::setSpeedOverride(double percent) {
  return ask<command::OverrideAnswer>(
      [percent](auto& core, const auto& reply, Instant now) { core.setSpeedOverride(percent, reply, now); });
}

std::optional<std::future<command::DynamicsAnswer>> CommandRuntime::writeDefaults(
    blocks::DefaultDynamics defaults) {
  return ask<command::DynamicsAnswer>(
      [defaults](auto& core, const auto& reply, Instant /*now*/) { reply(core.writeDefaults(defaults)); });
}

std::optional<std::future<blocks::DefaultDynamics>> CommandRuntime::defaults() {
  return ask<blocks::DefaultDynamics>(
      [](auto& core, const auto& reply, Instant /*now*/) { reply(core.defaults()); });
}

std::optional<std::future<std::optional<command::ReferenceDynamics>>> CommandRuntime::referenceDynamics() {
  return ask<std::optional<command::ReferenceDynamics>>(
      [](auto& core, const auto& reply, Instant /*now*/) { reply(core.referenceDynamics()); });
}

std::optional<std::future<command::DynamicsAnswer>> CommandRuntime::writeLimits(
    command::SoftwareLimits limits) {
  return ask<command::DynamicsAnswer>(
      [limits](auto& core, const auto& reply, Instant now) { reply(core.writeLimits(limits, now)); });
}

std::optional<std::future<std::optional<command::LimitsReport>>> CommandRuntime::limits() {
  return ask<std::optional<command::LimitsReport>>(
      [](auto& core, const auto& reply, Instant /*now*/) { reply(core.limits()); });
}

std::optional<std::future<command::ResetAnswer>> CommandRuntime::reset() {
  return ask<command::ResetAnswer>(
      [](auto& core, const auto& reply, Instant now) { reply(core.reset(now)); });
}

std::optional<std::future<std::vector<command::Message>>> CommandRuntime::messages(command::Severity least,
                                                                                   std::uint32_t after_id) {
  return ask<std::vector<command::Message>>(
      [=](auto& core, const auto& reply, Instant /*now*/) { reply(core.messages(least, after_id)); });
}

std::optional<std::future<command::InterruptAnswer>> CommandRuntime::interrupt() {
  return ask<command::InterruptAnswer>(
      [](auto& core, const auto& reply, Instant now) { core.interrupt(reply, now); });
}

std::optional<std::future<command::InterruptAnswer>> CommandRuntime::goOn() {
  return ask<command::InterruptAnswer>(
      [](auto& core, const auto& reply, Instant now) { core.goOn(reply, now); });
}

void CommandRuntime::keepJogging() {
  impl_->keepJogging();
}

void CommandRuntime::inCore(std::function<void(Instant now)> what) {
  impl_->post([what = std::move(what)](auto& core, Instant now) {
    what(now);
    core.advance(now);
  });
}

void CommandRuntime::tellEnd(blocks::Block block, blocks::Outcome outcome) {
  impl_->post(
      [block, outcome = std::move(outcome)](auto& core, Instant now) { core.tellEnd(block, outcome, now); });
}

void CommandRuntime::keepConnected(blocks::ConnectGoal target) {
  impl_->post([target = std::move(target)](auto& core, Instant now) { core.keepConnected(target, now); });
}

void CommandRuntime::cancel(blocks::GoalId id, std::optional<blocks::GoalId> newest) {
  impl_->cancel(id, newest ? newest : impl_->newestGoal());
}

std::optional<std::future<command::FinishReport>> CommandRuntime::finish(
    blocks::FinishAfter after, std::optional<blocks::GoalId> newest) {
  return ask<command::FinishReport>(
      [after, newest = newest ? newest : impl_->newestGoal()](auto& core, const auto& reply, Instant now) {
        reply(core.finish(after, now, newest));
      });
}

void CommandRuntime::retire(const std::function<void()>& begun) {
  if (!impl_->retire(begun) && begun) begun();
}

void CommandRuntime::stop() {
  impl_->stop();
}

}  // namespace cobot_command::runtime
