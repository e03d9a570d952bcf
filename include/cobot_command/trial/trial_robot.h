// One robot of a trial: its command core, its agent, and its simulated controller.
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
  /// Starts at its home. Precondition: the artifact has that robot, and its model is known. `not_streamed`:
  /// items that its status does not have.
  TrialRobot(std::shared_ptr<const cell::Artifact> artifact, cell::RobotIndex robot, std::uint64_t session,
             Instant now, const std::vector<std::string>& not_streamed);

  void connect();
  [[nodiscard]] bool isReady() const;
  /// True if the supervisor has admitted the robot, according to the last received state.
  [[nodiscard]] bool isLetIn() const { return agent_->isLetIn(); }
  blocks::GoalId submit(const blocks::Goal& goal);
  void cancel(blocks::GoalId goal);
  void finish();
  void operate(const simulator::OperatorAction& action);
  /// Simulates a lost network connection to the controller.
  void dropConnections();
  /// Simulates a restart of its node, with another session.
  void restart(std::uint64_t session);
  /// Sends bytes from another client of the controller's script port that does not use the cell.
  void receiveOfOther(const std::string& bytes);
  /// Modifies the description of a frame that is about to be sent, before the gate checks it. Also applies
  /// after restart().
  std::function<void(command::Departure&)> tamper;

  void hear(const cell::CellStatus& state, std::uint64_t number);
  [[nodiscard]] std::optional<cell::RobotReport> takeReport() { return agent_->takeReport(now_); }

  [[nodiscard]] Instant nextEvent() const;
  void advanceTo(Instant instant);

  /// nullptr: the goal has not ended.
  [[nodiscard]] const blocks::Outcome* outcome(blocks::GoalId goal) const;
  [[nodiscard]] const std::vector<blocks::Progress>& progress(blocks::GoalId goal) { return progress_[goal]; }
  /// The sent scripts, including ids and tags.
  [[nodiscard]] const std::vector<std::string>& scripts() const { return scripts_; }
  [[nodiscard]] simulator::RobotState state();
  [[nodiscard]] const cell::Agent& agent() const { return *agent_; }
  [[nodiscard]] const std::string& name() const { return name_; }
  /// The goal that was submitted last.
  [[nodiscard]] blocks::GoalId lastGoal() const { return goals_; }
  /// Outcome of the last goal; nullptr: it has not ended.
  [[nodiscard]] const blocks::Outcome* lastOutcome() const { return outcome(goals_); }
  [[nodiscard]] bool hasEnded() const { return lastOutcome() != nullptr; }
  /// The true position of the arm in the world, as far as its shapes are described: links and tool.
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
  /// The connection of a client of the controller; 0: it no longer exists.
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
