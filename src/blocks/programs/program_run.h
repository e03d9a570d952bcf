// A run_program goal under way (states: program_states.h): the frames that its guide permits, one behind the
// other, each with what follows it.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "programs/program_states.h"

#include "cobot_command/blocks/run_program.h"
#include "cobot_command/robot/reason_wait.h"

namespace cobot_command::blocks {

class ProgramRun final : public Run {
 public:
  ProgramRun(GoalId id, ProgramGuidePtr guide, const ProgramRequest& request, Instant now);
  ~ProgramRun() override;

  [[nodiscard]] bool leavesMotions() const override { return true; }
  [[nodiscard]] std::optional<Command> next() const override;
  [[nodiscard]] bool leavesNode() const override { return false; }
  void commandStarted(CommandKey key) override;
  void commandProgressed(CommandKey key, const Progress& progress, Instant now) override;
  void commandEnded(CommandKey key, const Outcome& outcome, Instant now) override;
  void commandRefused(CommandKey key, const Failure& failure, Instant now) override;

  [[nodiscard]] std::optional<std::string> stopsFor() const override;
  void cancel(const std::string& why, Instant now) override;
  /// No other cycle is begun; where the program is to end behind this move, it is cancelled between two.
  void finish(FinishAfter after, Instant now) override;
  void linkLost(const std::string& reason, std::optional<Duration> patience, Instant now) override;
  void robotChanged(const robot::RobotWatch& robot, Instant now) override;
  void advance(Instant now) override;
  [[nodiscard]] std::optional<Instant> nextDeadline() const override;
  /// Where it would go on, only a person and the supervisor know.
  [[nodiscard]] GoesOn goesOn() const override { return GoesOn::Never; }

 private:
  using Event = ProgramEvent;
  using State = ProgramState;

  void fire(Event event, Instant now);
  void act(ProgramAction action, Instant now);
  /// What its guide has found since.
  void follow(Instant now);
  void goOn(Instant now);
  void startWait(Instant now);
  void followWait(Instant now);
  void startDwell(Instant now);
  void followHold(bool held, Instant now);
  void fail(Failure failure, Instant now);
  void failFrame(int error_id, const Outcome& outcome, Instant now);
  [[nodiscard]] Block blockOfPart() const;
  void tell(Progress progress, Instant now);
  void tellWaiting(Instant now);
  void endAs(Ending ending, Instant now);

  ProgramGuidePtr guide_;
  State state_ = State::Waiting;
  ProgramFrame frame_;  ///< under way, or the last one
  bool under_way_ = false;
  CommandKey commands_ = 0;  ///< that have been sent
  std::optional<std::string> cancelled_why_;
  bool ends_behind_move_ = false;
  std::unique_ptr<Run> wait_;           ///< for the input behind a frame
  std::optional<Instant> waits_until_;  ///< in a dwell, or for a reason
  std::optional<Instant> held_since_;
  robot::ReasonWait reason_;
  Instant started_at_;
  Instant now_;
  std::optional<Instant> told_at_;
  std::string told_;
  Failure failure_;
};

}  // namespace cobot_command::blocks
