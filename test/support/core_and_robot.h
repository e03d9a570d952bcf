// A command core and a simulated controller on one wire, in invented time: what the layer makes of goals from
// their coming to their end, without sockets, threads and waiting.
#pragma once

#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cobot_command/command/command_core.h"
#include "cobot_command/simulator/simulated_controller.h"

namespace cobot_command::testing {

class CoreAndRobot {
 public:
  /// `planning`: so long a plan takes, beside the core; zero: it is made in the middle of the event.
  explicit CoreAndRobot(const std::string& model = "tm5-900", simulator::Settings settings = {},
                        link::LinkSettings link = {}, Duration planning = Duration::zero());

  /// Until the core is ready for commands.
  blocks::GoalId connect();
  blocks::GoalId submit(const blocks::Goal& goal);
  void cancel(blocks::GoalId goal);
  command::FinishReport finish();
  void shutDown();
  void operate(const simulator::OperatorAction& action);
  command::TableAnswer write(const command::TableWrite& entry);
  void useRules(const command::ExchangeRules& rules) { core_.useExchangeRules(rules); }
  command::ExchangeAnswer update(const blocks::ExchangeSettings& settings);
  [[nodiscard]] std::optional<std::string> switchTracking(const command::TrackingSwitch& request);
  /// What was answered until now; nothing: nothing yet.
  std::optional<command::FeedrateAnswer> setFeedrate(std::optional<double> percent, bool restart = false);
  [[nodiscard]] const std::optional<command::FeedrateAnswer>& feedrateAnswer() const { return *answer_; }
  /// What was answered until now; nothing: nothing yet.
  std::optional<command::OverrideAnswer> setSpeedOverride(double percent);
  [[nodiscard]] const std::optional<command::OverrideAnswer>& overrideAnswer() const { return *override_; }
  /// The answer, when it comes.
  using InterruptPromise = std::shared_ptr<std::optional<command::InterruptAnswer>>;
  InterruptPromise interrupt();
  command::InterruptAnswer goOn();
  command::DynamicsAnswer writeDefaults(const blocks::DefaultDynamics& defaults) {
    return core_.writeDefaults(defaults);
  }
  command::DynamicsAnswer writeLimits(const command::SoftwareLimits& limits) {
    return core_.writeLimits(limits, now_);
  }
  /// The answer to the last one, when it comes.
  using FeedratePromise = std::shared_ptr<std::optional<command::FeedrateAnswer>>;
  [[nodiscard]] FeedratePromise feedratePromise() const { return answer_; }
  /// As if the network were gone: both sides learn of it at once.
  void dropConnections();
  void keepJogging();
  /// nullptr: open.
  void setGate(command::Gate gate) { *gate_ = std::move(gate); }

  void pass(Duration duration);
  /// As if the command layer had died, or the link fallen silent: the robot hears nothing, and no end either.
  void passRobotAlone(Duration duration);
  /// False when that did not come within `most`.
  bool passUntil(const std::function<bool()>& done, Duration most = std::chrono::minutes(10));
  /// Until it has ended.
  const blocks::Outcome& endOf(blocks::GoalId goal);

  [[nodiscard]] bool accepted(blocks::GoalId goal) const { return accepted_.count(goal) != 0; }
  /// nullptr: it has not ended.
  [[nodiscard]] const blocks::Outcome* outcome(blocks::GoalId goal) const;
  [[nodiscard]] const std::vector<blocks::Progress>& progress(blocks::GoalId goal) { return progress_[goal]; }
  /// The scripts that were sent since the connection was made, ids left out.
  [[nodiscard]] const std::vector<std::string>& scripts() const { return scripts_; }
  [[nodiscard]] const command::CommandStatus& status() const { return status_; }
  [[nodiscard]] const std::vector<std::string>& warnings() const { return warnings_; }
  [[nodiscard]] const tables::DataTables& tables() const { return tables_; }
  [[nodiscard]] const std::vector<command::Message>& messages() const { return messages_; }
  [[nodiscard]] const path::PathControls& controls() const { return controls_; }
  [[nodiscard]] const command::GroupState& group() const { return group_; }
  /// To everyone, of runs, and when.
  [[nodiscard]] const std::vector<std::pair<Instant, blocks::Detail>>& told() const { return told_; }
  [[nodiscard]] simulator::RobotState robot() const { return controller_.state(); }
  [[nodiscard]] Instant now() const { return now_; }

 private:
  struct Wire {
    simulator::Port port;
    simulator::ClientId client;
  };

  struct Plan {
    Instant due;
    command::PlanAsked asked;
  };

  void settle();
  void answerPlans();
  bool takeActions();
  bool takeOutputs();
  [[nodiscard]] Instant nextEvent() const;
  void advanceTo(Instant instant);
  void take(const command::OpenConnection& action);
  void take(const command::CloseConnection& action);
  void take(const command::SendBytes& action);
  void take(const command::GoalAccepted& action) { accepted_[action.goal] = true; }
  void take(const command::GoalProgressed& action) { progress_[action.goal].push_back(action.progress); }
  void take(const command::GoalEnded& action);
  void take(const command::StatusChanged& action) { status_ = action.status; }
  void take(const command::PlanAsked& action) { plans_.push_back({now_ + planning_, action}); }
  void take(const command::PathControlsChanged& action) { controls_ = action.controls; }
  void take(const command::LogMessage& action) { warnings_.push_back(action.text); }
  void take(const command::GroupStateChanged& action) { group_ = action.state; }
  void take(const command::TablesChanged& action) { tables_ = action.tables; }
  void take(const command::MessageRaised& action) { messages_.push_back(action.message); }
  void take(const command::RunTold& action) { told_.emplace_back(now_, action.news); }
  void take(const command::FrameTraced& action);
  template <class Other>
  void take(const Other& /*action*/) {}
  void take(const simulator::Send& output);
  void take(const simulator::CloseClient& output);
  void take(const simulator::OpenPort& output) { open_[output.port] = true; }
  void take(const simulator::ClosePort& output) { open_[output.port] = false; }
  void take(const simulator::LogLine& /*output*/) {}
  void forget(link::ConnectionId id, const std::string& reason);

  Instant now_{std::chrono::seconds(1000)};
  std::shared_ptr<command::Gate> gate_ = std::make_shared<command::Gate>();
  command::CommandCore core_;
  simulator::SimulatedController controller_;
  std::map<link::ConnectionId, Wire> wires_;
  std::map<simulator::Port, bool> open_;
  simulator::ClientId clients_ = 0;
  blocks::GoalId goals_ = 0;
  std::map<blocks::GoalId, bool> accepted_;
  std::map<blocks::GoalId, std::vector<blocks::Progress>> progress_;
  std::map<blocks::GoalId, blocks::Outcome> ended_;
  std::vector<std::string> scripts_;
  std::vector<std::pair<Instant, blocks::Detail>> told_;
  command::CommandStatus status_;
  command::GroupState group_;
  tables::DataTables tables_;
  std::vector<command::Message> messages_;
  path::PathControls controls_;
  std::shared_ptr<std::optional<command::OverrideAnswer>> override_ =
      std::make_shared<std::optional<command::OverrideAnswer>>();
  FeedratePromise answer_ = std::make_shared<std::optional<command::FeedrateAnswer>>();
  std::vector<std::string> warnings_;
  Duration planning_;
  std::deque<Plan> plans_;
};

}  // namespace cobot_command::testing
