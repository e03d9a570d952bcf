// The supervisor of a cell with its files and its thread: the artifact on which its decisions are based, and
// its journal on a disk.
//
// Each decision is written to the journal before it counts, and the disk may take long or hang. Therefore
// decisions have a thread of their own, and the caller's thread never waits for it.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "cobot_command/cell/artifact/artifact.h"
#include "cobot_command/cell/model/supervisors.h"
#include "cobot_command/cell/supervision/supervision.h"
#include "cobot_command/common/result.h"

namespace cobot_command::runtime {

class CoreThread;
class JournalFile;

struct SupervisorFiles {
  std::string artifact;  ///< written by `tm_cell build`
  std::string journal;   ///< created if it does not exist
  /// The cell file from which the artifact must be built; empty: not compared.
  std::string cell_file;
};

/// What makes the decisions.
enum class Deciding {
  AsBuilt,  ///< the policy for which the artifact was built
  Supervisor,
  SafeOrder,
  /// As built; in addition robots use the zones in turns, in the order of the shortest cycle of all robots.
  Schedule
};

class CellSupervisor {
 public:
  using Task = std::function<void(cell::Supervision& core)>;
  using Stop = std::function<void(const cell::StopOrder& order)>;

  /// An error is a sentence: a file that is unreadable, damaged or of another cell; a journal that another
  /// process uses; no schedule within ten seconds.
  [[nodiscard]] static Result<std::unique_ptr<CellSupervisor>, std::string> open(const SupervisorFiles& files,
                                                                                 Deciding deciding);
  ~CellSupervisor();
  CellSupervisor(const CellSupervisor&) = delete;
  CellSupervisor& operator=(const CellSupervisor&) = delete;

  [[nodiscard]] const cell::Artifact& artifact() const { return artifact_; }

  /// Starts the thread. `stop` is called on it, before the journal is written, so it must not wait.
  void start(Stop stop);
  /// Runs the task on the thread of the decisions, after those posted before. Thread-safe. False, and it
  /// never runs: after finish().
  bool post(Task task);
  /// The same, before all tasks that are not urgent.
  bool postUrgent(Task task);
  /// Waits for the running task and those posted before; nothing runs on the thread after it returns.
  void finish();

 private:
  CellSupervisor(cell::Artifact artifact, cell::Rules rules, cell::ZoneOrders turns,
                 std::unique_ptr<JournalFile> journal);

  cell::Artifact artifact_;
  std::unique_ptr<JournalFile> journal_;
  Stop stop_;
  std::unique_ptr<cell::Supervision> core_;
  std::unique_ptr<CoreThread> thread_;  // last: its tasks need all the others
};

}  // namespace cobot_command::runtime
