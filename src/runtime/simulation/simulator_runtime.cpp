#include "cobot_command/runtime/simulation/simulator_runtime.h"

#include <algorithm>
#include <chrono>
#include <optional>
#include <utility>
#include <variant>

#include "shared/alarm.h"
#include "shared/core_thread.h"
#include "simulation/simulated_clock.h"
#include <boost/asio/post.hpp>
#include <boost/asio/steady_timer.hpp>
#include <fmt/format.h>

#include "cobot_command/transport/tcp_server.h"

namespace cobot_command::runtime {
namespace {

using Clock = Alarm::Clock;
using simulator::Port;
using simulator::SimulatedController;

/// What the slowest client may have left to read while the time jumps [bytes].
constexpr std::size_t kBacklogForJumping = std::size_t{64} * 1024;

std::optional<SimulatorError> problemIn(const SimulatorOptions& options) {
  using Kind = SimulatorError::Kind;
  for (const int port : {options.script_port, options.status_port}) {
    if (port < 0 || port > 65535) {
      return SimulatorError{
          Kind::BadOption,
          fmt::format("port {}: a port is a number from 1 to 65535, or 0 for any free one", port)};
    }
  }
  const double scale = options.time_scale;
  if (scale != kAsFastAsPossible && !(scale >= kSlowestTimeScale && scale <= kFastestTimeScale)) {
    return SimulatorError{Kind::BadOption,
                          fmt::format("time scale {}: allowed are {} to {}, or {} for as fast as possible",
                                      scale, kSlowestTimeScale, kFastestTimeScale, kAsFastAsPossible)};
  }
  return std::nullopt;
}

SimulatorError cannotServe(const std::string& address, int port, const transport::NetworkError& error) {
  const std::string found = fmt::format("cannot serve port {} on {}: {}", port, address, error.message);
  switch (error.kind) {
    case transport::NetworkError::Kind::AddressInUse:
      return {
          SimulatorError::Kind::Unavailable,
          found + "; another program uses it: stop that program, or choose another port (0: any free one)"};
    case transport::NetworkError::Kind::BadAddress:
      return {SimulatorError::Kind::BadOption,
              found +
                  "; bind_address must be an address of this machine: 127.0.0.1 for programs on this machine "
                  "only, 0.0.0.0 for all"};
    default:
      return {SimulatorError::Kind::Unavailable, found};
  }
}

}  // namespace

class SimulatorRuntime::Impl {
 public:
  Impl(arm::ArmModel arm, simulator::Settings settings, SimulatorOptions options, Observer observer)
      : options_(std::move(options)),
        observer_(std::move(observer)),
        clock_(options_.time_scale > 0 ? options_.time_scale : 1, Clock::now()),
        controller_(std::move(arm), std::move(settings), Instant{}),
        alarm_(thread_.context(), [this] { step(); }),
        state_timer_(thread_.context()) {}

  ~Impl() { stop(); }

  Result<SimulatorPorts, SimulatorError> start() {
    if (const auto problem = problemIn(options_)) {
      return refuse(*problem);
    }
    SimulatorPorts ports;
    if (const auto problem = take(Port::Script, options_.script_port, ports.script)) {
      return refuse(*problem);
    }
    if (const auto problem = take(Port::Status, options_.status_port, ports.status)) {
      return refuse(*problem);
    }
    step();  // opens the ports; the thread does not run yet
    if (failure_) {
      return refuse(*failure_);
    }
    setTelling(options_.tells_states);
    thread_.start();
    return ports;
  }

  void tellStates(bool wanted) {
    thread_.post([this, wanted] { setTelling(wanted); });
  }

  void stop() {
    thread_.finish([this] { closePorts(); });
    closePorts();  // when it never ran
  }

  bool post(Operation operation, std::function<void()> finished) {
    return thread_.post([this, operation = std::move(operation), finished = std::move(finished)] {
      handle(operation);
      if (finished) finished();
    });
  }

 private:
  std::optional<transport::TcpServer>& serverOf(Port port) {
    return port == Port::Script ? script_ : status_;
  }

  void closePorts() {
    script_.reset();
    status_.reset();
  }

  std::optional<SimulatorError> take(Port port, int wanted, int& taken) {
    transport::TcpServer::Callbacks callbacks;
    callbacks.connected = [this, port](transport::ClientId id) {
      const std::string address = serverOf(port)->addressOf(id);
      handle([&](auto& controller, Instant now) { controller.clientConnected(port, id, now, address); });
    };
    callbacks.received = [this, port](transport::ClientId id, std::string_view bytes) {
      handle([&](auto& controller, Instant now) { controller.received(port, id, bytes, now); });
    };
    callbacks.disconnected = [this, port](transport::ClientId id, const std::string&) {
      handle([&](auto& controller, Instant now) { controller.clientDisconnected(port, id, now); });
    };
    auto& server = serverOf(port).emplace(thread_.context(), std::move(callbacks));
    const auto bound = server.bind(options_.bind_address, static_cast<std::uint16_t>(wanted));
    if (!bound) {
      return cannotServe(options_.bind_address, wanted, bound.error());
    }
    taken = *bound;
    return std::nullopt;
  }

  /// Every event comes through here: it happens now, its outputs are carried out, the next one is awaited.
  template <class Event>
  void handle(const Event& event) {
    const Instant now = clock_.stepTo(Clock::now());
    event(controller_, now);
    controller_.advance(now);
    for (const auto& output : controller_.takeOutputs()) {
      std::visit([this](const auto& what) { this->carryOut(what); }, output);
    }
    awaitNextEvent();
  }

  /// Nothing happens but that time goes on.
  void step() {
    handle([](SimulatedController&, Instant) {});
  }

  void awaitNextEvent() {
    if (mayJump()) {
      if (!std::exchange(jumping_, true)) {
        boost::asio::post(thread_.context(), [this] { jump(); });
      }
      return;
    }
    alarm_.setFor(clock_.realTimeOf(controller_.nextEvent()));
  }

  [[nodiscard]] bool mayJump() const {
    return options_.time_scale == kAsFastAsPossible && controller_.state().in_motion &&
           controller_.nextEvent() != Instant::max() &&
           std::max(script_->backlog(), status_->backlog()) <= kBacklogForJumping;
  }

  void jump() {
    jumping_ = false;
    if (mayJump()) {
      clock_.jumpTo(controller_.nextEvent());
    }
    step();
  }

  void setTelling(bool wanted) {
    const bool can_tell = observer_.state && options_.state_period > Duration::zero();
    if (!can_tell || wanted == telling_) return;
    telling_ = wanted;
    if (telling_) {
      tellState();
    } else {
      state_timer_.cancel();
    }
  }

  void tellState() {
    if (!telling_) return;  // asked for in the last moment
    step();
    observer_.state(controller_.state());
    state_timer_.expires_at(
        std::max<Clock::time_point>(state_timer_.expiry() + options_.state_period, Clock::now()));
    state_timer_.async_wait([this](const boost::system::error_code& cancelled) {
      if (!cancelled) {
        tellState();
      }
    });
  }

  void carryOut(const simulator::Send& send) { serverOf(send.port)->send(send.client, send.bytes); }
  void carryOut(const simulator::CloseClient& close) { serverOf(close.port)->closeClient(close.client); }
  void carryOut(const simulator::ClosePort& close) { serverOf(close.port)->close(); }
  void carryOut(const simulator::OpenPort& open) {
    if (const auto opened = serverOf(open.port)->open(); !opened) {
      failure_ = cannotServe(options_.bind_address,
                             open.port == Port::Script ? options_.script_port : options_.status_port,
                             opened.error());
      carryOut(simulator::LogLine{controller_.state().time, failure_->message});
    }
  }
  void carryOut(const simulator::LogLine& line) {
    if (observer_.log) {
      observer_.log(line);
    }
  }

  CoreThread thread_;  ///< first: the sockets and the timers live on its context
  const SimulatorOptions options_;
  const Observer observer_;
  SimulatedClock clock_;
  SimulatedController controller_;
  std::optional<transport::TcpServer> script_;
  std::optional<transport::TcpServer> status_;
  Alarm alarm_;  ///< for the next event
  boost::asio::steady_timer state_timer_;
  bool telling_ = false;                   ///< of states
  std::optional<SimulatorError> failure_;  ///< of opening a port
  bool jumping_ = false;                   ///< a jump is under way
};

SimulatorRuntime::SimulatorRuntime(arm::ArmModel arm, simulator::Settings settings, SimulatorOptions options,
                                   Observer observer)
    : impl_(std::make_unique<Impl>(std::move(arm), std::move(settings), std::move(options),
                                   std::move(observer))) {}

SimulatorRuntime::~SimulatorRuntime() = default;

Result<SimulatorPorts, SimulatorError> SimulatorRuntime::start() {
  return impl_->start();
}

void SimulatorRuntime::stop() {
  impl_->stop();
}

void SimulatorRuntime::tellStates(bool wanted) {
  impl_->tellStates(wanted);
}

bool SimulatorRuntime::post(Operation operation, std::function<void()> finished) {
  return impl_->post(std::move(operation), std::move(finished));
}

}  // namespace cobot_command::runtime
