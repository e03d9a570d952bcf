#include "displays/arm_display.h"

#include <algorithm>
#include <utility>

#include "displays/link_poses.h"
#include <Eigen/Geometry>
#include <pluginlib/class_list_macros.hpp>
#include <rviz/display_context.h>
#include <rviz/frame_manager.h>
#include <rviz/properties/float_property.h>
#include <rviz/properties/ros_topic_property.h>
#include <rviz/properties/string_property.h>
#include <rviz/robot/link_updater.h>
#include <rviz/robot/robot.h>
#include <urdf_parser/urdf_parser.h>

namespace cobot_command::rviz_plugin {
namespace {

class Poses : public rviz::LinkUpdater {
 public:
  explicit Poses(std::map<std::string, Eigen::Isometry3d> poses) : poses_(std::move(poses)) {}

  bool getLinkTransforms(const std::string& link, Ogre::Vector3& visual_position,
                         Ogre::Quaternion& visual_orientation, Ogre::Vector3& collision_position,
                         Ogre::Quaternion& collision_orientation) const override {
    const auto found = poses_.find(link);
    if (found == poses_.end()) return false;
    const Eigen::Vector3f at = found->second.translation().cast<float>();
    const Eigen::Quaternionf turn = Eigen::Quaterniond(found->second.linear()).cast<float>();
    visual_position = collision_position = Ogre::Vector3(at.x(), at.y(), at.z());
    visual_orientation = collision_orientation = Ogre::Quaternion(turn.w(), turn.x(), turn.y(), turn.z());
    return true;
  }

 private:
  std::map<std::string, Eigen::Isometry3d> poses_;
};

}  // namespace

ArmDisplay::ArmDisplay() : ArmDisplay("joint_states", "Joint angles of the arm", 1) {}

ArmDisplay::ArmDisplay(const char* topic, const char* about, float alpha)
    : topic_(new rviz::RosTopicProperty("Joints", topic, "sensor_msgs/JointState", about, this,
                                        SLOT(subscribe()))),
      description_(new rviz::StringProperty("Robot Description", "robot_description",
                                            "The parameter with the arm's URDF", this, SLOT(loadModel()))),
      alpha_(new rviz::FloatProperty("Alpha", alpha, "0: invisible, 1: opaque", this, SLOT(setAlpha()))) {
  alpha_->setMin(0);
  alpha_->setMax(1);
}

ArmDisplay::~ArmDisplay() = default;

void ArmDisplay::onInitialize() {
  arm_ = std::make_unique<rviz::Robot>(scene_node_, context_, getClassId().toStdString(), this);
  arm_->getLinkTreeProperty()->hide();
  arm_->setVisible(false);
}

void ArmDisplay::onEnable() {
  loadModel();
  subscribe();
}

void ArmDisplay::onDisable() {
  subscriber_.shutdown();
  arm_->setVisible(false);
}

void ArmDisplay::subscribe() {
  subscriber_.shutdown();
  joints_.clear();
  if (!isEnabled() || topic_->getTopic().isEmpty()) return;
  subscriber_ = update_nh_.subscribe<sensor_msgs::JointState>(
      topic_->getTopicStd(), 1, [this](const sensor_msgs::JointState::ConstPtr& joints) { hear(*joints); });
}

void ArmDisplay::loadModel() {
  if (!isEnabled() || !arm_) return;
  std::string text;
  urdf_.reset();
  arm_->clear();
  if (!update_nh_.getParam(description_->getStdString(), text)) {
    setStatus(rviz::StatusProperty::Error, "URDF", "There is no parameter " + description_->getString());
    return;
  }
  urdf_ = urdf::parseURDF(text);
  if (!urdf_) {
    setStatus(rviz::StatusProperty::Error, "URDF",
              "The parameter " + description_->getString() + " is not a URDF");
    return;
  }
  setStatus(rviz::StatusProperty::Ok, "URDF", "Read");
  arm_->load(*urdf_, true, false);
  colorLinks(*arm_);
  setAlpha();
  showIfKnown();
}

void ArmDisplay::colorLinks(rviz::Robot& /*arm*/) {}

void ArmDisplay::setAlpha() {
  if (!arm_) return;
  arm_->setAlpha(alpha_->getFloat());
  context_->queueRender();
}

void ArmDisplay::hear(const sensor_msgs::JointState& joints) {
  joints_.clear();
  for (std::size_t i = 0; i < joints.name.size() && i < joints.position.size(); ++i) {
    joints_[joints.name[i]] = joints.position[i];
  }
  showIfKnown();
}

bool ArmDisplay::knowsJoints() const {
  if (!urdf_) return false;
  return std::any_of(joints_.begin(), joints_.end(),
                     [this](const auto& joint) { return urdf_->joints_.count(joint.first) != 0; });
}

void ArmDisplay::showIfKnown() {
  const bool known = knowsJoints();
  if (known) arm_->update(Poses(linkPoses(*urdf_, joints_)));
  arm_->setVisible(known && findRoot());
  context_->queueRender();
}

bool ArmDisplay::findRoot() {
  Ogre::Vector3 position;
  Ogre::Quaternion orientation;
  const bool found =
      context_->getFrameManager()->getTransform(urdf_->getRoot()->name, ros::Time(), position, orientation);
  setStatus(found ? rviz::StatusProperty::Ok : rviz::StatusProperty::Warn, "Base",
            found ? "Known" : "tf has no transform to the base of the arm");
  if (!found) return false;
  arm_->setPosition(position);
  arm_->setOrientation(orientation);
  return true;
}

void ArmDisplay::update(float /*wall_dt*/, float /*ros_dt*/) {
  if (knowsJoints()) arm_->setVisible(findRoot());
}

void ArmDisplay::reset() {
  Display::reset();
  loadModel();
}

}  // namespace cobot_command::rviz_plugin

PLUGINLIB_EXPORT_CLASS(cobot_command::rviz_plugin::ArmDisplay, rviz::Display)
