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

bool CoreThread::post(Task task) {
  const std::lock_guard<std::mutex> lock(posting_);
  if (open_) {
    boost::asio::post(context_, std::move(task));
  }
  return open_;
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
