// The arm a second time, transparent, where it would stand: joints come on a topic, and nothing of it is in
// tf.
#pragma once

#include <map>
#include <memory>
#include <string>

#include <ros/subscriber.h>
#include <rviz/display.h>
#include <sensor_msgs/JointState.h>
#include <urdf_world/types.h>

namespace rviz {
class ColorProperty;
class FloatProperty;
class Robot;
class RosTopicProperty;
class StringProperty;
}  // namespace rviz

namespace cobot_command::rviz_plugin {

/// Shows joints [rad] until a message comes that has none.
class GhostDisplay : public rviz::Display {
  Q_OBJECT
 public:
  GhostDisplay();
  ~GhostDisplay() override;

  void update(float wall_dt, float ros_dt) override;
  void reset() override;

 private Q_SLOTS:
  void subscribe();
  void load();
  void paint();

 protected:
  void onInitialize() override;
  void onEnable() override;
  void onDisable() override;
  void fixedFrameChanged() override;

 private:
  void hear(const sensor_msgs::JointState& joints);
  void place();
  /// Where its root is in the frame that RViz shows; false: tf does not know.
  bool findRoot();

  rviz::RosTopicProperty* topic_;
  rviz::StringProperty* description_;
  rviz::ColorProperty* color_;
  rviz::FloatProperty* alpha_;
  std::unique_ptr<rviz::Robot> arm_;
  urdf::ModelInterfaceSharedPtr urdf_;
  std::map<std::string, double> joints_;
  ros::Subscriber subscriber_;
};

}  // namespace cobot_command::rviz_plugin
