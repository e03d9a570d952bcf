#include "displays/ghost_display.h"

#include "own_topics.h"
#include <pluginlib/class_list_macros.hpp>
#include <rviz/display_context.h>
#include <rviz/properties/color_property.h>
#include <rviz/properties/ros_topic_property.h>
#include <rviz/robot/robot.h>
#include <rviz/robot/robot_link.h>

namespace cobot_command::rviz_plugin {
namespace {

constexpr float kAlpha = 0.4F;
const QColor kBlue(47, 111, 181);

}  // namespace

GhostDisplay::GhostDisplay()
    : ArmDisplay(kPreviewJoints, "Planned position of the arm; a message without joints hides it", kAlpha),
      color_(new rviz::ColorProperty("Color", kBlue, "Color of all links", this, SLOT(repaint()))) {}

void GhostDisplay::onInitialize() {
  ArmDisplay::onInitialize();
  listenToOwn();
}

void GhostDisplay::load(const rviz::Config& config) {
  ArmDisplay::load(config);
  listenToOwn();
}

void GhostDisplay::listenToOwn() {
  topic_->setString(QString::fromStdString(ownTopic(kPreviewJoints)));
  topic_->hide();
}

void GhostDisplay::colorLinks(rviz::Robot& arm) {
  const QColor color = color_->getColor();
  for (const auto& [name, link] : arm.getLinks()) {
    link->setColor(static_cast<float>(color.redF()), static_cast<float>(color.greenF()),
                   static_cast<float>(color.blueF()));
  }
}

void GhostDisplay::repaint() {
  if (arm() == nullptr) return;
  colorLinks(*arm());
  context_->queueRender();
}

}  // namespace cobot_command::rviz_plugin

PLUGINLIB_EXPORT_CLASS(cobot_command::rviz_plugin::GhostDisplay, rviz::Display)
