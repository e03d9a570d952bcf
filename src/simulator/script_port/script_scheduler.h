// Runs scripts, strictly one after the other in order of arrival, line by line.
//
// A line that waits holds the reply of its script and all scripts behind it. Lines that move only queue; what
// becomes of them is the motion queue's business.
#pragma once

#include <deque>
#include <optional>
#include <string>
#include <vector>

#include "robot/project_data.h"
#include "script_port/script_clients.h"
#include "script_port/script_environment.h"
#include "script_port/tag_table.h"

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

class ScriptScheduler {
 public:
  ScriptScheduler(const Settings& settings, const ScriptedRobot& robot, TagTable& tags, FaultSwitches& faults,
                  ScriptClients& clients, Outbox& outbox);
  ScriptScheduler(const ScriptScheduler&) = delete;
  ScriptScheduler& operator=(const ScriptScheduler&) = delete;

  /// Bounded, so that no client can fill the memory.
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

  bool begin();
  void end(bool accepted, std::vector<int> lines);
  [[nodiscard]] tm_script::Findings findingsOf(const PendingScript& script);
  [[nodiscard]] bool waits(Instant now) const;
  void resumeWaiting();
  [[nodiscard]] tm_script::Scope scope() { return {locals_, project_.variables}; }

  ProjectData& project_;
  TagTable& tags_;
  ScriptClients& clients_;
  Outbox& outbox_;
  tm_script::FunctionTable functions_;
  tm_script::Variables locals_;
  ScriptEnvironment environment_;

  std::deque<PendingScript> pending_;
  std::optional<Running> running_;
  std::optional<LineWait> wait_;
};

}  // namespace cobot_command::simulator
