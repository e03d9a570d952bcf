// The command core of one robot with real sockets and a real clock, on a thread of its own.
//
// It connects a program to the core: goals are submitted from any thread, and actions are returned on the
// core's thread. It carries out the actions for the sockets, and makes the plans on threads of their own.
#pragma once

#include <chrono>
#include <functional>
#include <future>
#include <memory>
#include <optional>
#include <string>

#include "cobot_command/arm/arm_model.h"
#include "cobot_command/blocks/list/goal.h"
#include "cobot_command/command/command_core.h"
#include "cobot_command/common/time.h"
#include "cobot_command/link/connection.h"

namespace cobot_command::runtime {

/// Maximum time that stop() waits for the robot to confirm its standstill, after the stop was sent.
inline constexpr Duration kRetirement = std::chrono::milliseconds(300);

/// Thread-safe, except as stated for stop().
class CommandRuntime {
 public:
  /// Gets all actions except OpenConnection, CloseConnection, SendBytes and PlanAsked, in order, one at a
  /// time, on the core's thread. `now`: the present time on the clock of all Instants in the actions, which
  /// is monotonic and zero at the construction of the runtime. It must not throw and must not wait for long,
  /// because the link waits for it. It may call submit() and cancel(), which take effect after it has
  /// returned.
  using Observer = std::function<void(const command::Action&, Instant now)>;

  /// `ports`: called on the core's thread; `newest` also by cancel() and finish().
  CommandRuntime(std::optional<arm::ArmModel> arm, const link::LinkSettings& settings, Observer observer,
                 command::CorePorts ports = {});
  ~CommandRuntime();  ///< stop()
  CommandRuntime(const CommandRuntime&) = delete;
  CommandRuntime& operator=(const CommandRuntime&) = delete;

  /// False: stop() has closed the core, and there will be no reports about the goal. True: the goal gets its
  /// GoalEnded. Ids give the order in which goals were received. Goals that stop, pause or resume the robot
  /// do not wait for other goals that wait for the core's thread: of the goals that were received before a
  /// stop none begins.
  [[nodiscard]] bool submit(blocks::GoalId id, blocks::Goal goal);
  /// The falling edge of Execute; it does not wait for goals either. It also ends goals up to `newest`;
  /// nullopt: those received before this call. After stop() all goals have ended, so there is nothing to
  /// cancel.
  void cancel(blocks::GoalId id, std::optional<blocks::GoalId> newest = {});
  /// See CommandCore; `newest`: as with cancel(). The report is available when the core's thread has
  /// processed the request. So do not wait for it in the observer; during a long planning it takes long.
  /// nullopt: stop() has closed the core.
  std::optional<std::future<command::FinishReport>> finish(blocks::FinishAfter after,
                                                           std::optional<blocks::GoalId> newest = {});
  /// See CommandCore.
  void useSettings(const link::LinkSettings& settings);
  /// See CommandCore.
  void useTables(tables::DataTables tables);
  void useExchangeRules(const command::ExchangeRules& rules);
  /// See CommandCore; the answer is available as with finish().
  std::optional<std::future<command::TableAnswer>> writeTable(command::TableWrite write);
  std::optional<std::future<command::TableAnswer>> tryTable(command::TableWrite write);
  /// See CommandCore; the answers are available as with finish(). If a Pause() or Resume() is necessary, when
  /// the controller has accepted it.
  std::optional<std::future<command::FeedrateAnswer>> setFeedrate(command::FeedrateRequest request);
  std::optional<std::future<std::optional<std::string>>> switchTracking(command::TrackingSwitch request);
  /// See CommandCore; the answers are available as with finish().
  std::optional<std::future<command::ExchangeAnswer>> updateExchange(blocks::ExchangeSettings settings);
  std::optional<std::future<command::ResetAnswer>> reset();
  std::optional<std::future<std::vector<command::Message>>> messages(command::Severity least,
                                                                     std::uint32_t after_id);
  /// See CommandCore; the answers are available as with setFeedrate() and finish().
  std::optional<std::future<command::OverrideAnswer>> setSpeedOverride(double percent);
  std::optional<std::future<command::DynamicsAnswer>> writeDefaults(blocks::DefaultDynamics defaults);
  std::optional<std::future<blocks::DefaultDynamics>> defaults();
  std::optional<std::future<std::optional<command::ReferenceDynamics>>> referenceDynamics();
  std::optional<std::future<command::DynamicsAnswer>> writeLimits(command::SoftwareLimits limits);
  std::optional<std::future<std::optional<command::LimitsReport>>> limits();
  /// See CommandCore; the answers are available as with setFeedrate() and finish().
  std::optional<std::future<command::InterruptAnswer>> interrupt();
  std::optional<std::future<command::InterruptAnswer>> goOn();
  /// See CommandCore. A keep-alive counts at the time when the core's thread processes it. Of several within
  /// a few milliseconds only one counts: they overtake goals, and a client that sends them without pause must
  /// not delay the goals.
  void keepJogging();
  /// Calls `what` on the core's thread, with the present time on the clock of its Instants. The core checks
  /// its goals again afterwards.
  void inCore(std::function<void(Instant now)> what);
  /// See CommandCore.
  void tellEnd(blocks::Block block, blocks::Outcome outcome);
  void keepConnected(blocks::ConnectGoal target);

  /// Begins the shutdown, and returns at once: no more goals are accepted, and a moving robot is stopped. The
  /// core does this after its present work, which may be a long planning. Then it calls `begun`, on its
  /// thread. If stop() has closed the core already, `begun` is called at once.
  void retire(const std::function<void()>& begun = {});
  /// retire(), then ends all goals, closes all connections and ends the thread. The observer is not called
  /// any more after this returns, whichever thread called it first. It waits for the present work of the
  /// core, whatever the time, because a robot whose stop is not sent continues to move. From then on a moving
  /// robot has kRetirement to come to standstill, once, whatever the number of calls. It never waits for
  /// anything else on the network. Must not be called by the observer.
  void stop();

 private:
  template <typename Answer, typename Ask>
  std::optional<std::future<Answer>> ask(Ask ask);

  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace cobot_command::runtime
