#include "script_port/script_commands.h"

#include <algorithm>
#include <chrono>
#include <string>
#include <utility>

#include "robot/tmflow_version.h"

#include "cobot_command/arm/controller_pose.h"
#include "cobot_command/common/units.h"
#include "cobot_command/script/robot_functions.h"

namespace cobot_command::simulator {

namespace {

tm_script::CallAnswer done() {
  return tm_script::Value(tm_script::Scalar(true));
}
script::ToolInertia inertiaOf(const Tool& tool) {
  script::ToolInertia inertia;
  std::copy(tool.moment.begin(), tool.moment.end(), inertia.moment.begin());
  std::copy(tool.mass_center.begin(), tool.mass_center.end(), inertia.mass_center.begin());
  return inertia;
}
tm_script::CallAnswer full() {
  return tm_script::CallFailure{"the queue of motions is full"};
}
tm_script::CallAnswer outsidePvt(const std::string& what) {
  return tm_script::CallFailure{what + " is only allowed after PVTEnter"};
}

std::optional<Duration> limit(int milliseconds) {
  return milliseconds > 0 ? std::optional<Duration>(std::chrono::milliseconds(milliseconds)) : std::nullopt;
}

}  // namespace

template <class Motion>
tm_script::CallAnswer ScriptCommands::execute(const Motion& motion) {
  if (auto failure = withinPvt("another motion")) return *failure;
  queue_.push(MotionRequest(motion));
  return done();
}

tm_script::CallAnswer ScriptCommands::execute(const script::ChangeBase& change) {
  if (const auto* name = std::get_if<std::string>(&change.base)) {
    queue_.push(BaseChange{project_.bases.at(*name).now.pose, *name});
  } else {
    queue_.push(BaseChange{arm::toPose(std::get<script::SixNumbers>(change.base)), ""});
  }
  return done();
}

tm_script::CallAnswer ScriptCommands::execute(const script::ChangeTcp& change) {
  if (const auto* name = std::get_if<std::string>(&change.tcp)) {
    const Tool& tool = project_.tools.at(*name).now;
    queue_.push(TcpChange{tool.frame.pose, *name, double{tool.mass}, inertiaOf(tool)});
  } else {
    queue_.push(
        TcpChange{arm::toPose(std::get<script::SixNumbers>(change.tcp)), "", change.weight, change.inertia});
  }
  return done();
}

tm_script::CallAnswer ScriptCommands::execute(const script::ChangeLoad& change) {
  queue_.push(LoadChange{change.weight});
  return done();
}

tm_script::CallAnswer ScriptCommands::execute(const script::QueueTag& tag) {
  if (tag.wait) {
    if (auto failure = withinPvt("a wait for a tag")) return *failure;
  }
  QueuedTag queued = tags_.add(tag.tag);
  queued.reported = faults_.early_tag.take();
  if (queued.reported) clients_.broadcast(protocol::TagReport{tag.tag, protocol::TagState::Complete});
  queue_.push(queued);
  if (!tag.wait) return done();
  wait_ = LineWait{queued, Instant::max()};
  return tm_script::Wait{};
}

// To 1.80 a time of 0 or less is no limit; from 1.82 on only one below 0 is, and tag 0 waits for nothing but
// the time.
tm_script::CallAnswer ScriptCommands::execute(const script::WaitQueueTag& wait) {
  constexpr int kUnknown = -1;
  const bool is_new = !(tmflow_ < kPriorityCommands);
  const std::optional<QueuedTag> tag = tags_.latest(wait.tag);
  if (!tag && !(is_new && wait.tag == 0)) return tm_script::Value(tm_script::Scalar(kUnknown));
  const int timeout = wait.timeout.value_or(-1);
  const bool is_limited = is_new ? timeout >= 0 : timeout > 0;
  wait_ = LineWait{tag, is_limited ? now_ + std::chrono::milliseconds(timeout) : Instant::max(), true};
  return tm_script::Wait{};
}

tm_script::CallAnswer ScriptCommands::execute(const script::StopAndClearBuffer&) {
  if (!faults_.ignore_stop.take()) queue_.stop(now_);
  return done();
}

tm_script::CallAnswer ScriptCommands::execute(const script::Pause&) {
  queue_.pause(now_);
  return done();
}

tm_script::CallAnswer ScriptCommands::execute(const script::Resume&) {
  queue_.resume(now_);
  return done();
}

tm_script::CallAnswer ScriptCommands::execute(const script::ScriptExit&) {
  exited_ = true;
  return tm_script::EndScript{tm_script::Scalar(true)};
}

template <class Output>
tm_script::CallAnswer ScriptCommands::put(const Output& write) {
  if (write.instant) {
    io_.write(write);
  } else {
    queue_.push(write);
  }
  return done();
}

// --- PVT and velocities ------------------------------------------------------------------------------------

std::optional<tm_script::CallFailure> ScriptCommands::withinPvt(const char* what) const {
  if (!queue_.pvt().isOpen()) return std::nullopt;
  return tm_script::CallFailure{std::string(what) + " is not allowed between PVTEnter and PVTExit"};
}

tm_script::CallAnswer ScriptCommands::execute(const script::PvtEnter& enter) {
  if (auto failure = withinPvt("another PVTEnter")) return *failure;
  queue_.pvt().open(enter.cartesian);
  return done();
}

tm_script::CallAnswer ScriptCommands::execute(const script::PvtPoint& point) {
  if (!queue_.pvt().isOpen()) return outsidePvt("PVTPoint");
  queue_.pvt().add(point);
  return done();
}

tm_script::CallAnswer ScriptCommands::execute(const script::PvtExit&) {
  if (!queue_.pvt().isOpen()) return outsidePvt("PVTExit");
  for (QueueEntry& entry : queue_.pvt().close()) queue_.push(std::move(entry));
  return done();
}

tm_script::CallAnswer ScriptCommands::execute(const script::PvtPause&) {
  queue_.pause(now_, Holder::Pvt);
  return done();
}

tm_script::CallAnswer ScriptCommands::execute(const script::PvtResume&) {
  queue_.resume(now_, Holder::Pvt);
  return done();
}

tm_script::CallAnswer ScriptCommands::execute(const script::ContinueVJog&) {
  if (auto failure = withinPvt("ContinueVJog")) return *failure;
  queue_.push(VelocityMode{false, std::nullopt, std::nullopt});
  return done();
}

tm_script::CallAnswer ScriptCommands::execute(const script::ContinueVLine& mode) {
  if (auto failure = withinPvt("ContinueVLine")) return *failure;
  queue_.push(VelocityMode{true, limit(mode.zero_timeout), limit(mode.stop_timeout)});
  return done();
}

tm_script::CallAnswer ScriptCommands::set(const Velocity& velocity) {
  if (auto complaint = queue_.setVelocity(velocity, now_)) {
    return tm_script::CallFailure{std::move(*complaint)};
  }
  return done();
}

tm_script::CallAnswer ScriptCommands::execute(const script::SetContinueVJog& velocity) {
  return set(Velocity(arm::toJointVector(velocity.velocity)));
}

tm_script::CallAnswer ScriptCommands::execute(const script::SetContinueVLine& velocity) {
  const auto& [x, y, z, rx, ry, rz] = velocity.velocity;
  return set(Velocity(
      motion::TcpVelocity{{mmToM(x), mmToM(y), mmToM(z)}, {degToRad(rx), degToRad(ry), degToRad(rz)}}));
}

tm_script::CallAnswer ScriptCommands::execute(const script::StopContinueVmode&) {
  queue_.endVelocity(now_);
  return done();
}

tm_script::CallAnswer ScriptCommands::execute(const script::SuspendContinueVmode&) {
  queue_.suspendVelocity(now_);
  return done();
}

tm_script::CallAnswer ScriptCommands::perform(const script::ScriptCommand& command) {
  const bool is_point = std::holds_alternative<script::PvtPoint>(command);
  if (isQueued(command) && (is_point ? room().points : room().entries) == 0) return full();
  return std::visit([this](const auto& what) { return execute(what); }, command);
}

}  // namespace cobot_command::simulator
