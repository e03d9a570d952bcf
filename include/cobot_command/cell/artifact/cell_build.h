// Builds a verified artifact from a cell file, stage by stage.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "cobot_command/cell/artifact/artifact.h"
#include "cobot_command/cell/model/cell_model.h"
#include "cobot_command/cell/program/cell.h"
#include "cobot_command/cell/splitting/split_cell.h"
#include "cobot_command/cell/zones/soundness.h"
#include "cobot_command/common/result.h"

namespace cobot_command::cell {

enum class BuildStage {
  Plan,        ///< all steps
  Sweep,       ///< claims
  Zones,       ///< zones and holds
  Split,       ///< cuts motions before they enter a zone, and repeats all stages above
  Soundness,   ///< checks whether the zones are sufficient
  Instrument,  ///< creates events and automata
  Synthesize,
  Verify  ///< verifies the artifact read back from its bytes
};
inline constexpr BuildStage kBuildStages[] = {
    BuildStage::Plan,      BuildStage::Sweep,      BuildStage::Zones,      BuildStage::Split,
    BuildStage::Soundness, BuildStage::Instrument, BuildStage::Synthesize, BuildStage::Verify};
[[nodiscard]] const char* toString(BuildStage stage);

class CellBuild {
 public:
  /// Policy::Supervisor, or SafeOrder if requested.
  CellBuild(Cell cell, Policy policy, unsigned threads);

  /// Runs the next stage. Any fault, a sentence, ends the build. Precondition: the previous stage had no
  /// fault.
  [[nodiscard]] std::vector<std::string> run(BuildStage stage);
  /// The results of a stage, one line each. Precondition: the stage was run.
  [[nodiscard]] std::vector<std::string> report(BuildStage stage) const;

  [[nodiscard]] const Cell& cell() const { return cell_; }
  [[nodiscard]] const std::vector<Zone>& zones() const { return zones_; }
  [[nodiscard]] const std::vector<RobotClaim>& claims() const { return claims_; }
  [[nodiscard]] const CellModel& model() const { return model_; }
  /// The results up to this point. Precondition: all stages up to Instrument were run.
  [[nodiscard]] Artifact artifact() const;
  /// Precondition: all stages up to Synthesize were run.
  [[nodiscard]] const std::string& bytes() const { return bytes_; }

 private:
  [[nodiscard]] std::vector<std::string> plan();
  [[nodiscard]] std::vector<std::string> sweep();
  [[nodiscard]] std::vector<std::string> findZonesAndHolds();
  [[nodiscard]] std::vector<std::string> split();
  [[nodiscard]] std::vector<std::string> synthesize();
  [[nodiscard]] std::vector<std::string> verify();
  [[nodiscard]] ArtifactRobot robotOf(RobotIndex robot) const;
  [[nodiscard]] ArtifactPath pathOf(RobotIndex robot, std::size_t index) const;
  /// `user`: its index in the program, after the robots.
  [[nodiscard]] ArtifactMechanism mechanismOf(const Mechanism& mechanism, RobotIndex user) const;
  [[nodiscard]] std::vector<ZoneIndex> touchedBy(const Piece& piece, RobotIndex user) const;
  [[nodiscard]] std::vector<std::string> reportPlan() const;
  [[nodiscard]] std::vector<std::string> reportSweep() const;
  [[nodiscard]] std::vector<std::string> reportZones() const;
  [[nodiscard]] std::vector<std::string> reportSupervisors() const;

  Cell cell_;
  std::string hash_;  ///< of the cell as given, before cutting
  Policy policy_;
  unsigned threads_;
  std::vector<PlannedRobot> planned_;
  std::vector<RobotClaim> claims_;
  std::vector<Zone> zones_;
  HeldCell held_;
  std::vector<CutReport> cuts_;
  Soundness soundness_;
  CellModel model_;
  std::vector<PartSupervisor> supervisors_;
  std::string bytes_;
  std::vector<automata::Verification> verified_;
};

}  // namespace cobot_command::cell
