#include "displays/ghost_display.h"

#include <utility>

#include "displays/link_poses.h"
#include <Eigen/Geometry>
#include <pluginlib/class_list_macros.hpp>
#include <rviz/display_context.h>
#include <rviz/frame_manager.h>
#include <rviz/properties/color_property.h>
#include <rviz/properties/float_property.h>
#include <rviz/properties/ros_topic_property.h>
#include <rviz/properties/string_property.h>
#include <rviz/robot/link_updater.h>
#include <rviz/robot/robot.h>
#include <rviz/robot/robot_link.h>
#include <urdf_parser/urdf_parser.h>

namespace cobot_command::rviz_plugin {
namespace {

constexpr float kAlpha = 0.4F;
const QColor kBlue(47, 111, 181);

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

GhostDisplay::GhostDisplay()
    : topic_(new rviz::RosTopicProperty("Joints", "preview_joints", "sensor_msgs/JointState",
                                        "Where the arm is shown; a message without joints hides it", this,
                                        SLOT(subscribe()))),
      description_(new rviz::StringProperty("Robot Description", "robot_description",
                                            "The parameter with the arm's URDF", this, SLOT(load()))),
      color_(new rviz::ColorProperty("Color", kBlue, "Of all its links", this, SLOT(paint()))),
      alpha_(new rviz::FloatProperty("Alpha", kAlpha, "0: cannot be seen, 1: as a real one", this,
                                     SLOT(paint()))) {
  alpha_->setMin(0);
  alpha_->setMax(1);
}

GhostDisplay::~GhostDisplay() = default;

void GhostDisplay::onInitialize() {
  arm_ = std::make_unique<rviz::Robot>(scene_node_, context_, "Ghost", this);
  arm_->getLinkTreeProperty()->hide();
  arm_->setVisible(false);
}

void GhostDisplay::onEnable() {
  load();
  subscribe();
}

void GhostDisplay::onDisable() {
  subscriber_.shutdown();
  arm_->setVisible(false);
}

void GhostDisplay::subscribe() {
  subscriber_.shutdown();
  if (!isEnabled() || topic_->getTopic().isEmpty()) return;
  subscriber_ = update_nh_.subscribe<sensor_msgs::JointState>(
      topic_->getTopicStd(), 1, [this](const sensor_msgs::JointState::ConstPtr& joints) { hear(*joints); });
}

void GhostDisplay::load() {
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
              "The parameter " + description_->getString() + " is no URDF");
    return;
  }
  setStatus(rviz::StatusProperty::Ok, "URDF", "Read");
  arm_->load(*urdf_, true, false);
  paint();
  place();
}

void GhostDisplay::paint() {
  if (!arm_) return;
  const QColor color = color_->getColor();
  for (const auto& [name, link] : arm_->getLinks()) {
    link->setColor(static_cast<float>(color.redF()), static_cast<float>(color.greenF()),
                   static_cast<float>(color.blueF()));
  }
  arm_->setAlpha(alpha_->getFloat());
  context_->queueRender();
}

void GhostDisplay::hear(const sensor_msgs::JointState& joints) {
  joints_.clear();
  for (std::size_t i = 0; i < joints.name.size() && i < joints.position.size(); ++i) {
    joints_[joints.name[i]] = joints.position[i];
  }
  place();
}

void GhostDisplay::place() {
  const bool shown = urdf_ && !joints_.empty();
  arm_->setVisible(shown);
  if (shown) arm_->update(Poses(linkPoses(*urdf_, joints_)));
  context_->queueRender();
}

bool GhostDisplay::findRoot() {
  Ogre::Vector3 position;
  Ogre::Quaternion orientation;
  if (!urdf_ || !context_->getFrameManager()->getTransform(urdf_->getRoot()->name, ros::Time(), position,
                                                           orientation)) {
    return false;
  }
  arm_->setPosition(position);
  arm_->setOrientation(orientation);
  return true;
}

void GhostDisplay::update(float /*wall_dt*/, float /*ros_dt*/) {
  if (joints_.empty()) return;
  const bool found = findRoot();
  setStatus(found ? rviz::StatusProperty::Ok : rviz::StatusProperty::Warn, "Base",
            found ? "Known" : "tf does not know where the base of the arm is");
}

void GhostDisplay::fixedFrameChanged() {
  findRoot();
}

void GhostDisplay::reset() {
  Display::reset();
  load();
}

}  // namespace cobot_command::rviz_plugin

PLUGINLIB_EXPORT_CLASS(cobot_command::rviz_plugin::GhostDisplay, rviz::Display)
