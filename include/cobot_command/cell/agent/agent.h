// The agent of a robot in its cell. It tracks the robot's place in the program, requests the next events from
// the supervisor, permits each frame only with its grant, and reports a release only when it is measured
// (doc/cell.md).
//
// It guides the run_program goals of the robot's command core, and is the gate of that core. Pure: its inputs
// are events and the time, its outputs reports. Owned by one thread, that of the core.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cobot_command/blocks/programs/program_guide.h"
#include "cobot_command/cell/artifact/artifact.h"
#include "cobot_command/cell/supervision/cell_state.h"
#include "cobot_command/cell/supervision/report.h"
#include "cobot_command/command/gate.h"
#include "cobot_command/common/result.h"
#include "cobot_command/common/time.h"
#include "cobot_command/link/robot_status.h"

namespace cobot_command::cell {

class Agent final : public blocks::ProgramGuide {
 public:
  /// `session`: random number above 0, new at each start of the robot's node. A fault is a sentence: the
  /// artifact has no such robot.
  [[nodiscard]] static Result<std::shared_ptr<Agent>, std::string> of(
      std::shared_ptr<const Artifact> artifact, const std::string& robot, std::uint64_t session);
  ~Agent() override;

  // --- Inputs.
  /// A frame of the status stream.
  void observe(const link::RobotStatus& status, Instant now);
  /// Why nothing can be sent to the robot; empty: sending is possible.
  void linked(const std::string& why_not, Instant now);
  /// A state of the supervisor was received; `number`: sequence number of the state.
  void hear(const CellStatus& state, std::uint64_t number, Instant now);
  void advance(Instant now);

  /// The gate of the robot's core.
  [[nodiscard]] std::optional<blocks::Failure> objectionTo(const command::Departure& departure,
                                                           Instant now) const;

  /// True if the supervisor has admitted the robot.
  [[nodiscard]] bool isLetIn() const;

  /// The report to send now; std::nullopt: nothing is new, and the period is not over.
  [[nodiscard]] std::optional<RobotReport> takeReport(Instant now);
  /// The time of the next advance() and takeReport(), if nothing else happens before.
  [[nodiscard]] Instant nextReport() const;

  // --- run_program.
  [[nodiscard]] std::optional<blocks::Failure> objectionTo(
      const blocks::ProgramRequest& request) const override;
  [[nodiscard]] std::optional<blocks::Failure> begin(const blocks::ProgramRequest& request,
                                                     Instant now) override;
  [[nodiscard]] const blocks::ProgramFrame* permitted() const override;
  void sent(Instant now) override;
  void refused(Instant now) override;
  void done(Instant now) override;
  [[nodiscard]] bool isOver() const override;
  [[nodiscard]] const std::optional<blocks::Failure>& failure() const override;
  [[nodiscard]] bool stopsRobot() const override;
  void finish() override;
  std::vector<Duration> end(Instant now) override;
  [[nodiscard]] blocks::ProgramStand stand(Instant now) const override;
  [[nodiscard]] std::optional<Instant> nextDeadline() const override;

 private:
  class Parts;
  explicit Agent(std::unique_ptr<Parts> parts);

  std::unique_ptr<Parts> parts_;
};

}  // namespace cobot_command::cell
