#include "cobot_command/ros/command/steps_files.h"

#include <algorithm>
#include <condition_variable>
#include <deque>
#include <exception>
#include <mutex>
#include <thread>
#include <utility>

#include "command/pick_and_place_file.h"
#include <fmt/format.h>

#include "cobot_command/common/foreign_text.h"
#include "cobot_command/common/time.h"

namespace cobot_command::ros_adapter {
namespace {

/// How long the end of the node waits for files that are being read.
constexpr Duration kPatience = std::chrono::milliseconds(50);

StepsAnswer readGuarded(const StepsFiles::Read& read, const std::string& location) {
  try {
    return read(location);
  } catch (
      const std::exception& failure) {  // of a library, on a file that nobody foresaw: it ends this goal only
    return refuse(
        fmt::format("{}: it cannot be read: {}", foreignText(location), foreignText(failure.what())));
  }
}

}  // namespace

/// Outlives the object: a reading that hangs cannot be waited for.
class StepsFiles::Desk {
 public:
  explicit Desk(Read read) : read_(std::move(read)) {}

  /// False: too many wait.
  bool ask(const std::shared_ptr<Job>& job) {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (waiting_.size() >= kMostWaiting) return false;
    waiting_.push_back(job);
    changed_.notify_all();
    return true;
  }
  void forget(const std::shared_ptr<Job>& job) {
    const std::lock_guard<std::mutex> lock(mutex_);
    waiting_.erase(std::remove(waiting_.begin(), waiting_.end(), job), waiting_.end());
  }
  std::optional<StepsAnswer> answerOf(const Job& job) {
    const std::lock_guard<std::mutex> lock(mutex_);
    return job.answer;
  }
  /// Reads what is asked for, until the desk is closed.
  void serve() {
    while (const auto job = next()) finish(*job, readGuarded(read_, job->location));
  }
  /// What is being read may come to its end.
  void close(Duration patience) {
    std::unique_lock<std::mutex> lock(mutex_);
    open_ = false;
    changed_.notify_all();
    changed_.wait_for(lock, patience, [this] { return reading_ == 0; });
  }

 private:
  std::shared_ptr<Job> next() {
    std::unique_lock<std::mutex> lock(mutex_);
    changed_.wait(lock, [this] { return !open_ || !waiting_.empty(); });
    if (!open_) return nullptr;
    auto job = std::move(waiting_.front());
    waiting_.pop_front();
    ++reading_;
    return job;
  }
  void finish(Job& job, StepsAnswer answer) {
    const std::lock_guard<std::mutex> lock(mutex_);
    job.answer = std::move(answer);
    --reading_;
    changed_.notify_all();
  }

  const Read read_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<std::shared_ptr<Job>> waiting_;
  int reading_ = 0;
  bool open_ = true;
};

StepsFiles::StepsFiles() : StepsFiles(readPickAndPlaceFile) {}

StepsFiles::StepsFiles(Read read) : desk_(std::make_shared<Desk>(std::move(read))) {
  for (int i = 0; i < kReaders; ++i) std::thread([desk = desk_] { desk->serve(); }).detach();
}

StepsFiles::~StepsFiles() {
  desk_->close(kPatience);
}

std::optional<StepsAnswer> StepsFiles::find(blocks::GoalId id, const std::string& location) {
  auto& job = jobs_[id];
  if (!job) {
    job = std::make_shared<Job>(Job{location, std::nullopt});
    if (!desk_->ask(job)) {
      job->answer = refuse(fmt::format("{}: {} files wait to be read already; send the goal again later",
                                       foreignText(location), kMostWaiting));
    }
  }
  return desk_->answerOf(*job);
}

void StepsFiles::forget(blocks::GoalId id) {
  const auto found = jobs_.find(id);
  if (found == jobs_.end()) return;
  desk_->forget(found->second);
  jobs_.erase(found);
}

}  // namespace cobot_command::ros_adapter
