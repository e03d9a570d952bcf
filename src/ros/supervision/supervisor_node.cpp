#include "cobot_command/ros/supervision/supervisor_node.h"

#include <algorithm>
#include <utility>

#include "cell/cell_messages.h"
#include "shared/steady_now.h"
#include "supervision/cell_builder.h"
#include "supervision/people_services.h"
#include "supervision/program_runs.h"
#include "supervision/robot_contact.h"
#include "supervision/supervisor_diagnostics.h"
#include <ros/callback_queue.h>
#include <ros/console.h>
#include <ros/this_node.h>

#include "cobot_command/common/foreign_text.h"
#include "cobot_command/ros/shared/own_handle.h"

namespace cobot_command::ros_adapter {
namespace {

constexpr std::uint32_t kQueueSize = 1000;  // of robots that all report at once
/// It tells something each second.
constexpr Duration kMonitorSilent = std::chrono::seconds(5);

std::vector<std::string> namesOf(const cell::Artifact& artifact) {
  std::vector<std::string> names;
  names.reserve(artifact.robots.size());
  for (std::size_t robot = 0; robot < artifact.robots.size(); ++robot) {
    names.push_back(artifact.program.robots[robot].name);
  }
  return names;
}

}  // namespace

SupervisorNode::SupervisorNode(const ros::NodeHandle& node, const ros::NodeHandle& self,
                               std::unique_ptr<runtime::CellSupervisor> supervisor)
    : spinner_(*ros::getGlobalCallbackQueue(), receipts_), supervisor_(std::move(supervisor)) {
  const cell::Artifact& artifact = supervisor_->artifact();
  for (std::size_t user = 0; user < artifact.program.robots.size(); ++user) {
    contacts_.push_back(std::make_unique<RobotContact>(node));
  }
  people_ = std::make_unique<PeopleServices>(node, supervisor_->core(), steadyNow,
                                             [this](Instant now) { settle(now); });
  const ActionQueues queues{spinner_, spinner_};
  runs_ = std::make_unique<ProgramRuns>(node, queues, namesOf(artifact), contacts_);
  builder_ = std::make_unique<CellBuilder>(node, queues, artifact.digest);
  diagnostics_ = std::make_unique<SupervisorDiagnostics>(node, self, artifact.parameters.wait_timeout);
  OwnHandle handle(node);
  handle.requireType("/diagnostics", "diagnostic_msgs/DiagnosticArray");
  const auto promptly = ros::TransportHints().tcpNoDelay();
  state_ = handle.advertise<cobot_command::CellState>("state", 10, true);
  const boost::function<void(const ReportEvent&)> report = [this](const auto& event) { takeReport(event); };
  reports_ = handle.subscribe<cobot_command::CellReport>("reports", kQueueSize, report, ros::VoidConstPtr(),
                                                         promptly);
  const boost::function<void(const StateEvent&)> state = [this](const auto& event) { takeState(event); };
  states_ = handle.subscribe<cobot_command::CellState>("state", 10, state, ros::VoidConstPtr(), promptly);
  const boost::function<void(const cobot_command::CellDistancesConstPtr&)> distances =
      [this](const auto& message) { takeDistances(*message); };
  distances_ = handle.subscribe<cobot_command::CellDistances>("distances", 10, distances);
  timer_ = handle.createSteadyTimer(ros::WallDuration(toSeconds(artifact.parameters.report_period)),
                                    [this](const ros::SteadyTimerEvent&) { settle(steadyNow()); });
  settle(steadyNow());
}

SupervisorNode::~SupervisorNode() = default;

void SupervisorNode::takeReport(const ReportEvent& event) {
  const Instant now = steadyNow();
  const auto& message = event.getConstMessage();
  const bool is_taken = supervisor_->core().take(toReport(*message), now);
  const cell::CellStatus status = supervisor_->core().status(now);
  for (std::size_t robot = 0; robot < status.robots.size(); ++robot) {
    const cell::RobotStatus& known = status.robots[robot];
    // A second node for the same robot is not whom stops and goals are sent to.
    const bool is_its_own = known.session == 0 || known.session == message->session;
    if (is_taken && known.name == message->robot && is_its_own) {
      contacts_[robot]->heardFrom(event.getPublisherName(), message->moving != 0, now);
    }
  }
  settle(now);
  diagnostics_->answered(steadyNow() - now);
}

void SupervisorNode::takeState(const StateEvent& event) {
  if (event.getPublisherName() == ros::this_node::getName()) return;
  ROS_ERROR_STREAM_THROTTLE(10, foreignText(event.getPublisherName())
                                    << " also publishes the state of this cell: stop one of the two");
  diagnostics_->heardOther(event.getPublisherName());
}

void SupervisorNode::takeDistances(const cobot_command::CellDistances& message) {
  monitor_heard_ = steadyNow();
  alarm_ = message.alarmed != 0 ? foreignText(message.text) : std::string();
  runs_->heardAlarm(alarm_);
  for (const cobot_command::CellDistance& pair : message.pairs) {
    const auto& users = supervisor_->artifact().program.robots;
    const bool is_of_users =
        std::any_of(users.begin(), users.end(), [&](const auto& user) { return user.name == pair.other; });
    if (pair.known != 0 && is_of_users) runs_->heardDistance(pair.now);
  }
}

void SupervisorNode::settle(Instant now) {
  cell::Supervision& core = supervisor_->core();
  core.tick(now);
  for (const cell::StopOrder& order : core.takeStopOrders()) {
    ROS_WARN_STREAM(core.status(now).robots[order.robot].name << " is being stopped: "
                                                              << forPeople(order.why));
    contacts_[order.robot]->stop(now);
  }
  for (const auto& contact : contacts_) contact->settle(now);
  cell::CellStatus status = core.status(now);
  if (isMonitorLost(now)) runs_->lostMonitor();
  const std::string of_monitor = diagnosisOfMonitor(now);
  if (!of_monitor.empty()) status.diagnosis += (status.diagnosis.empty() ? "" : "; ") + forPeople(of_monitor);
  const bool is_due = now >= told_at_ + supervisor_->artifact().parameters.report_period / 2;
  if (!told_ || is_due || !cell::areAlike(*told_, status)) tell(status, now);
}

bool SupervisorNode::isMonitorLost(Instant now) const {
  return monitor_heard_ && now - *monitor_heard_ > kMonitorSilent;
}

std::string SupervisorNode::diagnosisOfMonitor(Instant now) const {
  if (isMonitorLost(now)) {
    return "the monitor publishes nothing: distances are not watched; restart it" +
           (alarm_.empty() ? "" : "; it had stopped all robots: " + alarm_);
  }
  if (alarm_.empty()) return {};
  return "the monitor has stopped all robots: " + alarm_ + "; move them apart, and call reset_monitor";
}

void SupervisorNode::tell(const cell::CellStatus& status, Instant now) {
  told_at_ = now;
  const auto message = toMessage(status, ++number_);
  state_.publish(message);
  runs_->follow(status, message, now);
  diagnostics_->take(status, supervisor_->core().counts());
  if (!told_ || told_->mode != status.mode) {
    ROS_INFO_STREAM("the cell is " << toString(status.mode) << (status.diagnosis.empty() ? "" : ": ")
                                   << forPeople(status.diagnosis));
  }
  told_ = status;
}

}  // namespace cobot_command::ros_adapter
