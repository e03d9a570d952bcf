#include "cobot_command/ros/cell/cell_seat.h"

#include <utility>

#include "cell/cell_messages.h"
#include <fmt/format.h>

#include "cobot_command/common/foreign_text.h"
#include "cobot_command/ros/shared/own_handle.h"
#include "cobot_command/runtime/cell/any_id.h"
#include "cobot_command/runtime/cell/cell_files.h"

namespace cobot_command::ros_adapter {

Result<std::unique_ptr<CellSeat>, std::string> CellSeat::of(const CellParameters& parameters,
                                                            const std::string& model) {
  auto artifact = runtime::readArtifact(parameters.artifact);
  if (!artifact) return refuse(artifact.error().front());
  const auto shared = std::make_shared<const cell::Artifact>(*std::move(artifact));
  auto agent = cell::Agent::of(shared, parameters.robot, runtime::anyId());
  if (!agent) return refuse(agent.error());
  for (std::size_t robot = 0; robot < shared->robots.size(); ++robot) {
    if (shared->program.robots[robot].name != parameters.robot) continue;
    if (model.empty() || shared->robots[robot].model == model) continue;
    return refuse(fmt::format("robot {} of the cell is a {}, but ~robot_model is {}", parameters.robot,
                              shared->robots[robot].model, foreignText(model)));
  }
  return std::unique_ptr<CellSeat>(
      new CellSeat(parameters.cell, std::move(*agent), shared->parameters.report_period));
}

CellSeat::CellSeat(std::string cell, std::shared_ptr<cell::Agent> agent, Duration period)
    : cell_(std::move(cell)), agent_(std::move(agent)), period_(period) {}

CellSeat::~CellSeat() {
  stop();
}

void CellSeat::fill(command::CorePorts& ports) const {
  ports.gate = [agent = agent_](const command::Departure& departure, Instant now) {
    return agent->objectionTo(departure, now);
  };
  ports.program = agent_;
}

void CellSeat::start(const ros::NodeHandle& node, InCore in_core) {
  in_core_ = std::move(in_core);
  OwnHandle handle(node);
  handle.setCallbackQueue(&queue_);
  reports_ = handle.advertise<cobot_command::CellReport>(cell_ + "/reports", 10);
  const boost::function<void(const cobot_command::CellStateConstPtr&)> take =
      [this](const cobot_command::CellStateConstPtr& message) { hear(*message); };
  states_ = handle.subscribe<cobot_command::CellState>(cell_ + "/state", 10, take, ros::VoidConstPtr(),
                                                       ros::TransportHints().tcpNoDelay());
  timer_ = handle.createSteadyTimer(ros::WallDuration(toSeconds(period_)), [this](const auto&) {
    in_core_([this](Instant now) {
      agent_->advance(now);
      tell(now);
    });
  });
  spinner_ = std::make_unique<ros::AsyncSpinner>(1, &queue_);
  spinner_->start();
}

void CellSeat::stop() {
  if (!spinner_) return;
  timer_.stop();
  spinner_->stop();  // states_ stays: to unsubscribe asks the master, and results are still to be sent
  spinner_.reset();
}

void CellSeat::hear(const cobot_command::CellState& message) {
  in_core_([this, status = toStatus(message), number = message.number](Instant now) {
    agent_->hear(status, number, now);
    tell(now);
  });
}

void CellSeat::observe(const link::RobotStatus& status, Instant now) {
  agent_->observe(status, now);
  // The core has looked at its goals already, without what the agent has just found.
  if (in_core_) in_core_([this](Instant later) { tell(later); });
}

void CellSeat::observe(const command::CommandStatus& status, Instant now) {
  agent_->linked(command::whyNotReady(status), now);
}

void CellSeat::tell(Instant now) {
  if (const auto report = agent_->takeReport(now)) reports_.publish(toMessage(*report));
}

}  // namespace cobot_command::ros_adapter
