// The steps files of pick-and-place goals, read beside ROS's spinner: a file system may hang.
//
// Each file is read on a thread of its own, and what has hung is left behind. Not thread-safe: the spinner
// owns it.
#pragma once

#include <condition_variable>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include "cobot_command/blocks/goal.h"
#include "cobot_command/ros/goal_messages.h"

namespace cobot_command::ros_adapter {

class StepsFiles {
 public:
  /// The steps at a location; called on any thread, also of several at once.
  using Read = std::function<StepsAnswer(const std::string& location)>;

  StepsFiles();  ///< from the disk
  explicit StepsFiles(Read read);
  ~StepsFiles();
  StepsFiles(const StepsFiles&) = delete;
  StepsFiles& operator=(const StepsFiles&) = delete;

  /// The file of a goal, or why there is none; nothing as long as it is being read. The first call begins
  /// that, and never waits.
  [[nodiscard]] std::optional<StepsAnswer> find(blocks::GoalId id, const std::string& location);
  /// The goal needs its file no more.
  void forget(blocks::GoalId id);

 private:
  struct Job {
    std::optional<StepsAnswer> answer;
  };
  class Desk;

  [[nodiscard]] std::shared_ptr<Job> begin(const std::string& location);

  Read read_;
  std::shared_ptr<Desk> desk_;
  std::map<blocks::GoalId, std::shared_ptr<Job>> jobs_;
};

}  // namespace cobot_command::ros_adapter
