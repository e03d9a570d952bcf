#include "clients/background_calls.h"

#include <chrono>
#include <condition_variable>
#include <deque>
#include <mutex>
#include <thread>
#include <utility>

namespace cobot_command::rviz_plugin {

namespace {

using Clock = std::chrono::steady_clock;
constexpr std::chrono::seconds kPatience(1);

}  // namespace

/// Outlives the object while a call hangs.
struct BackgroundCalls::Shared {
  std::mutex mutex;
  std::condition_variable changed;
  struct Job {
    std::function<std::function<void()>()> run;
    std::function<void()> dropped;
    Clock::time_point posted;
  };
  std::deque<Job> jobs;
  std::deque<std::function<void()>> answers;
  bool ends = false;

  void serve() {
    std::unique_lock lock(mutex);
    while (true) {
      changed.wait(lock, [this] { return ends || !jobs.empty(); });
      if (ends) return;
      dropLate();
      if (jobs.empty()) continue;
      auto job = std::move(jobs.front());
      jobs.pop_front();
      lock.unlock();
      auto answer = job.run();
      lock.lock();
      answers.push_back(std::move(answer));
    }
  }

  /// With the lock held.
  void dropLate() {
    while (!jobs.empty() && Clock::now() - jobs.front().posted > kPatience) {
      if (jobs.front().dropped) answers.push_back(std::move(jobs.front().dropped));
      jobs.pop_front();
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

void BackgroundCalls::post(std::function<std::function<void()>()> job, std::function<void()> dropped) {
  const std::lock_guard lock(shared_->mutex);
  shared_->jobs.push_back({std::move(job), std::move(dropped), Clock::now()});
  shared_->changed.notify_all();
}

void BackgroundCalls::deliver() {
  std::deque<std::function<void()>> answers;
  {
    const std::lock_guard lock(shared_->mutex);
    shared_->dropLate();
    answers.swap(shared_->answers);
  }
  for (const auto& answer : answers) answer();
}

}  // namespace cobot_command::rviz_plugin
