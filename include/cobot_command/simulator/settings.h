// How a simulated controller is set up; every default is what a TMflow project with one Listen node would
// show.
#pragma once

#include <string>

#include "cobot_command/arm/types.h"
#include "cobot_command/common/time.h"
#include "cobot_command/common/units.h"

namespace cobot_command::simulator {

struct Settings {
  std::string listen_node_message = "Listen1";  ///< sent when the node is entered
  bool project_running = true;                  ///< at the start
  /// Posture at the start [rad]: J = 0, 0, 90, 0, 90, 0 degrees, tool downwards.
  arm::JointVector start_posture =
      (arm::JointVector() << 0.0, 0.0, degToRad(90), 0.0, degToRad(90), 0.0).finished();
  Duration status_period = std::chrono::milliseconds(15);  ///< of the status stream (fact sheet chapter 3)
  int project_speed_percent = 100;                         ///< 5..100, multiples of 5
  bool accept_empty_length = false;                        ///< see FrameDecoder::Options
  /// After StopAndClearBuffer a real controller was seen to report the tags of dropped motions later
  /// (tmr_ros2 #15).
  bool reports_stale_tags = false;
};

}  // namespace cobot_command::simulator
