#include "cobot_command/ros/steps_files.h"

#include <exception>
#include <thread>
#include <utility>

#include "pick_and_place_file.h"
#include <fmt/format.h>

#include "cobot_command/common/foreign_text.h"
#include "cobot_command/common/time.h"

namespace cobot_command::ros_adapter {
namespace {

/// So many files that do not come to their end may wait: beyond that the file system is not to be trusted.
constexpr int kMostReadings = 4;
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
  bool begin() {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (readings_ >= kMostReadings) return false;
    ++readings_;
    return true;
  }
  void end(Job& job, StepsAnswer answer) {
    const std::lock_guard<std::mutex> lock(mutex_);
    job.answer = std::move(answer);
    --readings_;
    changed_.notify_all();
  }
  std::optional<StepsAnswer> answerOf(const Job& job) {
    const std::lock_guard<std::mutex> lock(mutex_);
    return job.answer;
  }
  void waitForAll(Duration patience) {
    std::unique_lock<std::mutex> lock(mutex_);
    changed_.wait_for(lock, patience, [this] { return readings_ == 0; });
  }

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  int readings_ = 0;
};

StepsFiles::StepsFiles() : StepsFiles(readPickAndPlaceFile) {}

StepsFiles::StepsFiles(Read read) : read_(std::move(read)), desk_(std::make_shared<Desk>()) {}

StepsFiles::~StepsFiles() {
  desk_->waitForAll(kPatience);
}

std::optional<StepsAnswer> StepsFiles::find(blocks::GoalId id, const std::string& location) {
  auto& job = jobs_[id];
  if (!job) job = begin(location);
  return desk_->answerOf(*job);
}

void StepsFiles::forget(blocks::GoalId id) {
  jobs_.erase(id);
}

std::shared_ptr<StepsFiles::Job> StepsFiles::begin(const std::string& location) {
  auto job = std::make_shared<Job>();
  if (!desk_->begin()) {
    job->answer = refuse(fmt::format("{}: {} other files are being read, and do not come to their end",
                                     foreignText(location), kMostReadings));
    return job;
  }
  std::thread([job, location, read = read_, desk = desk_] {
    desk->end(*job, readGuarded(read, location));
  }).detach();
  return job;
}

}  // namespace cobot_command::ros_adapter
