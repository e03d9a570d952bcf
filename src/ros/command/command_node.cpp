#include "cobot_command/ros/command/command_node.h"

#include <chrono>
#include <future>
#include <random>
#include <utility>

#include "command/action_servers.h"
#include "dynamics/arm_of_now.h"
#include "dynamics/dynamics_services.h"
#include "exchange/exchange_services.h"
#include "interruption/interruption_services.h"
#include "kinematics/kinematics_services.h"
#include "messages/message_services.h"
#include "paths/path_publisher.h"
#include "paths/path_services.h"
#include "robot_data/robot_data_publisher.h"
#include "shared/steady_now.h"
#include "tables/table_services.h"
#include "tables/tables_file.h"
#include <fmt/format.h>
#include <ros/callback_queue.h>
#include <ros/console.h>
#include <std_msgs/Empty.h>

#include "cobot_command/common/foreign_text.h"
#include "cobot_command/common/overloaded.h"
#include "cobot_command/link/tag_ledger.h"
#include "cobot_command/ros/cell/cell_seat.h"
#include "cobot_command/ros/shared/node_end.h"
#include "cobot_command/ros/shared/own_handle.h"

namespace cobot_command::ros_adapter {
namespace {

constexpr double kFrameRetryPeriod = 0.01;  // [s]
/// Far more than any but a planning takes.
constexpr Duration kFinishPatience = std::chrono::milliseconds(500);
constexpr const char* kNotAnsweredYet =
    "requested; the command layer is busy (for example, planning) and has not answered yet. It processes the "
    "request as soon as it can; the results of the goals show the outcome";

void log(const command::LogMessage& message) {
  switch (message.severity) {
    case command::Severity::Off:
      break;
    case command::Severity::Debug:
    case command::Severity::Info:
      ROS_INFO_STREAM_NAMED("link", forPeople(message.text));
      break;
    case command::Severity::Warning:
      ROS_WARN_STREAM_NAMED("link", forPeople(message.text));
      break;
    case command::Severity::Error:
    case command::Severity::Fatal:
      ROS_ERROR_STREAM_NAMED("link", forPeople(message.text));
      break;
  }
}

/// Another client's motions have tags of the same fifteen numbers: all nodes beginning with 1 would meet
/// there.
link::LinkSettings withAnyFirstTag(link::LinkSettings settings) {
  std::random_device random;
  settings.first_tag =
      std::uniform_int_distribution<int>(link::TagLedger::kFirst, link::TagLedger::kLast)(random);
  return settings;
}

ros::NodeHandle servedBy(ServingThread& thread, const ros::NodeHandle& node) {
  ros::NodeHandle served(node);
  served.setCallbackQueue(&thread.queue());
  return served;
}

/// Those of tf2, which listens from the first goal on that names a frame, and of the diagnostics. Returns the
/// handle, for what the libraries make with it at once.
const ros::NodeHandle& requireLibraryTopics(const ros::NodeHandle& node) {
  const OwnHandle own(node);
  for (const char* tf : {"/tf", "/tf_static"}) own.requireType(tf, "tf2_msgs/TFMessage");
  own.requireType("/diagnostics", "diagnostic_msgs/DiagnosticArray");
  return node;
}

}  // namespace

CommandNode::CommandNode(const ros::NodeHandle& node, const ros::NodeHandle& self,
                         CommandParameters parameters, std::unique_ptr<CellSeat> seat)
    : spinner_(*ros::getGlobalCallbackQueue(), receipts_),
      stops_(receipts_),
      interruptions_(receipts_),
      controls_(receipts_),
      disk_(receipts_),
      questions_(receipts_),
      seat_(std::move(seat)),
      default_host_(parameters.robot_ip),
      default_port_(parameters.script_port),
      arm_(std::make_unique<ArmOfNow>(parameters.arm)),
      publisher_(node, jointNames(parameters.prefix), parameters.prefix),
      paths_(std::make_unique<PathPublisher>(node, parameters.prefix + "base")),
      diagnostics_(requireLibraryTopics(node), self, parameters.diagnostic_period,
                   parameters.link.status_port != 0),
      frames_(parameters.prefix + "base", parameters.tf_from_start),
      intake_([this](const std_msgs::Header& header) { return frames_.find(header); },
              [this] { return frames_.patience(); }, fileSource(), intakeCore(), parameters.world_frame) {
  if (!parameters.arm) {
    ROS_WARN("no robot model: moves are sent to the controller without planning");
  }
  retry_ = node.createSteadyTimer(
      ros::WallDuration(kFrameRetryPeriod),
      [this](const ros::SteadyTimerEvent&) {
        stops_.catchUp();
        endFallen();
        intake_.advance(steadyNow());
        adjustRetrying();
      },
      false, false);
  makeServices(node, parameters);
  requireLibraryTopics(node);  // and of what was made since
  startCore(node, std::move(parameters));
}

void CommandNode::makeServices(const ros::NodeHandle& node, const CommandParameters& parameters) {
  const JointNames joint_names = jointNames(parameters.prefix);
  servers_ = serveActions({node, joint_names, GoalWay{{spinner_, stops_.queue(), &stops_}, goalSink()},
                           GoalWay{{stops_.queue(), stops_.queue()}, stopSink()}});
  const ros::NodeHandle controls = servedBy(controls_, node);
  const ros::NodeHandle questions = servedBy(questions_, node);
  tables_ = tableServices(servedBy(disk_, node), parameters.tables);
  path_services_ = pathServices(controls);
  messages_ = messageServices(questions);
  exchange_ = std::make_unique<ExchangeServices>(questions, [this](const blocks::ExchangeSettings& settings) {
    return runtime_->updateExchange(settings);
  });
  interruption_ = std::make_unique<InterruptionServices>(
      servedBy(interruptions_, node), [this] { return runtime_->interrupt(); },
      [this] { return runtime_->goOn(); });
  const auto arm = [this] { return arm_->get(); };
  kinematics_ = std::make_unique<KinematicsServices>(
      questions, KinematicsServices::Sources{arm, [this] { return tables_->tables(); }});
  robot_data_ = std::make_unique<RobotDataPublisher>(node, joint_names, arm);
  dynamics_ = dynamicsServices(controls);
}

void CommandNode::startCore(const ros::NodeHandle& node, CommandParameters parameters) {
  // Goals come in on threads that are not there yet.
  keep_alive_ = keepAlives(servedBy(stops_, node));
  finish_ = OwnHandle(servedBy(questions_, node)).advertiseService("finish", &CommandNode::finish, this);
  // It may speak at once.
  runtime_ = std::make_unique<runtime::CommandRuntime>(
      std::move(parameters.arm), withAnyFirstTag(parameters.link),
      [this](const command::Action& action, Instant now) { onAction(action, now); }, ports());
  if (seat_) {
    seat_->start(node, [this](std::function<void(Instant)> what) { runtime_->inCore(std::move(what)); });
  }
  runtime_->useTables(parameters.tables.tables);
  runtime_->useExchangeRules(parameters.exchange);
  if (parameters.limits) static_cast<void>(runtime_->writeLimits(*parameters.limits));  // they were tried
  if (parameters.auto_connect) {
    blocks::ConnectGoal target;
    target.host = default_host_;
    target.port = default_port_;
    runtime_->keepConnected(std::move(target));
  }
  for (ServingThread* thread : threads()) thread->start();
}

command::CorePorts CommandNode::ports() {
  command::CorePorts ports;
  ports.frames = [this](const std::string& frame) { return frames_.whereNow(frame); };
  ports.newest = [this] { return receipts_.last(); };
  ports.traced = [this](link::Channel channel) { return publisher_.isHeard(channel); };
  if (seat_) seat_->fill(ports);
  return ports;
}

std::unique_ptr<PathServices> CommandNode::pathServices(const ros::NodeHandle& node) {
  PathServices::Core core;
  core.feedrate = [this](const command::FeedrateRequest& request) { return runtime_->setFeedrate(request); };
  core.tracking = [this](const command::TrackingSwitch& request) {
    return runtime_->switchTracking(request);
  };
  return std::make_unique<PathServices>(node, std::move(core));
}

std::unique_ptr<MessageServices> CommandNode::messageServices(const ros::NodeHandle& node) {
  MessageServices::Core core;
  core.reset = [this] { return runtime_->reset(); };
  core.read = [this](command::Severity least, std::uint32_t after_id) {
    return runtime_->messages(least, after_id);
  };
  return std::make_unique<MessageServices>(node, std::move(core));
}

std::unique_ptr<DynamicsServices> CommandNode::dynamicsServices(const ros::NodeHandle& node) {
  DynamicsServices::Core core;
  core.set_override = [this](double percent) { return runtime_->setSpeedOverride(percent); };
  core.reference = [this] { return runtime_->referenceDynamics(); };
  core.defaults = [this] { return runtime_->defaults(); };
  core.write_defaults = [this](const blocks::DefaultDynamics& defaults) {
    return runtime_->writeDefaults(defaults);
  };
  core.limits = [this] { return runtime_->limits(); };
  core.write_limits = [this](const command::SoftwareLimits& limits) { return runtime_->writeLimits(limits); };
  return std::make_unique<DynamicsServices>(node, std::move(core));
}

/// One of them says as much as many: what was late and comes at once counts once.
ros::Subscriber CommandNode::keepAlives(const ros::NodeHandle& node) {
  const boost::function<void(const std_msgs::EmptyConstPtr&)> take = [this](const std_msgs::EmptyConstPtr&) {
    runtime_->keepJogging();
  };
  return OwnHandle(node).subscribe<std_msgs::Empty>("jog_keep_alive", 1, take, ros::VoidConstPtr(),
                                                    ros::TransportHints().tcpNoDelay());
}

CommandNode::~CommandNode() {
  stop();
}

void CommandNode::retire(const std::function<void()>& begun) {
  runtime_->retire(begun);
}

void CommandNode::stop() {
  if (std::exchange(stopped_, true)) return;
  if (seat_) seat_->stop();
  runtime_->retire();
  intake_.advance(Instant::max());  // so that the core ends those too
  runtime_->stop();
  tables_->close();  // as the core is, whoever waits for either has an answer
  for (ServingThread* thread : threads()) thread->stop();
  deliverPublished(kDeliveryPatience);
}

GoalSink CommandNode::goalSink() {
  return {[this](IncomingGoal goal) {
            endFallen();
            intake_.submit(std::move(goal), steadyNow());
            adjustRetrying();
          },
          [this](blocks::GoalId id, blocks::GoalId newest) { intake_.cancel(id, newest); }};
}

/// They name neither frames nor files.
GoalSink CommandNode::stopSink() {
  return {[this](const IncomingGoal& goal) { submit(goal.id, goal.read({})); },
          [this](blocks::GoalId id, blocks::GoalId newest) { runtime_->cancel(id, newest); }};
}

GoalIntake::Core CommandNode::intakeCore() {
  return {[this](blocks::GoalId id, blocks::Goal goal) { submit(id, std::move(goal)); },
          [this](blocks::GoalId id, blocks::GoalId newest) { runtime_->cancel(id, newest); },
          [this](blocks::Block block, blocks::GoalId id, const blocks::Outcome& outcome) {
            end(block, id, outcome);
          }};
}

FileSource CommandNode::fileSource() {
  return {[this](blocks::GoalId id, FileKind kind, const std::string& location) {
            return goal_files_.find(id, kind, location);
          },
          [this](blocks::GoalId id) { goal_files_.forget(id); }};
}

std::unique_ptr<TableServices> CommandNode::tableServices(const ros::NodeHandle& node,
                                                          const TableParameters& parameters) {
  TableWriter::Core core{[this](const command::TableWrite& write) { return runtime_->tryTable(write); },
                         [this](const command::TableWrite& write) { return runtime_->writeTable(write); }};
  TableWriter::Keep keep = [path = parameters.file](const tables::DataTables& tables) {
    return path.empty() ? std::nullopt : writeTablesFile(path, toFile(tables));
  };
  return std::make_unique<TableServices>(node, parameters.tables, std::move(core), std::move(keep));
}

/// It has not come to its block, whose outputs show nothing of it.
void CommandNode::end(blocks::Block block, blocks::GoalId id, const blocks::Outcome& outcome) {
  of(block).ended(id, outcome, {ros::Time::now(), steadyNow()});
  runtime_->tellEnd(block, outcome);
}

void CommandNode::endFallen() {
  std::vector<command::CommandsFell> fell;
  {
    const std::lock_guard<std::mutex> lock(fell_mutex_);
    fell.swap(fell_);
  }
  for (const auto& [newest, why] : fell) intake_.fall(newest, why);
}

/// The timer runs only while a goal waits for its frame.
void CommandNode::adjustRetrying() {
  if (intake_.isWaiting()) {
    retry_.start();
  } else {
    retry_.stop();
  }
}

void CommandNode::submit(blocks::GoalId id, blocks::Goal goal) {
  if (auto* connect = std::get_if<blocks::ConnectGoal>(&goal)) {
    if (connect->host.empty()) connect->host = default_host_;
    if (connect->port == 0) connect->port = default_port_;
  }
  // Refused only once the node is being destroyed, when nobody hears an answer any more.
  static_cast<void>(runtime_->submit(id, std::move(goal)));
}

bool CommandNode::finish(cobot_command::Finish::Request& request, cobot_command::Finish::Response& response) {
  using Request = cobot_command::Finish::Request;
  if (request.after > Request::CYCLE) {
    response.message = fmt::format("after is {}; it must be 0 (MOVE) or 1 (CYCLE)", request.after);
    return true;
  }
  const auto after = request.after == Request::MOVE ? blocks::FinishAfter::Move : blocks::FinishAfter::Cycle;
  auto report = runtime_->finish(after, currentReceipt());
  const int fallen = report ? intake_.fall(currentReceipt(), command::kNothingBehindFinish) : 0;
  if (!report) {
    response.message = "the command layer is shutting down";
  } else if (report->wait_for(kFinishPatience) != std::future_status::ready) {
    response.success = true;
    response.message = kNotAnsweredYet;
  } else {
    auto found = report->get();
    found.dropped += fallen;
    response.success = found.foundAny();
    response.message = forPeople(command::toText(found));
  }
  return true;
}

// Connections and bytes are the runtime's own business.
void CommandNode::onAction(const command::Action& action, Instant now) {
  const ClockPair clocks{ros::Time::now(), now};
  tellGoals(action, clocks);
  tellPaths(action);
  tellRobot(action, clocks);
}

void CommandNode::tellGoals(const command::Action& action, const ClockPair& clocks) {
  std::visit(
      Overloaded{
          [&](const command::GoalAccepted& a) { of(a.block).accepted(a.goal); },
          [&](const command::GoalProgressed& a) { of(a.block).progressed(a.goal, a.progress, clocks); },
          [&](const command::GoalEnded& a) { of(a.block).ended(a.goal, a.outcome, clocks); },
          [&](const command::CommandsFell& a) {
            const std::lock_guard<std::mutex> lock(fell_mutex_);
            fell_.push_back(a);
          },
          [](const auto&) {},
      },
      action);
}

void CommandNode::tellPaths(const command::Action& action) {
  std::visit(Overloaded{
                 [&](const command::GoalProgressed& a) { paths_->take(a); },
                 [&](const command::GoalEnded& a) { paths_->take(a); },
                 [&](const command::PathControlsChanged& a) {
                   path_services_->take(a.controls);
                   paths_->take(a);
                 },
                 [&](const command::PathPlanned& a) { paths_->take(a); },
                 [&](const command::GoalPreviewed& a) { paths_->take(a); },
                 [&](const command::RunTold& a) { paths_->take(a); },
                 [](const auto&) {},
             },
             action);
}

void CommandNode::tellRobot(const command::Action& action, const ClockPair& clocks) {
  std::visit(Overloaded{
                 [&](const command::RobotStatusReceived& a) {
                   if (seat_) seat_->observe(a.status, clocks.core_now);
                   publisher_.publish(a);
                   diagnostics_.take(a.status);
                   robot_data_->take(a.status);
                 },
                 [&](const command::StatusChanged& a) {
                   if (seat_) seat_->observe(a.status, clocks.core_now);
                   publisher_.publish(a.status, clocks);
                   diagnostics_.take(a.status);
                 },
                 [&](const command::ActiveFramesChanged& a) { publisher_.publish(a.frames); },
                 [&](const command::TablesChanged& a) { tables_->take(a.tables); },
                 [&](const command::SoftwareLimitsChanged& a) {
                   arm_->take(a.arm);
                   robot_data_->armChanged();
                 },
                 [&](const command::FrameTraced& a) { publisher_.publish(a, clocks); },
                 [&](const command::LogMessage& a) { log(a); },
                 [&](const command::GroupStateChanged& a) {
                   publisher_.publish(a.state);
                   diagnostics_.take(a.state);
                 },
                 [&](const command::MessageRaised& a) { messages_->take(a, clocks); },
                 [&](const command::PendingChanged& a) { messages_->take(a, clocks); },
                 [](const auto&) {},
             },
             action);
}

}  // namespace cobot_command::ros_adapter
