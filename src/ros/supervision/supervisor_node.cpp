#include "cobot_command/ros/supervision/supervisor_node.h"

#include <algorithm>
#include <future>
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
#include "cobot_command/ros/shared/posted.h"

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
    : spinner_(*ros::getGlobalCallbackQueue(), receipts_),
      questions_(receipts_),
      supervisor_(std::move(supervisor)) {
  const cell::Artifact& artifact = supervisor_->artifact();
  for (std::size_t user = 0; user < artifact.program.robots.size(); ++user) {
    contacts_.push_back(std::make_unique<RobotContact>(node));
  }
  const ActionQueues queues{spinner_, spinner_};
  runs_ = std::make_unique<ProgramRuns>(node, queues, namesOf(artifact), contacts_);
  builder_ = std::make_unique<CellBuilder>(node, queues, artifact.digest);
  diagnostics_ = std::make_unique<SupervisorDiagnostics>(node, self, artifact.parameters.wait_timeout);
  servePeople(node);
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
                                    [this](const ros::SteadyTimerEvent&) { tick(steadyNow()); });
  supervisor_->start([this](const cell::StopOrder& order) { onNode([this, order] { stop(order); }); });
  questions_.start();
  tick(steadyNow());
}

SupervisorNode::~SupervisorNode() {
  supervisor_->finish();  // then a question that waits has its answer
  questions_.stop();
  ros::getGlobalCallbackQueue()->removeByID(ownerOf(this));
}

void SupervisorNode::servePeople(const ros::NodeHandle& node) {
  PeopleServices::Ports ports;
  ports.stop = [this] { stopAll(); };
  ports.ask = [this](PeopleServices::Question question) {
    auto answer = std::make_shared<std::promise<cell::PersonsAnswer>>();
    auto asked = std::make_optional(answer->get_future());
    const auto ask = [this, answer, question = std::move(question)](cell::Supervision& core) {
      const Instant now = steadyNow();
      answer->set_value(question(core, now));
      onNode([this, decided = decided(core, now)] { take(decided); });
    };
    if (!supervisor_->postUrgent(ask)) asked.reset();
    return asked;
  };
  people_ = std::make_unique<PeopleServices>(node, spinner_, questions_.queue(), std::move(ports));
}

void SupervisorNode::onNode(std::function<void()> what) {
  post(*ros::getGlobalCallbackQueue(), std::move(what), this);
}

SupervisorNode::Decided SupervisorNode::decided(cell::Supervision& core, Instant now) {
  core.tick(now);
  return {core.status(now), core.counts()};
}

void SupervisorNode::takeReport(const ReportEvent& event) {
  const Instant received = steadyNow();
  supervisor_->post([this, received, message = event.getConstMessage(),
                     publisher = event.getPublisherName()](cell::Supervision& core) {
    const Instant now = steadyNow();
    const bool is_taken = core.take(toReport(*message), now);
    onNode([this, received, message, publisher, is_taken, decided = decided(core, now)] {
      if (is_taken) hearFrom(decided.status, *message, publisher);
      take(decided);
      diagnostics_->answered(steadyNow() - received);
    });
  });
}

void SupervisorNode::hearFrom(const cell::CellStatus& status, const cobot_command::CellReport& report,
                              const std::string& publisher) {
  for (std::size_t robot = 0; robot < status.robots.size(); ++robot) {
    const cell::RobotStatus& known = status.robots[robot];
    // A second node for the same robot is not whom stops and goals are sent to.
    const bool is_its_own = known.session == 0 || known.session == report.session;
    if (known.name != report.robot || !is_its_own) continue;
    contacts_[robot]->heardFrom(publisher, report.moving != 0, steadyNow());
  }
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

void SupervisorNode::stopAll() {
  ++stops_asked_;
  runs_->refuse("a stop was requested");
  for (const auto& contact : contacts_) contact->stop(steadyNow());
  supervisor_->postUrgent([this](cell::Supervision& core) {
    const Instant now = steadyNow();
    const cell::PersonsAnswer answer = core.stop(now);
    if (!answer.success) ROS_ERROR_STREAM("stop: " << forPeople(answer.message));
    onNode([this, decided = decided(core, now)] {
      --stops_asked_;
      take(decided);
    });
  });
}

void SupervisorNode::stop(const cell::StopOrder& order) {
  ROS_WARN_STREAM(supervisor_->artifact().program.robots[order.robot].name << " is being stopped: "
                                                                           << forPeople(order.why));
  contacts_[order.robot]->stop(steadyNow());
}

void SupervisorNode::tick(Instant now) {
  for (const auto& contact : contacts_) contact->settle(now);
  if (std::exchange(is_tick_asked_, true)) return;
  supervisor_->post([this](cell::Supervision& core) {
    onNode([this, decided = decided(core, steadyNow())] {
      is_tick_asked_ = false;
      take(decided);
    });
  });
}

void SupervisorNode::take(Decided decided) {
  const Instant now = steadyNow();
  if (isMonitorLost(now)) runs_->lostMonitor();
  const std::string of_monitor = diagnosisOfMonitor(now);
  std::string& diagnosis = decided.status.diagnosis;
  if (!of_monitor.empty()) diagnosis += (diagnosis.empty() ? "" : "; ") + forPeople(of_monitor);
  const bool is_due = now >= told_at_ + supervisor_->artifact().parameters.report_period / 2;
  if (!told_ || is_due || !cell::areAlike(*told_, decided.status)) tell(decided, now);
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

void SupervisorNode::tell(const Decided& decided, Instant now) {
  const cell::CellStatus& status = decided.status;
  told_at_ = now;
  const auto message = toMessage(status, ++number_);
  state_.publish(message);
  runs_->follow(status, message, now);
  if (stops_asked_ > 0) runs_->refuse("a stop was requested");
  diagnostics_->take(status, decided.counts);
  if (!told_ || told_->mode != status.mode) {
    ROS_INFO_STREAM("the cell is " << toString(status.mode) << (status.diagnosis.empty() ? "" : ": ")
                                   << forPeople(status.diagnosis));
  }
  told_ = status;
}

}  // namespace cobot_command::ros_adapter
