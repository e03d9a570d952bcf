#include "cobot_command/ros/tf_frames.h"

#include <tf2/exceptions.h>

#include "cobot_command/ros/conversions.h"

namespace cobot_command::ros_adapter {

FramePlace TfFrames::find(const std_msgs::Header& header) const {
  try {
    return {toPose(buffer_.lookupTransform(robot_base_, header.frame_id, header.stamp).transform), ""};
  } catch (const tf2::TransformException& fault) {
    return {std::nullopt, fault.what()};
  }
}

}  // namespace cobot_command::ros_adapter
