#include "clients/background_calls.h"

#include <condition_variable>
#include <deque>
#include <mutex>
#include <thread>
#include <utility>

namespace cobot_command::rviz_plugin {

/// Outlives the object while a call hangs.
struct BackgroundCalls::Shared {
  std::mutex mutex;
  std::condition_variable changed;
  std::deque<std::function<std::function<void()>()>> jobs;
  std::deque<std::function<void()>> answers;
  bool ends = false;

  void serve() {
    std::unique_lock lock(mutex);
    while (true) {
      changed.wait(lock, [this] { return ends || !jobs.empty(); });
      if (ends) return;
      auto job = std::move(jobs.front());
      jobs.pop_front();
      lock.unlock();
      auto answer = job();
      lock.lock();
      answers.push_back(std::move(answer));
    }
  }
};

BackgroundCalls::BackgroundCalls() : shared_(std::make_shared<Shared>()) {
  std::thread([shared = shared_] { shared->serve(); }).detach();
}

BackgroundCalls::~BackgroundCalls() {
  const std::lock_guard lock(shared_->mutex);
  shared_->ends = true;
  shared_->changed.notify_all();
}

void BackgroundCalls::post(std::function<std::function<void()>()> job) {
  const std::lock_guard lock(shared_->mutex);
  shared_->jobs.push_back(std::move(job));
  shared_->changed.notify_all();
}

void BackgroundCalls::deliver() {
  std::deque<std::function<void()>> answers;
  {
    const std::lock_guard lock(shared_->mutex);
    answers.swap(shared_->answers);
  }
  for (const auto& answer : answers) answer();
}

}  // namespace cobot_command::rviz_plugin
