#include "shared/core_thread.h"

#include <cassert>
#include <utility>

#include <boost/asio/post.hpp>

namespace cobot_command::runtime {

CoreThread::CoreThread() : work_(context_.get_executor()) {}

CoreThread::~CoreThread() {
  finish([] {});
}

void CoreThread::start() {
  thread_ = std::thread([this] { context_.run(); });
}

bool CoreThread::post(Task task, Tasks& tasks) {
  const std::lock_guard<std::mutex> lock(posting_);
  if (open_) {
    tasks.push_back(std::move(task));
    boost::asio::post(context_, [this] { runNext(); });
  }
  return open_;
}

/// As often as tasks were posted, so that there is one.
void CoreThread::runNext() {
  Task next;
  {
    const std::lock_guard<std::mutex> lock(posting_);
    Tasks& tasks = urgent_.empty() ? tasks_ : urgent_;
    next = std::move(tasks.front());
    tasks.pop_front();
  }
  next();
}

void CoreThread::finish(Task last) {
  {
    const std::lock_guard<std::mutex> lock(posting_);
    if (std::exchange(open_, false)) {
      boost::asio::post(context_, [this, last = std::move(last)] {
        last();
        context_.stop();
      });
    }
  }
  const std::lock_guard<std::mutex> lock(joining_);
  if (thread_.joinable()) {
    assert(thread_.get_id() != std::this_thread::get_id());
    thread_.join();
  }
}

}  // namespace cobot_command::runtime
