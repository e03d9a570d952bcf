// The agent of a mechanism in its cell: as that of a robot, for bodies that move along or about one axis
// (doc/cell.md).
//
// The drive of the mechanism, such as a PLC, reports its position, and moves it only to the target that this
// agent permits. Pure: its inputs are events and the time, its outputs the target and reports. Owned by one
// thread.
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
  /// `session`: random number above 0, new at each start of its node. A fault is a sentence: the artifact has
  /// no such mechanism.
  [[nodiscard]] static Result<std::unique_ptr<MechanismAgent>, std::string> of(
      std::shared_ptr<const Artifact> artifact, const std::string& mechanism, std::uint64_t session);
  ~MechanismAgent();

  // --- Inputs.
  /// The measured position [m or rad].
  void measure(double position, bool moving, Instant now);
  /// A state of the supervisor was received; `number`: sequence number of the state.
  void hear(const CellStatus& state, std::uint64_t number, Instant now);
  /// True: it runs the paths of its program, one after the other; initially false. A started path runs to its
  /// end.
  void run(bool on);
  /// It must stay where it is until it is recovered.
  void stop();

  // --- Outputs.
  /// The position to move to, or to stay at, now [m or rad]; std::nullopt: not measured yet.
  [[nodiscard]] std::optional<double> target() const;
  /// The report to send now; std::nullopt: nothing is new, and the period is not over.
  [[nodiscard]] std::optional<RobotReport> takeReport(Instant now);
  [[nodiscard]] Instant nextReport() const;
  /// Its place in the program: "OUT", or "FEED +1".
  [[nodiscard]] const std::string& place() const;
  [[nodiscard]] int cyclesDone() const;

 private:
  class Parts;
  explicit MechanismAgent(std::unique_ptr<Parts> parts);

  std::unique_ptr<Parts> parts_;
};

}  // namespace cobot_command::cell
