// A target that is being chosen: whether the arm reaches it, in which configurations, and how it would stand.
// Dragged in RViz.
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "clients/background_calls.h"
#include "preview/preview.h"
#include <cobot_command/InverseKinematics.h>
#include <interactive_markers/interactive_marker_server.h>

namespace cobot_command::rviz_plugin {

/// config1..3 of RobotPose.msg.
using Configuration = std::array<int, 3>;

class Target {
 public:
  using Six = std::array<double, 6>;

  Target(Robot& robot, Preview& preview);

  /// The active TCP in the active base [mm, deg]. Nothing for `configuration`: as the arm stands now.
  void show(const Six& target, const std::optional<Configuration>& configuration);
  void hide();
  /// Often.
  void look() { calls_.deliver(); }
  /// In which the target that was shown last can be reached, within the limits.
  [[nodiscard]] const std::vector<Configuration>& configurations() const { return configurations_; }
  /// Where somebody has dragged it to.
  void onDrag(std::function<void(const Six&)> listener) { dragged_ = std::move(listener); }

 private:
  struct Question {
    Six target;
    std::optional<Configuration> configuration;
  };

  void ask(const Question& question);
  void answer(const Six& target, bool answered, const cobot_command::InverseKinematics& service);
  void placeMarker(const Six& target);
  void hear(const visualization_msgs::InteractiveMarkerFeedback& feedback);

  Robot& robot_;
  Preview& preview_;
  std::string name_;  ///< of its marker, and of no other: all servers of a topic hear of all drags
  std::unique_ptr<interactive_markers::InteractiveMarkerServer> server_;
  std::function<void(const Six&)> dragged_;
  std::vector<Configuration> configurations_;
  bool is_asking_ = false;        ///< one question at a time
  std::optional<Question> next_;  ///< the newest one, while another is being answered
  bool is_hidden_ = true;
  Six shown_{};
  BackgroundCalls calls_;  ///< of its own: a target that is dragged holds up nothing else
};

}  // namespace cobot_command::rviz_plugin
