// The inside of CommandCore: hands events to the links and the runs, goals to their blocks, and is the
// arbiter that decides which command may execute when.
//
// One goal at a time is under way (run_), and one command of it on the wire (on_wire_). What waits for its
// turn is kept here, not in the controller: there, nothing could be taken out of the queue again. Blended
// motions end with their acceptance, so the next one is on the wire while they still run. What goes out
// beside all others, and the stop, have paths of their own.
#pragma once

#include <deque>
#include <list>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "board/output_board.h"
#include "forecast/forecast.h"
#include "forecast/plan_desk.h"
#include "links/links.h"
#include "runs/command_run.h"
#include "runs/connect_run.h"
#include "runs/stop_run.h"

#include "cobot_command/blocks/goal_rules.h"
#include "cobot_command/command/command_core.h"
#include "cobot_command/command/waiting_goals.h"
#include "cobot_command/link/tag_ledger.h"
#include "cobot_command/robot/orphan_watch.h"
#include "cobot_command/robot/robot_watch.h"
#include "cobot_command/robot/stranger_watch.h"

namespace cobot_command::command {

class CommandCore::Impl {
 public:
  Impl(std::optional<arm::ArmModel> arm, const link::LinkSettings& settings, blocks::FrameFinder frame_finder,
       NewestGoal newest, Planning planning);

  void submit(blocks::GoalId id, const blocks::Goal& goal, Instant now);
  void cancel(blocks::GoalId id, Instant now, std::optional<blocks::GoalId> newest);
  FinishReport finish(blocks::FinishAfter after, Instant now, std::optional<blocks::GoalId> newest);
  void keepConnected(const blocks::ConnectGoal& target, Instant now);
  void retire(Instant now);
  [[nodiscard]] bool retired() const;
  void shutDown(Instant now);
  void opened(link::ConnectionId id, Instant now);
  void openFailed(link::ConnectionId id, const link::OpenFailure& failure, Instant now);
  void received(link::ConnectionId id, std::string_view bytes, Instant now);
  void closed(link::ConnectionId id, const std::string& reason, Instant now);
  void planned(PlanJobId id, PlanAnswer answer, Instant now);
  void advance(Instant now);
  [[nodiscard]] std::optional<Instant> nextDeadline() const;
  [[nodiscard]] std::vector<Action> takeActions();

 private:
  /// A goal that was checked, and is not on the wire yet.
  struct Waiting {
    blocks::GoalId id = 0;
    blocks::Goal goal;
    bool takes_over = false;               ///< once the stop that is under way for it is confirmed
    int told_place = 0;                    ///< in the queue, as last reported; 0: not yet
    std::optional<Origin> end;             ///< where it will leave the robot, as far as that can be foreseen
    PlanJobId job = 0;                     ///< that plans it as a whole, when its turn has come
    std::optional<blocks::Outcome> found;  ///< by that
  };
  /// A goal of the stop block, and which stop answers it.
  struct StopWish {
    blocks::GoalId id = 0;
    StopRun::Number stop = 0;
  };
  enum class Life { Working, Retiring, Over };
  using Failures = std::vector<blocks::Failure>;
  static constexpr blocks::Block kStop = blocks::kBlock<blocks::StopGoal>;

  // --- Goals: checked, refused or taken (core_goals.cpp).
  void abortAsItComes(blocks::Block block, blocks::GoalId id, const std::string& why);
  void execute(blocks::GoalId id, const blocks::Goal& goal, Instant now);
  void reject(blocks::GoalId id, const blocks::Goal& goal, const Failures& failures);
  void connect(blocks::GoalId id, const blocks::Goal& goal, Instant now);
  void stopOnRequest(blocks::GoalId id, const blocks::Goal& goal, Instant now);
  void sendBeside(blocks::GoalId id, const blocks::Goal& goal, Instant now);
  void queueUp(blocks::GoalId id, const blocks::Goal& goal, blocks::BufferMode mode, Instant now);
  /// Planned from where the robot will be, and answered.
  void answerByPlan(blocks::GoalId id, const blocks::Goal& goal, Instant now);
  /// Why nothing that the controller would take can be sent; empty: it can.
  [[nodiscard]] Failures checkLink() const;
  /// Why not even a try can be made, for what must never be held back: there is no connection.
  [[nodiscard]] Failures checkConnection() const;
  /// Why no command may be taken now, whatever it is; in table order.
  [[nodiscard]] Failures checkReadiness(blocks::BufferMode mode) const;
  [[nodiscard]] std::optional<blocks::Block> busyBlock() const;

  // --- Plans that may take long (core_plans.cpp).
  /// Its answer comes to takePlan(), at once with Planning::AtOnce.
  PlanJobId askForPlan(blocks::GoalId id, const blocks::Goal& goal, const std::optional<Origin>& origin,
                       PlanDesk::Haste haste);
  void takePlan(const PlanDesk::Job& job, PlanAnswer answer);
  void endOverduePlans(Instant now);
  /// Those that are planned. Precondition: nothing waits for its turn any more.
  void endChecks(const std::string& why);
  void endUnplanned(const PlanDesk::Job& job, const std::string& why);

  // --- The queue (core_queue.cpp).
  /// Where a command starts that comes behind all that is on the wire and waits; nothing when nobody knows.
  [[nodiscard]] std::optional<Origin> originBehindAll(Instant now) const;
  void forgetForecasts();
  void enqueue(blocks::GoalId id, const blocks::Goal& goal, blocks::BufferMode mode, Instant now);
  /// With all that came until now, as nobody can know yet what makes them fall.
  void dropWaiting(const std::string& why) { dropWaiting(why, newestGoal()); }
  /// With all that came until `newest`, which is when it was asked for.
  void dropWaiting(const std::string& why, blocks::GoalId newest);
  /// Behind a stop that failed; `found`: why.
  void dropUnstopped(const std::string& found);
  [[nodiscard]] blocks::GoalId newestGoal() const { return newest_ ? newest_() : newest_submitted_; }
  void askForStop(Instant now);
  /// Everything that is Busy is to end as CommandAborted, with a stop when it moves; `newest`: see
  /// dropWaiting().
  void abortAll(const std::string& why, blocks::GoalId newest, Instant now);
  void abortRunning(const std::string& why, Instant now);
  void endAborted(blocks::Block block, blocks::GoalId id, const std::string& why);
  void dispatch(Instant now);
  bool beginNext(Instant now);
  [[nodiscard]] Failures objectionsTo(const Waiting& next) const;
  void begin(const Waiting& next, Instant now);
  void refuseTurn(const Waiting& next, blocks::Outcome refusal);
  void beginCommand(const Waiting& next, std::unique_ptr<blocks::Run> run, Instant now);
  bool continueRun(Instant now);
  [[nodiscard]] Result<CommandOrder, blocks::Failure> prepareNext(const blocks::Command& command,
                                                                  Instant now);
  [[nodiscard]] Result<CommandOrder, blocks::Failure> prepare(const blocks::Command& command, Instant now);
  void startNext(CommandOrder order, Instant now);
  void start(CommandOrder order, Instant now);
  void finishCommand(Instant now);
  void finishDirectRuns(Instant now);
  [[nodiscard]] RunContext contextOfRuns() {
    return {settings_, script_, tags_, robot_, stop_, forecast_.arm()};
  }
  /// The node is left once its motion is done: until then the controller takes a stop, and a pause.
  void leaveNode(const CommandRun& done, Instant now);
  void finishRun(Instant now);
  /// The goal whose turn it is, and that is planned as a whole.
  [[nodiscard]] bool plansTheNext() const { return !waiting_.empty() && waiting_.front().job != 0; }
  void tellPlaces();
  [[nodiscard]] std::string textOfPlace(int place) const;

  // --- The stop (core_stop.cpp).
  /// Everything that is Busy is to end as CommandAborted, with a stop whatever there is; `newest`: see
  /// dropWaiting().
  void stopAll(const std::string& why, blocks::GoalId newest, Instant now);
  /// For motions that no goal waits for any more.
  void stopIfMoving(Instant now);
  /// Something may move, or be queued, that is not of what runs here: blended, from before, or another
  /// client's. Nobody can tell that of a robot that is not seen to stand.
  [[nodiscard]] bool mayMoveOtherwise() const;
  /// The robot may move, and no goal answers for it: nothing may queue behind that unseen.
  [[nodiscard]] bool holdsBack() const { return orphan_.mayMove() || forecast_.loose().holdsBack(); }
  [[nodiscard]] std::string heldBackBy() const;
  void finishStops(Instant now);
  void endStopGoals(const StopRun::Result& result);
  [[nodiscard]] std::vector<StopWish>::const_iterator wishFor(const StopRun::Result& result) const;
  void stopConfirmed(const StopRun::Result& result);
  void stopFailed(const StopRun::Result& result, Instant now);

  // --- Events (core_events.cpp).
  void settle(Instant now);
  void finish(Instant now);
  void tellOfClosedConnection(Instant now);
  void watchOrphan(Instant now);
  void watchStrangers(Instant now);
  void handle(const link::LinkChanged& event, Instant now);
  void handle(const link::LinkLost& event, Instant now);
  void handle(const link::ScriptAnswered& event, Instant now);
  void handle(const link::TagReported& event, Instant now);
  void handle(const link::TagQueryFailed& event, Instant now);
  void handle(const link::RobotStatus& status, Instant now);
  void commandAccepted(const CommandOrder& order, Instant now);
  void robotChanged(Instant now);

  // --- What everyone may know (core_status.cpp).
  /// Of a robot that may move, and that no link can stop. Precondition: there is one.
  [[nodiscard]] std::string textOfTheRobotLeft() const;
  /// By a connect goal that was cancelled, and no other has come since.
  [[nodiscard]] bool automaticLinkEnded() const { return kept_no_more_ && !connect_.busy(); }
  [[nodiscard]] std::string linkDiagnosis() const;
  void publishStatus();
  void publishFrames();
  void log(Severity severity, std::string text);

  link::LinkSettings settings_;
  blocks::FrameFinder frame_finder_;
  NewestGoal newest_;
  blocks::GoalId newest_submitted_ = 0;
  CommandsFell fell_{0, ""};  ///< the last that fell
  std::vector<Action> actions_;
  Links links_;
  link::ScriptLink& script_ = links_.script();
  link::StatusLink& status_ = links_.status();
  link::TagLedger tags_;
  robot::RobotWatch robot_;
  Forecast forecast_;
  robot::OrphanWatch orphan_;
  robot::StrangerWatch strangers_;
  Planning planning_;
  PlanDesk plans_;
  OutputBoard board_;
  ConnectRun connect_;
  StopRun stop_;
  std::vector<StopWish> stop_goals_;
  std::unique_ptr<blocks::Run> run_;   ///< the goal whose turn it is
  std::optional<CommandRun> on_wire_;  ///< its command that is under way
  std::optional<blocks::Outcome>
      before_exit_;               ///< of a motion that is done, while the ScriptExit() behind it is under way
  std::list<CommandRun> direct_;  ///< beside whatever else is on the wire
  std::deque<Waiting> waiting_;
  std::optional<blocks::ConnectGoal> kept_;  ///< the link to keep while no connect goal is Busy
  bool kept_no_more_ = false;  ///< a connect goal was cancelled, and no other came: who disconnects means it
  std::optional<blocks::ConnectGoal> left_moving_;  ///< the link to it was lost with a motion under way
  Life life_ = Life::Working;
  CommandStatus published_;
  robot::ActiveFrames published_frames_;
};

}  // namespace cobot_command::command
