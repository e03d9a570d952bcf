// Reads the files that goals name on threads of its own, because a file system may hang.
//
// A small number of threads, created with the object, read the files in the order of the requests. More files
// wait for their turn, up to a limit. At the end, a read that hangs is abandoned. Thread-safe.
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
  /// Reads the file at a location. Called on any thread, also on several at the same time.
  using Read = std::function<FileAnswer(FileKind kind, const std::string& location)>;

  /// Number of files that are read at the same time: one that hangs does not delay the next one.
  static constexpr int kReaders = 4;
  /// Number of further files that may wait to be read.
  static constexpr std::size_t kMostWaiting = 1000;

  GoalFiles();  ///< reads from the disk
  explicit GoalFiles(Read read);
  ~GoalFiles();
  GoalFiles(const GoalFiles&) = delete;
  GoalFiles& operator=(const GoalFiles&) = delete;

  /// The file of a goal, or why there is none; nullopt: it is being read, or waits to be read. The first call
  /// requests it. Never waits.
  [[nodiscard]] std::optional<FileAnswer> find(blocks::GoalId id, FileKind kind, const std::string& location);
  /// The goal no longer needs its file. A file that still waits is not read.
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
