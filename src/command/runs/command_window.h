// The commands that the controller has and that have not ended: those of the goal whose turn it is, in the
// order of sending, and those that go out beside all others.
//
// Each has its key, by which its goal is told of it. With one that fails those fall that are behind it; those
// in front of it only where the robot is stopped for it.
#pragma once

#include <list>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "forecast/command_order.h"
#include "forecast/forecast.h"
#include "forecast/plan_desk.h"
#include "runs/command_run.h"
#include "runs/project_pace.h"
#include "stops/stop_run.h"

#include "cobot_command/blocks/shared/command.h"
#include "cobot_command/command/gate.h"

namespace cobot_command::command {

class CommandWindow {
 public:
  struct Ended {
    blocks::Block block{};
    blocks::GoalId goal = 0;
    blocks::CommandKey key = 0;
    int command_id_ack = 0;
    blocks::Outcome outcome;
    bool has_tag = false;           ///< its end is that of its motions
    bool leaves_node = false;       ///< the node is to be left behind it, with a script of its own
    bool stops_unanswered = false;  ///< see blocks::Order
  };

  /// `forecast` and `desk` have to live longer, and so has what the context refers to. `gate`: may be empty.
  CommandWindow(const RunContext& context, Forecast& forecast, PlanDesk& desk, Gate gate)
      : context_(context), forecast_(forecast), desk_(desk), gate_(std::move(gate)) {}

  // --- In.
  /// Gives it its tag and its last lines; else what speaks against it.
  [[nodiscard]] std::optional<blocks::Failure> prepare(CommandOrder& order, const blocks::GoalTraits& traits,
                                                       Instant now);
  void send(CommandOrder order, Instant now);
  /// Beside all others, whatever state the robot is in; nothing is planned or foreseen for it.
  void sendBeside(const blocks::Command& command, blocks::GoalId goal, Instant now);
  /// Behind a motion that is done: until then the controller takes a stop, and a pause. It ends as that one.
  void leaveNode(Ended done, Instant now);

  // --- What is there.
  [[nodiscard]] std::size_t size() const { return ordered_.size(); }
  [[nodiscard]] bool empty() const { return ordered_.empty(); }
  [[nodiscard]] bool nothingBeside() const { return beside_.empty(); }
  /// Where the next one starts, behind the last one: nothing when that is not planned, or is being stopped.
  [[nodiscard]] std::optional<Origin> end(Instant now) const;
  /// All of them are accepted, and none is being verified, explained or stopped: what is sent now comes
  /// behind them, and begins where they end.
  [[nodiscard]] bool goesOn() const;
  /// The controller may be moving the robot for one of them.
  [[nodiscard]] bool mayMove() const;
  /// A cancel of them all sends a stop.
  [[nodiscard]] bool stopsWithACancel() const;
  /// Of the last one that moves; nothing: none does, or it is not known.
  [[nodiscard]] std::optional<robot::Target> target() const;
  [[nodiscard]] bool moves() const;
  /// So much of its goal's speeds has what moves the robot now; nothing: none of them does.
  [[nodiscard]] std::optional<double> speedShare() const;

  // --- Events.
  void cancel(const std::string& why, Instant now);
  void abandon(const std::string& why, Instant now);
  void abandonBeside(const std::string& why, Instant now);
  void answered(const link::ScriptAnswered& event, Instant now);
  /// False when none of them waits for that tag.
  bool tagReported(const link::TagReported& event, Instant now);
  void tagQueryFailed(const link::TagQueryFailed& event, Instant now);
  void stopEnded(const StopRun::Result& result, Instant now);
  void linkLost(const std::string& reason, Instant now);
  void besideLinkLost(const std::string& reason, Instant now);
  void robotChanged(Instant now);
  void advance(Instant now);
  [[nodiscard]] std::optional<Instant> nextDeadline() const;

  // --- Out: what is new since the last call.
  [[nodiscard]] std::vector<std::pair<blocks::CommandKey, blocks::Progress>> takeProgress();
  /// The last mark of each command that has come to one.
  [[nodiscard]] std::vector<std::pair<blocks::CommandKey, std::size_t>> takePassed() {
    return std::exchange(passed_, {});
  }
  /// The first that has ended.
  [[nodiscard]] std::optional<Ended> takeEnded(Instant now);
  [[nodiscard]] std::vector<Ended> takeEndedBeside();

 private:
  struct Sent {
    Sent(CommandOrder order, const RunContext& context, Instant now,
         std::optional<blocks::Outcome> motion = {})
        : run(std::move(order), context, now), motion_in_front(std::move(motion)) {}
    CommandRun run;
    ProjectPace pace;
    std::optional<blocks::Outcome> motion_in_front;  ///< of an exit: how that ended
  };
  [[nodiscard]] static Ended endOf(const CommandRun& run);
  /// False: all tags are open.
  [[nodiscard]] bool openTags(CommandOrder& order, int command_id);
  void complete(std::list<Sent>::iterator sent, int tag, Instant now);
  /// With one that failed.
  void takeAlong(std::list<Sent>::iterator failed, Instant now);

  /// By the gate.
  [[nodiscard]] std::optional<blocks::Failure> objectionTo(const CommandOrder& order,
                                                           const blocks::GoalTraits& traits,
                                                           Instant now) const;

  RunContext context_;
  Forecast& forecast_;
  PlanDesk& desk_;
  Gate gate_;
  std::list<Sent> ordered_;
  std::list<CommandRun> beside_;
  std::vector<std::pair<blocks::CommandKey, std::size_t>> passed_;
};

}  // namespace cobot_command::command
