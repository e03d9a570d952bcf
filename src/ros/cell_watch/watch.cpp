#include "cell_watch/watch.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <variant>

#include "cell_watch/distance_messages.h"
#include "cell_watch/joint_reading.h"
#include "shared/steady_now.h"
#include <fmt/format.h>
#include <ros/console.h>

#include "cobot_command/CellDistances.h"
#include "cobot_command/common/foreign_text.h"
#include "cobot_command/common/overloaded.h"

namespace cobot_command::ros_adapter {
namespace {

/// Distances are not told more often.
constexpr Duration kTellPeriod = std::chrono::milliseconds(50);
/// That is told, too, where nothing is new, so that whoever listens knows of a monitor that has died.
constexpr Duration kHeartbeat = std::chrono::seconds(1);
/// The shortest that a timer is set to [s].
constexpr double kAtOnce = 1e-4;
/// A newer one says more than one that has to wait.
constexpr std::uint32_t kMeasured = 1;
constexpr std::uint32_t kReports = 100;
constexpr std::uint32_t kStates = 10;

/// The monitor drops and counts that.
arm::JointVector malformedJoints() {
  return arm::JointVector::Constant(std::numeric_limits<double>::quiet_NaN());
}

std::string topicOf(const MoverNamespaces::Mover& mover) {
  return mover.space + (mover.is_mechanism ? "/position" : "/joint_states");
}

template <class Message>
std::shared_ptr<ros::Subscriber> subscriberOf(
    OwnHandle node, const std::string& topic,
    const boost::function<void(const boost::shared_ptr<Message const>&)>& take) {
  return std::make_shared<ros::Subscriber>(node.subscribe<Message>(
      topic, kMeasured, take, ros::VoidConstPtr(), ros::TransportHints().tcpNoDelay()));
}

}  // namespace

Watch::Watch(const ros::NodeHandle& node, cell::Monitor monitor, MoverNamespaces namespaces,
             std::optional<BelievedPlaces> places, PrefixTold prefix_told)
    : node_(node),
      monitor_(std::move(monitor)),
      namespaces_(std::move(namespaces)),
      places_(std::move(places)),
      beliefs_(namespaces_.movers().size()),
      prefix_told_(std::move(prefix_told)),
      is_prefix_told_(namespaces_.movers().size()),
      measured_(namespaces_.movers().size()) {
  node_.setCallbackQueue(queue_.get());
}

Watch::~Watch() {
  stop();
}

void Watch::start() {
  distances_ = node_.advertise<cobot_command::CellDistances>("distances", 10, true);
  for (std::size_t mover = 0; mover < measured_.size(); ++mover) {
    const MoverNamespaces::Mover& known = namespaces_.movers()[mover];
    stop_lines_.push_back(std::make_unique<StopLine>(node_, queue_, known.name, known.space));
    measured_[mover].set(listeningTo(mover)());
  }
  reports_ = node_.subscribe("reports", kReports, &Watch::hear, this);
  if (places_) {
    states_ = node_.subscribe("state", kStates, &Watch::hearState, this, ros::TransportHints().tcpNoDelay());
  }
  reset_ = node_.advertiseService("reset_monitor", &Watch::reset, this);
  timer_ = node_.createSteadyTimer(
      ros::WallDuration(kAtOnce),
      [this](const ros::SteadyTimerEvent&) {
        armed_.reset();
        advance(steadyNow());
      },
      true, false);
  tell(steadyNow());
  spinner_ = std::make_unique<ros::AsyncSpinner>(1, queue_.get());
  spinner_->start();
}

void Watch::stop() {
  if (!spinner_) return;
  timer_.stop();
  for (auto& one : measured_) one.drop();
  for (const auto& line : stop_lines_) line->end();
  reports_.shutdown();
  states_.shutdown();
  reset_.shutdown();
  spinner_->stop();
  spinner_.reset();
}

WatchView Watch::view() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return view_;
}

MadeBeside<ros::Subscriber>::Make Watch::listeningTo(std::size_t mover) {
  const MoverNamespaces::Mover& known = namespaces_.movers()[mover];
  const std::string topic = topicOf(known);
  // The queue goes along: it has to be there for as long as the master takes.
  if (known.is_mechanism) {
    return [this, mover, node = node_, queue = queue_, topic] {
      return subscriberOf<std_msgs::Float64>(
          node, topic, [this, mover](const auto& message) { takePosition(mover, message->data); });
    };
  }
  return [this, mover, node = node_, queue = queue_, topic] {
    return subscriberOf<sensor_msgs::JointState>(
        node, topic, [this, mover](const auto& message) { take(mover, *message); });
  };
}

void Watch::take(std::size_t robot, const sensor_msgs::JointState& message) {
  const Instant now = steadyNow();
  const std::string& name = namespaces_.movers()[robot].name;
  const auto reading = readJoints(message);
  if (reading) {
    namespaces_.heard(robot, now);
    // By the arrival here: what others write into a stamp is theirs.
    monitor_.take(name, reading->joints, reading->velocities, Duration(0), now);
    if (places_) places_->measured(name, reading->joints, now);
    believe(robot, now);
    if (!is_prefix_told_[robot]) {
      is_prefix_told_[robot] = true;
      prefix_told_(robot, reading->prefix);
    }
  } else {
    monitor_.take(name, malformedJoints(), std::nullopt, Duration(0), now);
  }
  advance(now);
}

void Watch::takePosition(std::size_t mechanism, double position) {
  const Instant now = steadyNow();
  const std::string& name = namespaces_.movers()[mechanism].name;
  // What is no position leaves it unheard, as joints that are none do.
  if (std::isfinite(position)) namespaces_.heard(mechanism, now);
  monitor_.takePosition(name, position, Duration(0), now);
  if (places_) places_->measured(name, position * arm::JointVector::Unit(0), now);
  believe(mechanism, now);
  advance(now);
}

void Watch::hear(const ros::MessageEvent<cobot_command::CellReport const>& event) {
  const std::string& name = event.getConstMessage()->robot;
  const auto mover = namespaces_.reported(name, event.getPublisherName(), steadyNow());
  if (!mover) return;
  const std::string& space = namespaces_.movers()[*mover].space;
  ROS_WARN_STREAM(name << " reports from node " << foreignText(event.getPublisherName())
                       << ", but nothing is received in the namespace that the cell file gives: "
                       << "the monitor now subscribes in " << space << "/");
  stop_lines_[*mover]->moveTo(space);
  measured_[*mover].begin(listeningTo(*mover));
}

void Watch::hearState(const ros::MessageEvent<cobot_command::CellState const>& event) {
  const Instant now = steadyNow();
  places_->hear(*event.getConstMessage(), event.getPublisherName(), now);
  for (std::size_t mover = 0; mover < beliefs_.size(); ++mover) believe(mover, now);
  advance(now);
}

void Watch::believe(std::size_t mover, Instant now) {
  if (!places_) return;
  const std::string& name = namespaces_.movers()[mover].name;
  auto belief = places_->beliefOf(name, now);
  if (places_->mayCarry(name)) {
    const bool is_known = belief && monitor_.setCarried(name, belief->parts);
    if (!is_known) {
      belief.reset();
      monitor_.setCarried(name, std::nullopt);
    }
  }
  monitor_.setPermit(name, belief ? std::optional(belief->permit) : std::nullopt);
  beliefs_[mover] = std::move(belief);
}

void Watch::forget(Instant now) {
  for (std::size_t mover = 0; mover < beliefs_.size(); ++mover) {
    if (beliefs_[mover] && beliefs_[mover]->until < now) believe(mover, now);
  }
}

bool Watch::reset(std_srvs::Trigger::Request& /*request*/, std_srvs::Trigger::Response& response) {
  const Instant now = steadyNow();
  const cell::ResetAnswer answer = monitor_.reset(now);
  response.success = answer.success ? 1 : 0;
  response.message = forPeople(answer.message);
  ROS_INFO_STREAM("reset_monitor: " << forPeople(answer.message));
  is_news_ = true;
  advance(now);
  return true;
}

void Watch::advance(Instant now) {
  forget(now);
  const auto due = monitor_.nextDeadline();
  if (due && *due <= now) {
    monitor_.tick(now);
    is_news_ = true;
  }
  carryOut();
  const bool is_due = now - told_at_ >= kTellPeriod || monitor_.latched() != view_.status.latched;
  if ((is_news_ && is_due) || now - published_at_ >= kHeartbeat) tell(now);
  arm(now);
}

void Watch::carryOut() {
  for (const cell::MonitorAction& action : monitor_.takeActions()) {
    std::visit(Overloaded{[this](const cell::StopAll& known) { stopAll(known.why); },
                          [](const cell::Warning& known) { ROS_WARN_STREAM(forPeople(known.text)); },
                          [](const cell::BreachEnded& known) {
                            ROS_WARN_STREAM(forPeople(sentenceOf(known.breach)));
                          }},
               action);
  }
}

void Watch::stopAll(const std::string& why) {
  for (const auto& line : stop_lines_) line->stop();
  ROS_ERROR_STREAM("All robots and mechanisms of the cell are being stopped. " << forPeople(why));
}

void Watch::tell(Instant now) {
  const bool is_first = told_at_ == Instant{};
  is_news_ = false;
  told_at_ = now;
  WatchView view;
  view.status = monitor_.status();
  view.bodies = monitor_.bodies();
  for (std::size_t mover = 0; mover < measured_.size(); ++mover) {
    const MoverNamespaces::Mover& known = namespaces_.movers()[mover];
    view.movers.push_back({known.name, known.space, topicOf(known), known.heard.has_value(),
                           stop_lines_[mover]->isConnected(), carriedBy(mover)});
  }
  cobot_command::CellDistances message = toMessage(view.status);
  // Its thread alone writes it, so that it reads it without the lock.
  const bool is_changed = is_first || message != toMessage(view_.status);
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    view_ = std::move(view);
  }
  if (!is_changed && now - published_at_ < kHeartbeat) return;
  published_at_ = now;
  message.header.stamp = ros::Time::now();
  distances_.publish(message);
}

std::string Watch::carriedBy(std::size_t mover) const {
  if (!places_ || !places_->mayCarry(namespaces_.movers()[mover].name)) return "";
  if (!beliefs_[mover]) return "all parts it can carry, because the actual parts are unknown";
  const cell::Carried& parts = beliefs_[mover]->parts;
  return parts.empty() ? "nothing" : fmt::format("{}", fmt::join(parts, ", "));
}

void Watch::arm(Instant now) {
  Instant next = std::min(monitor_.nextDeadline().value_or(Instant::max()), published_at_ + kHeartbeat);
  if (is_news_) next = std::min(next, told_at_ + kTellPeriod);
  for (const auto& belief : beliefs_) {
    if (belief) next = std::min(next, belief->until + Duration(1));
  }
  if (armed_ && *armed_ <= next) return;  // it comes soon enough
  timer_.stop();
  timer_.setPeriod(ros::WallDuration(std::max(kAtOnce, toSeconds(next - now))));
  timer_.start();
  armed_ = next;
}

}  // namespace cobot_command::ros_adapter
