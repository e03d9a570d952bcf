// All robots that there are, for the one command that is for all of them: stop.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "clients/command.h"
#include <ros/callback_queue.h>

namespace cobot_command::rviz_plugin {

class Fleet {
 public:
  Fleet();
  Fleet(const Fleet&) = delete;
  Fleet& operator=(const Fleet&) = delete;
  ~Fleet();

  /// The namespaces of the robots that there are; they have to be found before they are to be stopped.
  void offer(const std::vector<std::string>& names);
  [[nodiscard]] bool isMany() const { return robots_.size() > 1; }
  void stop();
  /// From time to time, on the thread of the user interface.
  void look();
  /// How the last stop went, in words; empty: none was given.
  [[nodiscard]] std::string told() const;
  [[nodiscard]] bool hasFailed() const;
  [[nodiscard]] bool isBusy() const;
  void forget();

 private:
  struct Member;

  ros::CallbackQueue queue_;  ///< first: all others are served by it
  std::map<std::string, std::unique_ptr<Member>> robots_;
};

}  // namespace cobot_command::rviz_plugin
