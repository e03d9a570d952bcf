// A mechanism's own side of its cell: as a robot's, for what moves along or about one axis (cell.md, M3).
//
// Whoever drives the mechanism, a PLC say, tells where it is, and moves it to nothing but the target that
// this permits. Pure: events and the time in, target and reports out. One thread owns it.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "cobot_command/cell/artifact/artifact.h"
#include "cobot_command/cell/supervision/cell_state.h"
#include "cobot_command/cell/supervision/report.h"
#include "cobot_command/common/result.h"
#include "cobot_command/common/time.h"

namespace cobot_command::cell {

class MechanismAgent {
 public:
  /// `session`: drawn anew at each start of its node, above 0. A fault is a sentence: there is no such
  /// mechanism in the artifact.
  [[nodiscard]] static Result<std::unique_ptr<MechanismAgent>, std::string> of(
      std::shared_ptr<const Artifact> artifact, const std::string& mechanism, std::uint64_t session);
  ~MechanismAgent();

  // --- What happens.
  /// It is at that position [m or rad], as measured.
  void measure(double position, bool moving, Instant now);
  /// The supervisor tells how things stand; `number`: of its states.
  void hear(const CellStatus& state, std::uint64_t number, Instant now);
  /// Whether it sets out on the paths of its program, one after the other; false from the start. What was
  /// begun goes to its end.
  void run(bool on);
  /// It has to stay where it is, until it was recovered.
  void stop();

  // --- What follows.
  /// Where it has to go, or to stay, now [m or rad]; nothing: it was not measured yet.
  [[nodiscard]] std::optional<double> target() const;
  /// That is to be told now; nothing: there is nothing new, and the period is not over.
  [[nodiscard]] std::optional<RobotReport> takeReport(Instant now);
  [[nodiscard]] Instant nextReport() const;
  /// In its program: "OUT", or "FEED +1".
  [[nodiscard]] const std::string& place() const;
  [[nodiscard]] int cyclesDone() const;

 private:
  class Parts;
  explicit MechanismAgent(std::unique_ptr<Parts> parts);

  std::unique_ptr<Parts> parts_;
};

}  // namespace cobot_command::cell
