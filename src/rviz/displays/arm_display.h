// The arm where its joints say, by a topic: nothing of it is shown before they are known, and tf has to know
// its base alone.
#pragma once

#include <map>
#include <memory>
#include <string>

#include <ros/subscriber.h>
#include <rviz/display.h>
#include <sensor_msgs/JointState.h>
#include <urdf_world/types.h>

namespace rviz {
class FloatProperty;
class Robot;
class RosTopicProperty;
class StringProperty;
}  // namespace rviz

namespace cobot_command::rviz_plugin {

/// Shows joints [rad] until a message comes that has none. Joints of other arms are not for this one.
class ArmDisplay : public rviz::Display {
  Q_OBJECT
 public:
  ArmDisplay();
  ~ArmDisplay() override;

  void update(float wall_dt, float ros_dt) override;
  void reset() override;

 protected:
  /// `topic`: that is heard when nobody chooses another one.
  ArmDisplay(const char* topic, const char* about, float alpha);

  void onInitialize() override;
  void onEnable() override;
  void onDisable() override;
  /// Of a model that was just read.
  virtual void colorLinks(rviz::Robot& arm);
  [[nodiscard]] rviz::Robot* arm() { return arm_.get(); }

  rviz::RosTopicProperty* topic_;

 private Q_SLOTS:
  void subscribe();
  void loadModel();
  void setAlpha();

 private:
  void hear(const sensor_msgs::JointState& joints);
  /// Joints and base are known.
  void showIfKnown();
  [[nodiscard]] bool knowsJoints() const;
  /// Where its root is in the frame that RViz shows; false: tf does not know.
  bool findRoot();

  rviz::StringProperty* description_;
  rviz::FloatProperty* alpha_;
  std::unique_ptr<rviz::Robot> arm_;
  urdf::ModelInterfaceSharedPtr urdf_;
  std::map<std::string, double> joints_;
  ros::Subscriber subscriber_;
};

}  // namespace cobot_command::rviz_plugin
