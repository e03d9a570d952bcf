// The active base and TCP: the values streamed by the controller, and those commanded since.
//
// A change counts from its acceptance on, because it applies to the commands after it. The stream is late by
// at least one period, and by whole motions if the change waits for them. So the stream counts again only
// when it shows the commanded value, or when the robot is at standstill and the stream has shown another
// value for long enough.
#pragma once

#include <optional>

#include "cobot_command/robot/active_frames.h"
#include "cobot_command/robot/robot_watch.h"
#include "cobot_command/script/script_command.h"

namespace cobot_command::robot {

class FrameWatch {
 public:
  /// A command that the controller accepted; commands other than changes of base or TCP have no effect here.
  /// `behind_motion`: the robot may still have to finish other motions before the change.
  void accepted(const script::ScriptCommand& command, bool behind_motion, Instant now);
  void robotChanged(const RobotWatch& robot, Instant now);
  /// The queue was emptied: a queued change will not take effect.
  void stopped();
  /// No commanded value is known to apply: there is a new link, or the project was started again.
  void forget() { base_.reset(), tcp_.reset(); }

  [[nodiscard]] ActiveFrames frames() const;

 private:
  struct Commanded {
    std::optional<arm::Pose> pose;  ///< nullopt: a name in the project, whose pose only the stream has
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
