// Runs scripts, strictly one after the other in order of arrival, line by line.
//
// A line that waits holds the reply of its script and all scripts behind it. Lines that move only queue; what
// becomes of them is the motion queue's business.
#pragma once

#include <deque>
#include <optional>
#include <string>
#include <vector>

#include "io_board.h"
#include "motion_queue.h"
#include "script_clients.h"
#include "tag_table.h"

#include "cobot_command/protocol/script_command.h"
#include "cobot_command/simulator/settings.h"

namespace cobot_command::simulator {

/// A script as it arrived.
struct PendingScript {
  ClientId client = 0;
  std::string id;
  Result<protocol::ParsedScript, std::vector<protocol::ScriptFault>> parsed;
};

class ScriptInterpreter {
 public:
  ScriptInterpreter(const Settings& settings, MotionQueue& queue, IoBoard& io, TagTable& tags,
                    FaultSwitches& faults, ScriptClients& clients)
      : settings_(settings), queue_(queue), io_(io), tags_(tags), faults_(faults), clients_(clients) {}

  /// What waits is bounded, so that no client can fill the memory: as many scripts, and as many items in the
  /// queue of motions. A line that does not fit is a faulty line.
  static constexpr std::size_t kMostWaiting = 1000;

  /// Takes a script; when too many wait it is answered ERROR for its first line.
  void add(PendingScript script);

  enum class Step { Waits, Ran, Exited };
  /// Runs one script as far as it goes. Waits: there is none, or its line has to wait. Exited: a ScriptExit
  /// was executed.
  [[nodiscard]] Step run(Instant now);
  /// When a wait runs out; Instant::max() without one.
  [[nodiscard]] Instant nextEvent() const;

  /// The line that waits, if any, waits no longer.
  void releaseWait();
  /// The script that runs ends here, and is answered OK: it was accepted.
  void endCurrent();
  /// Takes all scripts that have not begun; nobody answers them.
  [[nodiscard]] std::deque<PendingScript> takePending();
  /// Forgets everything, without an answer.
  void clear();

 private:
  struct Running {
    ClientId client = 0;
    std::string id;
    std::vector<protocol::ParsedScript::Line> lines;
    std::size_t next = 0;
  };
  struct Wait {
    QueuedTag tag;
    Instant until;
  };

  bool begin();
  [[nodiscard]] std::vector<int> faultyLines(const PendingScript& script) const;
  [[nodiscard]] bool waits(Instant now) const;
  [[nodiscard]] bool isExecutable(const protocol::ScriptCommand& command) const;
  [[nodiscard]] std::optional<arm::Pose> baseNamed(const std::string& name) const;
  [[nodiscard]] std::optional<arm::Pose> tcpNamed(const std::string& name) const;

  template <class Motion>
  void execute(const Motion& motion, Instant) {
    queue_.push(MotionRequest(motion));
  }
  void execute(const protocol::ChangeBase& change, Instant now);
  void execute(const protocol::ChangeTcp& change, Instant now);
  void execute(const protocol::ChangeLoad& change, Instant now);
  void execute(const protocol::QueueTag& tag, Instant now);
  void execute(const protocol::WaitQueueTag& wait, Instant now);
  void execute(const protocol::StopAndClearBuffer& stop, Instant now);
  void execute(const protocol::Pause& pause, Instant now);
  void execute(const protocol::Resume& resume, Instant now);
  void execute(const protocol::ScriptExit& exit, Instant now);
  void execute(const protocol::WriteOutput& write, Instant now);

  const Settings& settings_;
  MotionQueue& queue_;
  IoBoard& io_;
  TagTable& tags_;
  FaultSwitches& faults_;
  ScriptClients& clients_;
  std::deque<PendingScript> pending_;
  std::optional<Running> running_;
  std::optional<Wait> wait_;
  bool exited_ = false;
};

}  // namespace cobot_command::simulator
