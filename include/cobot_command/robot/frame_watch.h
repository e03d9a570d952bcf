// The active base and TCP: what the controller streams, and what was commanded since.
//
// A change counts from its acceptance on, as the commands behind it are taken in it. The stream is behind by
// a period at least, and by whole motions when the change waits behind them; so it is believed again only
// when it shows the commanded value, or when the robot stands and it has shown another for long enough.
#pragma once

#include <optional>

#include "cobot_command/robot/active_frames.h"
#include "cobot_command/robot/robot_watch.h"
#include "cobot_command/script/script_command.h"

namespace cobot_command::robot {

class FrameWatch {
 public:
  /// A change that the controller accepted; other commands mean nothing here. `behind_motion`: the robot may
  /// still have to finish others first.
  void accepted(const script::ScriptCommand& command, bool behind_motion, Instant now);
  void robotChanged(const RobotWatch& robot, Instant now);
  /// The queue was emptied: a change that waited in it will not come.
  void stopped();
  /// Nothing that was commanded is known to hold: the link is another one, or the project started anew.
  void forget() { base_.reset(), tcp_.reset(); }

  [[nodiscard]] ActiveFrames frames() const;

 private:
  struct Commanded {
    std::optional<arm::Pose> pose;  ///< absent: a name of the project, whose pose only the stream can tell
    std::string name;
    std::optional<double> mass;
    bool behind_motion = false;
    Instant since;
  };
  [[nodiscard]] static bool isOver(const Commanded& commanded, const std::optional<arm::Pose>& streamed,
                                   const std::optional<std::string>& streamed_name, const RobotWatch& robot,
                                   Instant now);

  std::optional<Commanded> base_;
  std::optional<Commanded> tcp_;
  ActiveFrames streamed_;
};

}  // namespace cobot_command::robot
