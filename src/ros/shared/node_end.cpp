#include "cobot_command/ros/shared/node_end.h"

#include <atomic>
#include <condition_variable>
#include <cstdio>
#include <cstdlib>
#include <future>
#include <mutex>
#include <string>
#include <thread>
#include <utility>

#include <boost/asio/executor_work_guard.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/signal_set.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/make_shared.hpp>
#include <fmt/format.h>
#include <ros/callback_queue.h>
#include <ros/console.h>
#include <ros/init.h>
#include <ros/master.h>
#include <ros/poll_manager.h>
#include <ros/xmlrpc_manager.h>

#include "cobot_command/common/foreign_text.h"
#include "cobot_command/runtime/shared/end_signals.h"

namespace cobot_command::ros_adapter {
namespace {

constexpr double kServePeriod = 1;  // [s]; who asks for the end wakes the queue up, and so does roscpp
/// From here on whoever has asked for the end, and sees nothing of it, wants to know why.
constexpr Duration kPatienceWithoutWords = std::chrono::seconds(1);

/// What a node is at, in the order of its life.
enum class Stage { Beginning, Joining, Starting, Serving, Ending, Leaving };

std::string describe(Stage stage) {
  switch (stage) {
    case Stage::Beginning:
    case Stage::Joining:
      return "joining the ROS master at " + ros::master::getURI();
    case Stage::Starting:
      return "starting, with its requests to the ROS master at " + ros::master::getURI();
    case Stage::Serving:
      return "the running callback";
    case Stage::Ending:
      return "ending the running commands";
    case Stage::Leaving:
      return "removing its topics, services and parameters from the ROS master at " + ros::master::getURI();
  }
  return "";
}

struct WakeUp : ros::CallbackInterface {
  CallResult call() override { return Success; }
};

/// Counts how often ROS's poll thread has come round.
class PollRounds {
 public:
  void count() {
    const std::lock_guard<std::mutex> lock(mutex_);
    ++count_;
    changed_.notify_all();
  }
  bool reach(int count, Duration patience) {
    std::unique_lock<std::mutex> lock(mutex_);
    return changed_.wait_for(lock, patience, [&] { return count_ >= count; });
  }

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  int count_ = 0;
};

}  // namespace

/// The stage and `begin_` belong to its thread: whoever moves on waits for that.
class NodeEnd::Impl {
 public:
  Impl(int argc, char** argv, const std::string& name) {
    for (const int signal : runtime::endSignals()) signals_.add(signal);
    signals_.async_wait([this](const boost::system::error_code& cancelled, int) {
      if (!cancelled) ask();
    });
    thread_ = std::thread([this] { context_.run(); });
    try {
      ros::init(argc, argv, name, ros::init_options::NoSigintHandler);
    } catch (...) {  // of names; the thread must not outlive this
      context_.stop();
      thread_.join();
      throw;
    }
    listenToMaster();
    moveOn([this] { stage_ = Stage::Joining; });
  }

  ~Impl() {
    ros::XMLRPCManager::instance()->unbind(kShutdown);
    context_.stop();
    thread_.join();
  }

  [[nodiscard]] bool isAskedFor() const { return asked_; }

  void joined() {
    moveOn([this] { stage_ = Stage::Starting; });
  }

  void serve(std::function<void(Begun)> begin) {
    moveOn([&] {
      stage_ = Stage::Serving;
      begin_ = std::move(begin);
      if (asked_) beginEnd();
    });
    ros::CallbackQueue& queue = *ros::getGlobalCallbackQueue();
    while (!asked_ && ros::ok()) queue.callAvailable(ros::WallDuration(kServePeriod));
    moveOn([this] {
      stage_ = Stage::Ending;
      beginEnd();  // if nobody has asked: roscpp can be shut down from within
    });
  }

  void leaveWithin(Duration patience) {
    moveOn([this, patience] {
      stage_ = Stage::Leaving;
      limit(patience);
    });
  }

 private:
  /// Does it on the thread, behind whatever that does, and returns when it is done.
  template <class Step>
  void moveOn(const Step& step) {
    std::promise<void> done;
    boost::asio::post(context_, [&] {
      step();
      done.set_value();
    });
    done.get_future().wait();
  }

  void ask() {
    if (asked_.exchange(true)) return;
    // In its first two stages ROS waits for a master for ever. In the first it has nothing yet to take back.
    if (stage_ == Stage::Beginning) std::_Exit(0);
    if (stage_ == Stage::Joining) ros::requestShutdown();
    if (stage_ == Stage::Serving) {
      beginEnd();
      ros::getGlobalCallbackQueue()->addCallback(boost::make_shared<WakeUp>());
    } else if (stage_ != Stage::Ending) {
      limit(kFarewellPatience);
    }
  }

  /// Once. The time that is left runs from when the end has begun: the command layer may be planning, and the
  /// stop of the robot waits behind that.
  void beginEnd() {
    const auto begin = std::exchange(begin_, nullptr);
    if (!begin) return;
    farewell_.expires_after(kPatienceWithoutWords);
    farewell_.async_wait([](const boost::system::error_code& replaced) {
      if (replaced) return;
      ROS_WARN(
          "shutdown was requested, but the robot is not stopped yet: the command layer is busy (for example, "
          "planning); waiting until it is done");
    });
    begin([this] { boost::asio::post(context_, [this] { limit(kFarewellPatience); }); });
  }

  void limit(Duration patience) {
    farewell_.expires_after(patience);
    farewell_.async_wait([this, patience](const boost::system::error_code& replaced) {
      if (replaced) return;
      fmt::print(stderr, "{} s were not enough for {}: the process exits without cleaning up\n",
                 toSeconds(patience), describe(stage_));
      std::quick_exit(0);  // with what it said last
    });
  }

  /// `rosnode kill`, or another node of this name: roscpp would take the topics away at once. Bound before
  /// roscpp does so itself, which then leaves it as it is.
  void listenToMaster() {
    ros::XMLRPCManager::instance()->bind(
        kShutdown, [this](XmlRpc::XmlRpcValue& parameters, XmlRpc::XmlRpcValue& result) {
          using Value = XmlRpc::XmlRpcValue;
          const bool says_why = parameters.getType() == Value::TypeArray && parameters.size() > 1 &&
                                parameters[1].getType() == Value::TypeString;
          const std::string why = says_why ? static_cast<std::string&>(parameters[1]) : "";
          boost::asio::post(context_, [this, why] {
            if (!asked_) ROS_WARN_STREAM("asked to shut down: " << foreignText(why));
            ask();
          });
          result = ros::xmlrpc::responseInt(1, "", 0);
        });
  }

  static constexpr const char* kShutdown = "shutdown";

  boost::asio::io_context context_;
  boost::asio::executor_work_guard<boost::asio::io_context::executor_type> work_{context_.get_executor()};
  boost::asio::signal_set signals_{context_};
  boost::asio::steady_timer farewell_{context_};
  Stage stage_ = Stage::Beginning;
  std::function<void(Begun)> begin_;  ///< while serving, until it is called
  std::atomic<bool> asked_{false};
  std::thread thread_;
};

NodeEnd::NodeEnd(int argc, char** argv, const std::string& name)
    : impl_(std::make_unique<Impl>(argc, argv, name)) {}
NodeEnd::~NodeEnd() = default;

bool NodeEnd::isAskedFor() const {
  return impl_->isAskedFor();
}

bool NodeEnd::joined() {
  impl_->joined();
  return !isAskedFor();
}

void NodeEnd::serve(std::function<void(Begun)> begin) {
  impl_->serve(std::move(begin));
}

void NodeEnd::leaveWithin(Duration patience) {
  impl_->leaveWithin(patience);
}

bool deliverPublished(Duration patience) {
  // In one round the poll thread takes what was published to the connections and writes it; a listener that
  // is added now is called for the first time between the two.
  constexpr int kRoundsUntilWritten = 3;
  const auto& poll = ros::PollManager::instance();
  const auto rounds = std::make_shared<PollRounds>();
  const auto listener = poll->addPollThreadListener([rounds, poll] {
    rounds->count();
    poll->getPollSet().signal();  // no waiting in between
  });
  poll->getPollSet().signal();
  const bool delivered = rounds->reach(kRoundsUntilWritten, patience);
  poll->removePollThreadListener(listener);
  return delivered;
}

}  // namespace cobot_command::ros_adapter
