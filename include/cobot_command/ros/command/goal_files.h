// The files that goals name, read beside ROS's spinner: a file system may hang.
//
// A few threads, made with it, read them in the order in which they were asked for; more files than that wait
// for their turn, up to a bound. What has hung is left behind at the end. Thread-safe.
#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include "cobot_command/blocks/list/goal.h"
#include "cobot_command/ros/command/goal_lookups.h"

namespace cobot_command::ros_adapter {

class GoalFiles {
 public:
  /// What is at a location; called on any thread, also of several at once.
  using Read = std::function<FileAnswer(FileKind kind, const std::string& location)>;

  /// So many are read at once: one that hangs does not hold up the next.
  static constexpr int kReaders = 4;
  /// So many more may wait to be read.
  static constexpr std::size_t kMostWaiting = 1000;

  GoalFiles();  ///< from the disk
  explicit GoalFiles(Read read);
  ~GoalFiles();
  GoalFiles(const GoalFiles&) = delete;
  GoalFiles& operator=(const GoalFiles&) = delete;

  /// The file of a goal, or why there is none; nothing as long as it is being read, or waits for that. The
  /// first call asks for it, and never waits.
  [[nodiscard]] std::optional<FileAnswer> find(blocks::GoalId id, FileKind kind, const std::string& location);
  /// The goal needs its file no more. If it still waits, it is not read.
  void forget(blocks::GoalId id);

 private:
  struct Job {
    FileKind kind;
    std::string location;
    std::optional<FileAnswer> answer;
  };
  class Desk;

  std::shared_ptr<Desk> desk_;
  std::mutex mutex_;
  std::map<blocks::GoalId, std::shared_ptr<Job>> jobs_;
};

}  // namespace cobot_command::ros_adapter
