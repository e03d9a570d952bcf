// The steps files of pick-and-place goals, read beside ROS's spinner: a file system may hang.
//
// A few threads, made with it, read them in the order in which they were asked for; more files than that wait
// for their turn, up to a bound. What has hung is left behind at the end. Not thread-safe: the spinner owns
// it.
#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "cobot_command/blocks/goal.h"
#include "cobot_command/ros/command/goal_lookups.h"

namespace cobot_command::ros_adapter {

class StepsFiles {
 public:
  /// The steps at a location; called on any thread, also of several at once.
  using Read = std::function<StepsAnswer(const std::string& location)>;

  /// So many are read at once: one that hangs does not hold up the next.
  static constexpr int kReaders = 4;
  /// So many more may wait to be read.
  static constexpr std::size_t kMostWaiting = 1000;

  StepsFiles();  ///< from the disk
  explicit StepsFiles(Read read);
  ~StepsFiles();
  StepsFiles(const StepsFiles&) = delete;
  StepsFiles& operator=(const StepsFiles&) = delete;

  /// The file of a goal, or why there is none; nothing as long as it is being read, or waits for that. The
  /// first call asks for it, and never waits.
  [[nodiscard]] std::optional<StepsAnswer> find(blocks::GoalId id, const std::string& location);
  /// The goal needs its file no more. If it still waits, it is not read.
  void forget(blocks::GoalId id);

 private:
  struct Job {
    std::string location;
    std::optional<StepsAnswer> answer;
  };
  class Desk;

  std::shared_ptr<Desk> desk_;
  std::map<blocks::GoalId, std::shared_ptr<Job>> jobs_;
};

}  // namespace cobot_command::ros_adapter
