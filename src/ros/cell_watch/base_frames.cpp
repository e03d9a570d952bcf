#include "cell_watch/base_frames.h"

#include "cell_watch/pictures/marker_parts.h"
#include <geometry_msgs/TransformStamped.h>
#include <ros/console.h>

#include "cobot_command/common/foreign_text.h"
#include "cobot_command/ros/shared/conversions.h"

namespace cobot_command::ros_adapter {

void BaseFrames::tell(std::size_t robot, const std::string& prefix) {
  const cell::Robot& known = robots_[robot];
  const std::string frame = prefix + "base";
  if (!told_.insert(frame).second) {
    ROS_WARN_STREAM("the base frame of " << forPeople(known.name) << " is " << forPeople(frame)
                                         << ", the same as for another robot: its transform is not "
                                            "published. Give each robot its own prefix.");
    return;
  }
  geometry_msgs::TransformStamped transform;
  transform.header.stamp = ros::Time::now();
  transform.header.frame_id = kWorldFrame;
  transform.child_frame_id = frame;
  transform.transform = toTransform(known.base);
  broadcaster_.sendTransform(transform);
}

}  // namespace cobot_command::ros_adapter
