// Runs scripts, strictly one after the other in order of arrival, line by line.
//
// A line that waits holds the reply of its script and all scripts behind it. Lines that move only queue; what
// becomes of them is the motion queue's business.
#pragma once

#include <deque>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "queue/motion_queue.h"
#include "robot/io_board.h"
#include "robot/project_data.h"
#include "script_port/environment.h"
#include "script_port/script_clients.h"
#include "script_port/tag_table.h"

#include "cobot_command/script/script_command.h"
#include "cobot_command/simulator/settings.h"
#include "cobot_command/tm_script/checker.h"
#include "cobot_command/tm_script/interpreter.h"

namespace cobot_command::simulator {

/// A script as it arrived.
struct PendingScript {
  ClientId client = 0;
  std::string id;
  tm_script::ParsedScript script;
  std::vector<int> spoiled{};  ///< lines that a fault refuses
};

class ScriptInterpreter {
 public:
  /// The robot, as scripts find it.
  struct Robot {
    const arm::ArmModel& model;
    MotionQueue& queue;
    IoBoard& io;
    ProjectData& project;
    std::function<RobotState()> state;
  };

  ScriptInterpreter(const Settings& settings, Robot robot, TagTable& tags, FaultSwitches& faults,
                    ScriptClients& clients, Outbox& outbox);
  ScriptInterpreter(const ScriptInterpreter&) = delete;
  ScriptInterpreter& operator=(const ScriptInterpreter&) = delete;

  /// What waits is bounded, so that no client can fill the memory: as many scripts, and as many items in the
  /// queue of motions. A line that does not fit is a faulty line.
  static constexpr std::size_t kMostWaiting = 1000;

  /// Takes a script; when too many wait it is answered ERROR for its first line.
  void add(PendingScript script);
  /// With the variables that there are now.
  [[nodiscard]] tm_script::Findings check(const tm_script::ParsedScript& script);

  enum class Step { Waits, Ran, Exited };
  /// Runs one script as far as it goes. Waits: there is none, or its line has to wait. Exited: a ScriptExit
  /// was executed.
  [[nodiscard]] Step run(Instant now);
  /// When a wait runs out; Instant::max() without one.
  [[nodiscard]] Instant nextEvent() const;

  /// The line that waits for a tag, if any, waits no longer.
  void releaseWait();
  /// The script that runs ends here, and is answered OK: it was accepted.
  void endCurrent();
  /// Takes all scripts that have not begun; nobody answers them.
  [[nodiscard]] std::deque<PendingScript> takePending();
  /// Forgets all scripts, without an answer.
  void clear();

  /// Local variables live as long as the flow stays in the Listen node.
  void forgetVariables() { locals_.clear(); }

 private:
  struct Running {
    ClientId client = 0;
    std::string id;
    std::vector<int> warnings;
    tm_script::Interpreter script;
  };
  struct Wait {
    std::optional<QueuedTag> tag;
    Instant until;
    bool is_question = false;  ///< WaitQueueTag: whether the tag is complete
    bool is_released = false;
  };

  bool begin();
  void end(bool accepted, std::vector<int> lines);
  [[nodiscard]] tm_script::Findings findingsOf(const PendingScript& script);
  [[nodiscard]] bool waits(Instant now) const;
  void resumeWaiting();
  [[nodiscard]] tm_script::Scope scope() { return {locals_, robot_.project.variables}; }
  tm_script::CallAnswer perform(const script::ScriptCommand& command);
  [[nodiscard]] bool isFull() const { return robot_.queue.size() >= kMostWaiting; }

  template <class Motion>
  tm_script::CallAnswer execute(const Motion& motion);
  tm_script::CallAnswer execute(const script::ChangeBase& change);
  tm_script::CallAnswer execute(const script::ChangeTcp& change);
  tm_script::CallAnswer execute(const script::ChangeLoad& change);
  tm_script::CallAnswer execute(const script::QueueTag& tag);
  tm_script::CallAnswer execute(const script::WaitQueueTag& wait);
  tm_script::CallAnswer execute(const script::StopAndClearBuffer& stop);
  tm_script::CallAnswer execute(const script::Pause& pause);
  tm_script::CallAnswer execute(const script::Resume& resume);
  tm_script::CallAnswer execute(const script::ScriptExit& exit);
  tm_script::CallAnswer execute(const script::WriteOutput& write);
  tm_script::CallAnswer execute(const script::WriteAnalogOutput& write);
  tm_script::CallAnswer execute(const script::PvtEnter& enter);  // from here on: script_modes.cpp
  tm_script::CallAnswer execute(const script::PvtPoint& point);
  tm_script::CallAnswer execute(const script::PvtExit& exit);
  tm_script::CallAnswer execute(const script::PvtPause& pause);
  tm_script::CallAnswer execute(const script::PvtResume& resume);
  tm_script::CallAnswer execute(const script::ContinueVJog& mode);
  tm_script::CallAnswer execute(const script::ContinueVLine& mode);
  tm_script::CallAnswer execute(const script::SetContinueVJog& set);
  tm_script::CallAnswer execute(const script::SetContinueVLine& set);
  tm_script::CallAnswer execute(const script::StopContinueVmode& stop);
  tm_script::CallAnswer execute(const script::SuspendContinueVmode& suspend);
  tm_script::CallAnswer set(const Velocity& velocity);
  /// What stands between PVTEnter and PVTExit does not run before the PVT has all its points.
  [[nodiscard]] std::optional<tm_script::CallFailure> withinPvt(const char* what) const;

  Robot robot_;
  TagTable& tags_;
  FaultSwitches& faults_;
  ScriptClients& clients_;
  Outbox& outbox_;
  tm_script::Version tmflow_;
  tm_script::FunctionTable functions_;
  tm_script::Variables locals_;
  ScriptEnvironment environment_;

  Instant now_{};
  std::deque<PendingScript> pending_;
  std::optional<Running> running_;
  std::optional<Wait> wait_;
  bool exited_ = false;
};

}  // namespace cobot_command::simulator
