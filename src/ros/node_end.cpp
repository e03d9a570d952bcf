#include "cobot_command/ros/node_end.h"

#include <atomic>
#include <condition_variable>
#include <cstdio>
#include <cstdlib>
#include <mutex>
#include <thread>
#include <utility>

#include <boost/asio/executor_work_guard.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/signal_set.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/make_shared.hpp>
#include <ros/callback_queue.h>
#include <ros/console.h>
#include <ros/init.h>
#include <ros/poll_manager.h>
#include <ros/xmlrpc_manager.h>

#include "cobot_command/common/foreign_text.h"
#include "cobot_command/runtime/end_signals.h"

namespace cobot_command::ros_adapter {
namespace {

/// How often the queue is looked at for ros::ok(); who asks for the end wakes it up.
const ros::WallDuration kServePeriod(0.1);

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

class NodeEnd::Impl {
 public:
  Impl() {
    for (const int signal : runtime::endSignals()) signals_.add(signal);
    signals_.async_wait([this](const boost::system::error_code& cancelled, int) {
      if (!cancelled) ask();
    });
    thread_ = std::thread([this] { context_.run(); });
  }

  ~Impl() {
    context_.stop();
    thread_.join();
  }

  void serve(std::function<void()> begin) {
    listenToMaster();
    boost::asio::post(context_, [this, begin = std::move(begin)]() mutable {
      begin_ = std::move(begin);
      if (asked_) begin_();
    });
    ros::CallbackQueue& queue = *ros::getGlobalCallbackQueue();
    while (!asked_ && ros::ok()) queue.callAvailable(kServePeriod);
    unlistenToMaster();
  }

  void leaveWithin(Duration patience) {
    boost::asio::post(context_, [this, patience] { limitFarewell(patience); });
  }

 private:
  void ask() {
    if (asked_.exchange(true)) return;
    if (begin_) {
      begin_();
    } else {
      ros::requestShutdown();
      limitFarewell(kFarewellPatience);
    }
    ros::getGlobalCallbackQueue()->addCallback(boost::make_shared<WakeUp>());
  }

  void limitFarewell(Duration patience) {
    farewell_.expires_after(patience);
    farewell_.async_wait([](const boost::system::error_code& cancelled) {
      if (cancelled) return;
      std::fputs("the ROS master does not answer: leaving without a goodbye\n", stderr);
      std::_Exit(0);
    });
  }

  /// `rosnode kill`, or another node of this name: roscpp would take the topics away at once.
  void listenToMaster() {
    const auto& xmlrpc = ros::XMLRPCManager::instance();
    xmlrpc->unbind(kShutdown);
    xmlrpc->bind(kShutdown, [this](XmlRpc::XmlRpcValue& parameters, XmlRpc::XmlRpcValue& result) {
      using Value = XmlRpc::XmlRpcValue;
      if (parameters.getType() == Value::TypeArray && parameters.size() > 1 &&
          parameters[1].getType() == Value::TypeString) {
        ROS_WARN_STREAM("asked to shut down: " << foreignText(static_cast<std::string&>(parameters[1])));
      }
      boost::asio::post(context_, [this] { ask(); });
      result = ros::xmlrpc::responseInt(1, "", 0);
    });
  }
  static void unlistenToMaster() { ros::XMLRPCManager::instance()->unbind(kShutdown); }

  static constexpr const char* kShutdown = "shutdown";

  boost::asio::io_context context_;
  boost::asio::executor_work_guard<boost::asio::io_context::executor_type> work_{context_.get_executor()};
  boost::asio::signal_set signals_{context_};
  boost::asio::steady_timer farewell_{context_};
  std::function<void()> begin_;  ///< of the thread
  std::atomic<bool> asked_{false};
  std::thread thread_;
};

NodeEnd::NodeEnd() : impl_(std::make_unique<Impl>()) {}
NodeEnd::~NodeEnd() = default;

void NodeEnd::serve(std::function<void()> begin) {
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
