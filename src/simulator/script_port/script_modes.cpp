// What the lines of a PVT, and those that set velocities, do.
#include <chrono>
#include <string>

#include "script_port/script_interpreter.h"

#include "cobot_command/arm/controller_pose.h"
#include "cobot_command/common/units.h"

namespace cobot_command::simulator {

namespace {

tm_script::CallAnswer done() {
  return tm_script::Value(tm_script::Scalar(true));
}

tm_script::CallAnswer outsidePvt(const std::string& what) {
  return tm_script::CallFailure{what + " stands behind a PVTEnter"};
}

std::optional<Duration> limit(int milliseconds) {
  return milliseconds > 0 ? std::optional<Duration>(std::chrono::milliseconds(milliseconds)) : std::nullopt;
}

}  // namespace

std::optional<tm_script::CallFailure> ScriptInterpreter::withinPvt(const char* what) const {
  if (!robot_.queue.pvt().isOpen()) return std::nullopt;
  return tm_script::CallFailure{std::string(what) + " cannot stand between PVTEnter and PVTExit"};
}

tm_script::CallAnswer ScriptInterpreter::execute(const script::PvtEnter& enter) {
  if (auto failure = withinPvt("another PVTEnter")) return *failure;
  robot_.queue.pvt().open(enter.cartesian);
  return done();
}

tm_script::CallAnswer ScriptInterpreter::execute(const script::PvtPoint& point) {
  if (!robot_.queue.pvt().isOpen()) return outsidePvt("PVTPoint");
  robot_.queue.pvt().add(point);
  return done();
}

tm_script::CallAnswer ScriptInterpreter::execute(const script::PvtExit&) {
  if (!robot_.queue.pvt().isOpen()) return outsidePvt("PVTExit");
  robot_.queue.closePvt();
  return done();
}

tm_script::CallAnswer ScriptInterpreter::execute(const script::PvtPause&) {
  robot_.queue.pause(now_, Holder::Pvt);
  return done();
}

tm_script::CallAnswer ScriptInterpreter::execute(const script::PvtResume&) {
  robot_.queue.resume(now_, Holder::Pvt);
  return done();
}

tm_script::CallAnswer ScriptInterpreter::execute(const script::ContinueVJog&) {
  if (auto failure = withinPvt("ContinueVJog")) return *failure;
  robot_.queue.push(VelocityMode{false, std::nullopt, std::nullopt});
  return done();
}

tm_script::CallAnswer ScriptInterpreter::execute(const script::ContinueVLine& mode) {
  if (auto failure = withinPvt("ContinueVLine")) return *failure;
  robot_.queue.push(VelocityMode{true, limit(mode.zero_timeout), limit(mode.stop_timeout)});
  return done();
}

tm_script::CallAnswer ScriptInterpreter::set(const Velocity& velocity) {
  if (auto complaint = robot_.queue.setVelocity(velocity, now_)) {
    return tm_script::CallFailure{std::move(*complaint)};
  }
  return done();
}

tm_script::CallAnswer ScriptInterpreter::execute(const script::SetContinueVJog& velocity) {
  return set(Velocity(arm::toJointVector(velocity.velocity)));
}

tm_script::CallAnswer ScriptInterpreter::execute(const script::SetContinueVLine& velocity) {
  const auto& [x, y, z, rx, ry, rz] = velocity.velocity;
  return set(Velocity(
      motion::TcpVelocity{{mmToM(x), mmToM(y), mmToM(z)}, {degToRad(rx), degToRad(ry), degToRad(rz)}}));
}

tm_script::CallAnswer ScriptInterpreter::execute(const script::StopContinueVmode&) {
  robot_.queue.endVelocity(now_);
  return done();
}

tm_script::CallAnswer ScriptInterpreter::execute(const script::SuspendContinueVmode&) {
  robot_.queue.suspendVelocity(now_);
  return done();
}

}  // namespace cobot_command::simulator
