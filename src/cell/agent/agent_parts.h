// What an agent is made of.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "agent/itinerary.h"
#include "agent/path_tracker.h"
#include "agent/program_walk.h"
#include "agent/readiness.h"
#include "agent/state_watch.h"
#include "agent/whereabouts.h"

#include "cobot_command/blocks/programs/cycle_waits.h"
#include "cobot_command/cell/agent/agent.h"
#include "cobot_command/cell/model/cell_model.h"
#include "cobot_command/robot/robot_watch.h"

namespace cobot_command::cell {

class Agent::Parts {
 public:
  Parts(std::shared_ptr<const Artifact> artifact, CellModel model, RobotIndex robot, std::uint64_t session,
        ZoneWatch zones);

  void observe(const link::RobotStatus& status, Instant now);
  void linked(const std::string& why_not, Instant now);
  void hear(const CellStatus& state, std::uint64_t number, Instant now);
  /// All that follows from what is known now.
  void settle(Instant now);
  [[nodiscard]] std::optional<blocks::Failure> objectionTo(const command::Departure& departure,
                                                           Instant now) const;
  [[nodiscard]] std::optional<RobotReport> takeReport(Instant now);
  [[nodiscard]] Instant nextReport() const;

  [[nodiscard]] bool isJoined() const { return joins_.has_value(); }
  [[nodiscard]] const RobotProgram& program() const { return artifact_->program.robots[robot_]; }
  [[nodiscard]] std::optional<blocks::Failure> begin(const blocks::ProgramRequest& request, Instant now);
  [[nodiscard]] const blocks::ProgramFrame* permitted() const { return permit_ ? &permit_->frame : nullptr; }
  void sent(Instant now);
  void done(Instant now);
  void finish();
  std::vector<Duration> end(Instant now);
  [[nodiscard]] bool isOver() const { return itinerary_.isOver(); }
  [[nodiscard]] const std::optional<blocks::Failure>& failure() const { return failure_; }
  [[nodiscard]] bool stopsRobot() const { return readiness_.halted() == Halt::OffPath; }
  [[nodiscard]] blocks::ProgramStand stand(Instant now) const;
  [[nodiscard]] std::optional<Instant> nextDeadline() const;

 private:
  using Halt = Readiness::Halt;
  struct Permit {
    std::size_t frame_index = 0;
    blocks::ProgramFrame frame;
  };

  // --- Where it is.
  void followState(Instant now);
  void restart(const RobotStatus& mine);
  void watchPath();
  void lookAtZones(const arm::JointVector& joints);

  // --- How it goes on.
  void goOn();
  /// False: there is nothing more that can be said of its program now.
  [[nodiscard]] bool goOnAtStation();
  [[nodiscard]] bool goOnPath();
  [[nodiscard]] bool mayAskFor(std::size_t frame) const;
  void tryAnotherPath(Instant now);
  void undoUnused();
  void findPermit(Instant now);
  void countWaiting(Instant now);
  void tellWait(const RobotStatus& mine, blocks::ProgramStand& stand) const;

  std::shared_ptr<const Artifact> artifact_;
  CellModel model_;
  RobotIndex robot_;
  std::uint64_t session_;
  ProgramWalk walk_;
  StateWatch states_;
  Whereabouts where_;
  Itinerary itinerary_;
  robot::RobotWatch watch_;
  std::optional<std::uint32_t> joins_;  ///< known to have been let in so often
  std::optional<Instant> measured_at_;
  int off_frames_ = 0;
  bool is_running_ = false;
  bool is_busy_ = false;  ///< a frame was sent, and the next one may not follow yet
  Readiness readiness_;
  std::optional<Permit> permit_;
  std::string withheld_;  ///< why the frame that is next and has all its zones does not leave
  std::optional<blocks::Failure> failure_;
  std::optional<Instant> waits_since_;
  std::optional<Instant> tried_another_at_;
  blocks::CycleWaits waits_;
  std::uint64_t report_number_ = 0;
  std::optional<Instant> reported_at_;
  bool has_news_ = true;
};

}  // namespace cobot_command::cell
