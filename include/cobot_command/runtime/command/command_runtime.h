// The command core of one robot with real sockets and a real clock, on a thread of its own.
//
// The program's way to the core: goals go in from any thread, actions come out on the core's thread. The
// sockets' share of the actions is carried out here.
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

/// How long stop() waits at most, once the stop is out, until the robot has confirmed that it stands.
inline constexpr Duration kRetirement = std::chrono::milliseconds(300);

/// Thread-safe, but for what is said of stop().
class CommandRuntime {
 public:
  /// Gets every action but OpenConnection, CloseConnection and SendBytes, in order, one at a time, on the
  /// core's thread, with the present on the clock of all Instants in the actions: monotonic, zero when the
  /// runtime was made. It must not throw, and not wait for long: the link waits for it. It may call submit()
  /// and cancel(), which take effect after it has returned.
  using Observer = std::function<void(const command::Action&, Instant now)>;

  /// `ports`: asked on the core's thread, `newest` by cancel() and finish() too.
  CommandRuntime(std::optional<arm::ArmModel> arm, const link::LinkSettings& settings, Observer observer,
                 command::CorePorts ports = {});
  ~CommandRuntime();  ///< stop()
  CommandRuntime(const CommandRuntime&) = delete;
  CommandRuntime& operator=(const CommandRuntime&) = delete;

  /// False, and nothing will be heard of the goal, once stop() has closed the core. Otherwise it gets its
  /// GoalEnded. Ids tell in which order goals were received. What stops the robot, or holds it, does not wait
  /// for other goals that wait for the core's thread: of those that were received before a stop none begins.
  [[nodiscard]] bool submit(blocks::GoalId id, blocks::Goal goal);
  /// The falling edge of Execute; waits for no goals either. What falls with it are goals until `newest`;
  /// nothing: those that came before this call. After stop() all goals have ended, so there is nothing to
  /// cancel.
  void cancel(blocks::GoalId id, std::optional<blocks::GoalId> newest = {});
  /// See CommandCore; `newest`: as with cancel(). The report comes when the core's thread has come to it, so
  /// it is not to be waited for
  /// in the observer, and behind a long planning for long. Nothing once stop() has closed the core.
  std::optional<std::future<command::FinishReport>> finish(blocks::FinishAfter after,
                                                           std::optional<blocks::GoalId> newest = {});
  /// See CommandCore.
  void useSettings(const link::LinkSettings& settings);
  /// See CommandCore.
  void useTables(tables::DataTables tables);
  void useExchangeRules(const command::ExchangeRules& rules);
  /// See CommandCore; the answer as with finish().
  std::optional<std::future<command::TableAnswer>> writeTable(command::TableWrite write);
  std::optional<std::future<command::TableAnswer>> tryTable(command::TableWrite write);
  /// See CommandCore; the answers as with finish(), and behind a Pause() or Resume() when the controller has
  /// taken it.
  std::optional<std::future<command::FeedrateAnswer>> setFeedrate(command::FeedrateRequest request);
  std::optional<std::future<std::optional<std::string>>> switchTracking(command::TrackingSwitch request);
  /// See CommandCore; the answers as with finish().
  std::optional<std::future<command::ExchangeAnswer>> updateExchange(blocks::ExchangeSettings settings);
  std::optional<std::future<command::ResetAnswer>> reset();
  std::optional<std::future<std::vector<command::Message>>> messages(command::Severity least,
                                                                     std::uint32_t after_id);
  /// See CommandCore; the answers as with setFeedrate(), and finish().
  std::optional<std::future<command::OverrideAnswer>> setSpeedOverride(double percent);
  std::optional<std::future<command::DynamicsAnswer>> writeDefaults(blocks::DefaultDynamics defaults);
  std::optional<std::future<blocks::DefaultDynamics>> defaults();
  std::optional<std::future<std::optional<command::ReferenceDynamics>>> referenceDynamics();
  std::optional<std::future<command::DynamicsAnswer>> writeLimits(command::SoftwareLimits limits);
  std::optional<std::future<std::optional<command::LimitsReport>>> limits();
  /// See CommandCore; the answers as with setFeedrate(), and finish().
  std::optional<std::future<command::InterruptAnswer>> interrupt();
  std::optional<std::future<command::InterruptAnswer>> goOn();
  /// See CommandCore; counts from when the core's thread comes to it. Of many within a few milliseconds one
  /// counts: they overtake goals, and whoever sends them without end must not keep those waiting.
  void keepJogging();
  /// Has the core's thread call that, with the present on the clock of its Instants, and look at its goals
  /// then.
  void inCore(std::function<void(Instant now)> what);
  /// See CommandCore.
  void tellEnd(blocks::Block block, blocks::Outcome outcome);
  void keepConnected(blocks::ConnectGoal target);

  /// Begins the end, and returns at once: no goal is taken any more, a robot that moves is told to stop. The
  /// core does so when it has done what it is at, which may be a long planning; then it calls `begun`, on its
  /// thread. Once stop() has closed the core that is long done, and `begun` is called at once.
  void retire(const std::function<void()>& begun = {});
  /// retire(), then ends all goals, closes all connections, ends the thread. The observer is not called any
  /// more once this returns, whichever thread called it first. It waits for what the core is at, however long
  /// that takes: a stop that is not sent leaves the robot in motion. From then on what moved gets kRetirement
  /// to stand still, once, however often this is called; for anything else of the network it never waits. Not
  /// from the observer.
  void stop();

 private:
  template <typename Answer, typename Ask>
  std::optional<std::future<Answer>> ask(Ask ask);

  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace cobot_command::runtime
