#include <algorithm>
#include <utility>

#include "controller_impl.h"
#include <fmt/format.h>

#include "cobot_command/arm/forward_kinematics.h"
#include "cobot_command/common/foreign_text.h"

namespace cobot_command::simulator {

namespace {

MotionQueue::Options queueOptions(const Settings& settings) {
  MotionQueue::Options options;
  options.stop_time = std::max(settings.stop_time, Duration::zero());
  options.checks_payload = settings.checks_payload;
  options.accept_zero_ramp = settings.accept_zero_ramp;
  options.live_speed = settings.project_speed_live;
  options.pvt_lag = std::max(settings.pvt_lag, Duration::zero());
  return options;
}

}  // namespace

SimulatedController::Impl::Impl(const arm::ArmModel& arm, Settings settings, Instant now)
    : arm_(arm.turning(settings.turn_speed)),
      settings_(std::move(settings)),
      now_(now),
      faults_(settings_.faults),
      outgoing_(faults_, outbox_),
      queue_(arm_, settings_.start_posture, queueOptions(settings_), faults_),
      io_(outbox_),
      project_(settings_, arm_),
      node_(settings_, {arm_, queue_, io_, project_, [this] { return measured(); }}, faults_, outgoing_,
            outbox_),
      status_(settings_, project_.variables, now, outgoing_, outbox_),
      operator_({settings_, faults_, outbox_, queue_, io_, project_, node_, status_}, [this] { settle(); }),
      started_(now) {
  settings_.project_speed_percent = std::clamp(settings_.project_speed_percent, 1, 100);
  queue_.setSpeedOverride(settings_.project_speed_percent / 100.0, now);
  outbox_.setTime(now);
  outbox_.openPort(Port::Status);
  if (settings_.project_running) operator_.operate(RunProject{}, now_);
}

// --- Time --------------------------------------------------------------------------------------------------

void SimulatedController::Impl::advance(Instant now) {
  for (Instant next = nextEvent(); next <= now; next = nextEvent()) {
    setTime(next);
    outgoing_.deliver();
    settle();
    if (status_.nextEvent() <= now_) streamStatus();
  }
  setTime(now);
}

Instant SimulatedController::Impl::nextEvent() const {
  return std::min({queue_.nextEvent(), node_.nextEvent(), status_.nextEvent(), outgoing_.nextEvent()});
}

void SimulatedController::Impl::setTime(Instant now) {
  now_ = std::max(now_, now);
  outbox_.setTime(now_);
}

// Scripts and motions, in turn, until nothing more happens at this instant. Scripts go first: a motion starts
// when all lines that could be passed have been, so that a tag behind it knows how it ends.
void SimulatedController::Impl::settle() {
  do {
    while (node_.step(now_)) {
    }
  } while (runQueue());
}

bool SimulatedController::Impl::runQueue() {
  const bool ran = queue_.run(now_);
  const std::vector<QueueEvent> events = queue_.takeEvents();
  for (const QueueEvent& event : events) {
    std::visit([&](const auto& what) { on(what); }, event);
  }
  if (std::exchange(stops_project_, false)) node_.stop(now_);
  return ran || !events.empty();
}

void SimulatedController::Impl::on(const MotionStarted& started) {
  outbox_.log(fmt::format("motion of {:.3f} s", toSeconds(started.duration)));
}

void SimulatedController::Impl::on(const MotionFailed& failed) {
  error_since_ = now_;
  outbox_.log(fmt::format("robot error 0x{:X}: {}", failed.error.code, failed.error.text));
  node_.abandonScripts();
  stops_project_ = settings_.on_motion_error == MotionErrorPolicy::StopProject;
}

void SimulatedController::Impl::streamStatus() {
  const RobotState robot = measured();
  status_.stream(source(robot));
}

OperatorReply SimulatedController::Impl::operate(const OperatorAction& action, Instant now) {
  advance(now);
  OperatorReply reply = operator_.operate(action, now_);
  reply.text = forPeople(std::move(reply.text));
  outbox_.log("operator: " + reply.text);
  settle();
  return reply;
}

// --- The wire ----------------------------------------------------------------------------------------------

void SimulatedController::Impl::clientConnected(Port port, ClientId client, Instant now,
                                                std::string_view address) {
  advance(now);
  if (port == Port::Status) return status_.connected(client, address, now_);
  node_.connected(client, now_);
}

void SimulatedController::Impl::clientDisconnected(Port port, ClientId client, Instant now) {
  advance(now);
  if (port == Port::Status) return status_.disconnected(client);
  node_.disconnected(client);
}

void SimulatedController::Impl::received(Port port, ClientId client, std::string_view bytes, Instant now) {
  advance(now);
  if (port == Port::Status) return receivedOnStatus(client, bytes);
  node_.feed(client, bytes);
  // Frame by frame, so that frames in one piece do what they do in pieces of their own.
  while (node_.handleNext(client, now_)) settle();
}

// --- What comes out ----------------------------------------------------------------------------------------

RobotState SimulatedController::Impl::state() const {
  const motion::JointState joints = queue_.arm().at(now_);
  RobotState state;
  state.time = now_;
  state.started = started_;
  state.project_started = operator_.projectStarted();
  state.joints = joints.position;
  state.velocities = joints.velocity;
  state.flange = arm::forwardKinematics(arm_, joints.position);
  const ToolAndBase& setting = queue_.toolAndBase();
  state.base = setting.base;
  state.tcp = setting.tcp;
  state.base_name = setting.base_name;
  state.tcp_name = setting.tcp_name;
  state.tcp_mass = setting.tcp_mass;
  state.tcp_inertia = setting.tcp_inertia;
  state.load = setting.load;
  state.inputs = io_.inputs();
  state.outputs = io_.outputs();
  state.analog_output = io_.analogOutput();
  state.camera_light = io_.cameraLight();
  state.auto_remote = auto_remote_;
  state.in_motion = queue_.arm().inMotion(now_);
  state.project_running = node_.projectRuns();
  state.project_paused = queue_.paused() && node_.projectRuns();
  state.listening = node_.listening();
  state.emergency_stop = operator_.emergencyStop();
  state.safeguard = operator_.safeguard();
  state.mode = operator_.mode();
  state.error = queue_.error().has_value();
  if (queue_.error()) {
    state.error_code = queue_.error()->code;
    state.error_text = queue_.error()->text;
    state.error_time = error_since_;
  }
  state.queued_motions = queue_.motionCount();
  state.project_speed_percent = settings_.project_speed_percent;
  return state;
}

// --- The public face ---------------------------------------------------------------------------------------

SimulatedController::SimulatedController(const arm::ArmModel& arm, Settings settings, Instant now)
    : impl_(std::make_unique<Impl>(arm, std::move(settings), now)) {}
SimulatedController::~SimulatedController() = default;
SimulatedController::SimulatedController(SimulatedController&&) noexcept = default;
SimulatedController& SimulatedController::operator=(SimulatedController&&) noexcept = default;

void SimulatedController::clientConnected(Port port, ClientId client, Instant now, std::string_view address) {
  impl_->clientConnected(port, client, now, address);
}

void SimulatedController::clientDisconnected(Port port, ClientId client, Instant now) {
  impl_->clientDisconnected(port, client, now);
}

void SimulatedController::received(Port port, ClientId client, std::string_view bytes, Instant now) {
  impl_->received(port, client, bytes, now);
}

void SimulatedController::advance(Instant now) {
  impl_->advance(now);
}

Instant SimulatedController::nextEvent() const {
  return impl_->nextEvent();
}

OperatorReply SimulatedController::operate(const OperatorAction& action, Instant now) {
  return impl_->operate(action, now);
}

std::vector<Output> SimulatedController::takeOutputs() {
  return impl_->takeOutputs();
}

RobotState SimulatedController::state() const {
  return impl_->state();
}

const arm::ArmModel& SimulatedController::arm() const {
  return impl_->arm();
}

}  // namespace cobot_command::simulator
