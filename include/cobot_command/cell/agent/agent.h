// A robot's own side of its cell: knows how far its program is, asks the supervisor for what comes next,
// lets each frame leave only with its permit, and tells of releases only what is measured (cell.md,
// section 6).
//
// It leads the run_program goals of the robot's command core, and is the gate of that core. Pure: events and
// the time in, reports out. One thread owns it, the core's.
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
  /// `session`: drawn anew at each start of the robot's node, above 0. A fault is a sentence: there is no
  /// such robot in the artifact.
  [[nodiscard]] static Result<std::shared_ptr<Agent>, std::string> of(
      std::shared_ptr<const Artifact> artifact, const std::string& robot, std::uint64_t session);
  ~Agent() override;

  // --- What happens.
  /// A frame of the status stream.
  void observe(const link::RobotStatus& status, Instant now);
  /// Why nothing can be sent to the robot; empty: it can.
  void linked(const std::string& why_not, Instant now);
  /// The supervisor tells how things stand; `number`: of its states.
  void hear(const CellStatus& state, std::uint64_t number, Instant now);
  void advance(Instant now);

  /// The gate of the robot's core.
  [[nodiscard]] std::optional<blocks::Failure> objectionTo(const command::Departure& departure,
                                                           Instant now) const;

  /// The supervisor listens to it.
  [[nodiscard]] bool isLetIn() const;

  /// That is to be told now; nothing: there is nothing new, and the period is not over.
  [[nodiscard]] std::optional<RobotReport> takeReport(Instant now);
  /// When advance() and takeReport() have something to do, if nothing else happens before.
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
