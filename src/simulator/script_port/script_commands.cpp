// What the commands of a script do.
#include <algorithm>
#include <chrono>

#include "robot/tmflow_version.h"
#include "script_port/script_interpreter.h"

#include "cobot_command/arm/controller_pose.h"
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

}  // namespace

tm_script::CallAnswer ScriptInterpreter::perform(const script::ScriptCommand& command) {
  if (isQueued(command) && isFull()) return full();
  return std::visit([this](const auto& what) { return execute(what); }, command);
}

template <class Motion>
tm_script::CallAnswer ScriptInterpreter::execute(const Motion& motion) {
  if (auto failure = withinPvt("another motion")) return *failure;
  robot_.queue.push(MotionRequest(motion));
  return done();
}

tm_script::CallAnswer ScriptInterpreter::execute(const script::ChangeBase& change) {
  if (const auto* name = std::get_if<std::string>(&change.base)) {
    robot_.queue.push(BaseChange{robot_.project.bases.at(*name).now.pose, *name});
  } else {
    robot_.queue.push(BaseChange{arm::toPose(std::get<script::SixNumbers>(change.base)), ""});
  }
  return done();
}

tm_script::CallAnswer ScriptInterpreter::execute(const script::ChangeTcp& change) {
  if (const auto* name = std::get_if<std::string>(&change.tcp)) {
    const Tool& tool = robot_.project.tools.at(*name).now;
    robot_.queue.push(TcpChange{tool.frame.pose, *name, double{tool.mass}, inertiaOf(tool)});
  } else {
    robot_.queue.push(
        TcpChange{arm::toPose(std::get<script::SixNumbers>(change.tcp)), "", change.weight, change.inertia});
  }
  return done();
}

tm_script::CallAnswer ScriptInterpreter::execute(const script::ChangeLoad& change) {
  robot_.queue.push(LoadChange{change.weight});
  return done();
}

tm_script::CallAnswer ScriptInterpreter::execute(const script::QueueTag& tag) {
  if (tag.wait) {
    if (auto failure = withinPvt("a wait for a tag")) return *failure;
  }
  QueuedTag queued = tags_.add(tag.tag);
  queued.reported = faults_.early_tag.take();
  if (queued.reported) clients_.broadcast(protocol::TagReport{tag.tag, protocol::TagState::Complete});
  robot_.queue.push(queued);
  if (!tag.wait) return done();
  wait_ = Wait{queued, Instant::max()};
  return tm_script::Wait{};
}

// To 1.80 a time of 0 or less is no limit; from 1.82 on only one below 0 is, and tag 0 waits for nothing but
// the time.
tm_script::CallAnswer ScriptInterpreter::execute(const script::WaitQueueTag& wait) {
  constexpr int kUnknown = -1;
  const bool is_new = !(tmflow_ < kPriorityCommands);
  const std::optional<QueuedTag> tag = tags_.latest(wait.tag);
  if (!tag && !(is_new && wait.tag == 0)) return tm_script::Value(tm_script::Scalar(kUnknown));
  const int timeout = wait.timeout.value_or(-1);
  const bool is_limited = is_new ? timeout >= 0 : timeout > 0;
  wait_ = Wait{tag, is_limited ? now_ + std::chrono::milliseconds(timeout) : Instant::max(), true};
  return tm_script::Wait{};
}

tm_script::CallAnswer ScriptInterpreter::execute(const script::StopAndClearBuffer&) {
  if (!faults_.ignore_stop.take()) robot_.queue.stop(now_);
  return done();
}

tm_script::CallAnswer ScriptInterpreter::execute(const script::Pause&) {
  robot_.queue.pause(now_);
  return done();
}

tm_script::CallAnswer ScriptInterpreter::execute(const script::Resume&) {
  robot_.queue.resume(now_);
  return done();
}

tm_script::CallAnswer ScriptInterpreter::execute(const script::ScriptExit&) {
  exited_ = true;
  return tm_script::EndScript{tm_script::Scalar(true)};
}

tm_script::CallAnswer ScriptInterpreter::execute(const script::WriteOutput& write) {
  if (write.instant) {
    robot_.io.write(write);
  } else {
    robot_.queue.push(write);
  }
  return done();
}

tm_script::CallAnswer ScriptInterpreter::execute(const script::WriteAnalogOutput& write) {
  if (write.instant) {
    robot_.io.write(write);
  } else {
    robot_.queue.push(write);
  }
  return done();
}

}  // namespace cobot_command::simulator
