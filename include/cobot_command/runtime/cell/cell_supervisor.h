// The supervisor of a cell with its files: the artifact that it decides by, and its journal on a disk.
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
  std::string artifact;   ///< as `tm_cell build` has written it
  std::string journal;    ///< made where there is none
  std::string cell_file;  ///< what the artifact has to be made of; empty: not compared
};

/// What decides.
enum class Deciding {
  AsBuilt,  ///< what the artifact was built for
  Supervisor,
  SafeOrder,
  Schedule  ///< as built; beside that robots take turns on the zones, by the shortest cycle of all
};

/// One thread owns it.
class CellSupervisor {
 public:
  /// A fault is a sentence: a file that cannot be read, that is damaged, or of another cell; a journal that
  /// another process has; no schedule within ten seconds.
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
