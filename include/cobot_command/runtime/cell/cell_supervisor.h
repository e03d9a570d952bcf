// The supervisor of a cell with its files: the artifact on which its decisions are based, and its journal on
// a disk.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "cobot_command/cell/artifact/artifact.h"
#include "cobot_command/cell/model/supervisors.h"
#include "cobot_command/cell/supervision/supervision.h"
#include "cobot_command/common/result.h"

namespace cobot_command::runtime {

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

/// For one thread, which owns it.
class CellSupervisor {
 public:
  /// An error is a sentence: a file that is unreadable, damaged or of another cell; a journal that another
  /// process uses; no schedule within ten seconds.
  [[nodiscard]] static Result<std::unique_ptr<CellSupervisor>, std::string> open(const SupervisorFiles& files,
                                                                                 Deciding deciding);
  ~CellSupervisor();
  CellSupervisor(const CellSupervisor&) = delete;
  CellSupervisor& operator=(const CellSupervisor&) = delete;

  [[nodiscard]] const cell::Artifact& artifact() const { return artifact_; }
  [[nodiscard]] cell::Supervision& core() { return *core_; }

 private:
  CellSupervisor(cell::Artifact artifact, cell::Rules rules, cell::ZoneOrders turns,
                 std::unique_ptr<JournalFile> journal);

  cell::Artifact artifact_;
  std::unique_ptr<JournalFile> journal_;
  std::unique_ptr<cell::Supervision> core_;
};

}  // namespace cobot_command::runtime
