// One robot of a trial: its command core, its agent, and the simulated controller that both command.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cobot_command/blocks/list/goal.h"
#include "cobot_command/blocks/shared/outcome.h"
#include "cobot_command/cell/agent/agent.h"
#include "cobot_command/cell/bodies/robot_bodies.h"
#include "cobot_command/command/command_core.h"
#include "cobot_command/simulator/simulated_controller.h"

namespace cobot_command::trial {

class TrialRobot {
 public:
  /// Stands at its home. Precondition: the artifact has that robot, of a model that is known. `not_streamed`:
  /// items that its status does not have.
  TrialRobot(std::shared_ptr<const cell::Artifact> artifact, cell::RobotIndex robot, std::uint64_t session,
             Instant now, const std::vector<std::string>& not_streamed);

  void connect();
  [[nodiscard]] bool isReady() const;
  /// By the supervisor, as far as it has heard.
  [[nodiscard]] bool isLetIn() const { return agent_->isLetIn(); }
  blocks::GoalId submit(const blocks::Goal& goal);
  void cancel(blocks::GoalId goal);
  void finish();
  void operate(const simulator::OperatorAction& action);
  /// As if the network to the controller were gone.
  void dropConnections();
  /// As if its node were started anew, with another session.
  void restart(std::uint64_t session);
  /// Another client of the controller's script port, which knows nothing of cells, sends these bytes.
  void receiveOfOther(const std::string& bytes);
  /// What is said of a frame that is about to leave is changed by it before the gate looks. Counts from the
  /// next restart() on, too.
  std::function<void(command::Departure&)> tamper;

  void hear(const cell::CellStatus& state, std::uint64_t number);
  [[nodiscard]] std::optional<cell::RobotReport> takeReport() { return agent_->takeReport(now_); }

  [[nodiscard]] Instant nextEvent() const;
  void advanceTo(Instant instant);

  /// nullptr: it has not ended.
  [[nodiscard]] const blocks::Outcome* outcome(blocks::GoalId goal) const;
  [[nodiscard]] const std::vector<blocks::Progress>& progress(blocks::GoalId goal) { return progress_[goal]; }
  /// The scripts that were sent, ids and tags included.
  [[nodiscard]] const std::vector<std::string>& scripts() const { return scripts_; }
  [[nodiscard]] simulator::RobotState state();
  [[nodiscard]] const cell::Agent& agent() const { return *agent_; }
  [[nodiscard]] const std::string& name() const { return name_; }
  /// The one that was submitted last.
  [[nodiscard]] blocks::GoalId lastGoal() const { return goals_; }
  /// Of that one; nullptr: it has not ended.
  [[nodiscard]] const blocks::Outcome* lastOutcome() const { return outcome(goals_); }
  [[nodiscard]] bool hasEnded() const { return lastOutcome() != nullptr; }
  /// Where the arm truly is, in the world, as far as it is described: links and tool.
  [[nodiscard]] cell::Capsules bodies();

 private:
  struct Wire {
    simulator::Port port;
    simulator::ClientId client;
  };

  void makeCore(std::uint64_t session);
  void settle();
  bool takeActions();
  bool takeOutputs();
  void open(const command::OpenConnection& action);
  void close(const command::CloseConnection& action);
  void send(const command::SendBytes& action);
  void observe(const link::RobotStatus& status);
  void note(const command::FrameTraced& action);
  /// By its client at the controller; 0: there is none any more.
  [[nodiscard]] link::ConnectionId connectionOf(simulator::ClientId client) const;
  void forget(link::ConnectionId id, const std::string& reason);

  std::shared_ptr<const cell::Artifact> artifact_;
  cell::RobotIndex index_;
  std::string name_;
  Instant now_;
  std::shared_ptr<cell::Agent> agent_;
  std::unique_ptr<command::CommandCore> core_;
  simulator::SimulatedController controller_;
  cell::RobotBodies bodies_;
  std::map<link::ConnectionId, Wire> wires_;
  std::map<simulator::Port, bool> open_;
  simulator::ClientId clients_ = 0;
  std::optional<simulator::ClientId> other_;  ///< client of the script port
  blocks::GoalId goals_ = 0;
  std::map<blocks::GoalId, blocks::Outcome> ended_;
  std::map<blocks::GoalId, std::vector<blocks::Progress>> progress_;
  std::vector<std::string> scripts_;
  command::CommandStatus status_;
  bool has_seen_ = false;
};

}  // namespace cobot_command::trial
