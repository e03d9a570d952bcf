#include "cobot_command/ros/command/goal_files.h"

#include <algorithm>
#include <condition_variable>
#include <deque>
#include <exception>
#include <mutex>
#include <thread>
#include <utility>

#include "files/path_file.h"
#include "files/pick_and_place_file.h"
#include <fmt/format.h>

#include "cobot_command/common/foreign_text.h"
#include "cobot_command/common/time.h"

namespace cobot_command::ros_adapter {
namespace {

/// How long the end of the node waits for files that are being read.
constexpr Duration kPatience = std::chrono::milliseconds(50);

/// There is none, for that reason.
FileAnswer noAnswer(FileKind kind, std::string why) {
  if (kind == FileKind::Steps) return StepsAnswer(refuse(std::move(why)));
  return PointsAnswer(refuse(std::move(why)));
}

FileAnswer readFromDisk(FileKind kind, const std::string& location) {
  if (kind == FileKind::Steps) return readPickAndPlaceFile(location);
  return readPathFile(location);
}

FileAnswer readGuarded(const GoalFiles::Read& read, FileKind kind, const std::string& location) {
  try {
    return read(kind, location);
  } catch (
      const std::exception& failure) {  // of a library, on a file that nobody foresaw: it ends this goal only
    return noAnswer(
        kind, fmt::format("{}: it cannot be read: {}", foreignText(location), foreignText(failure.what())));
  }
}

}  // namespace

/// Outlives the object: a reading that hangs cannot be waited for.
class GoalFiles::Desk {
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
  std::optional<FileAnswer> answerOf(const Job& job) {
    const std::lock_guard<std::mutex> lock(mutex_);
    return job.answer;
  }
  /// Reads what is asked for, until the desk is closed.
  void serve() {
    while (const auto job = next()) finish(*job, readGuarded(read_, job->kind, job->location));
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
  void finish(Job& job, FileAnswer answer) {
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

GoalFiles::GoalFiles() : GoalFiles(readFromDisk) {}

GoalFiles::GoalFiles(Read read) : desk_(std::make_shared<Desk>(std::move(read))) {
  for (int i = 0; i < kReaders; ++i) std::thread([desk = desk_] { desk->serve(); }).detach();
}

GoalFiles::~GoalFiles() {
  desk_->close(kPatience);
}

std::optional<FileAnswer> GoalFiles::find(blocks::GoalId id, FileKind kind, const std::string& location) {
  const std::lock_guard<std::mutex> lock(mutex_);
  auto& job = jobs_[id];
  if (!job) {
    job = std::make_shared<Job>(Job{kind, location, std::nullopt});
    if (!desk_->ask(job)) {
      job->answer =
          noAnswer(kind, fmt::format("{}: {} files are already waiting to be read; send the goal again later",
                                     foreignText(location), kMostWaiting));
    }
  }
  return desk_->answerOf(*job);
}

void GoalFiles::forget(blocks::GoalId id) {
  const std::lock_guard<std::mutex> lock(mutex_);
  const auto found = jobs_.find(id);
  if (found == jobs_.end()) return;
  desk_->forget(found->second);
  jobs_.erase(found);
}

}  // namespace cobot_command::ros_adapter
