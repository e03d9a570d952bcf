// The arm a second time, transparent, where it would stand, as the panel of this RViz says.
#pragma once

#include "displays/arm_display.h"

namespace rviz {
class ColorProperty;
}  // namespace rviz

namespace cobot_command::rviz_plugin {

class GhostDisplay : public ArmDisplay {
  Q_OBJECT
 public:
  GhostDisplay();

  void load(const rviz::Config& config) override;

 private Q_SLOTS:
  void repaint();

 protected:
  void onInitialize() override;
  void colorLinks(rviz::Robot& arm) override;

 private:
  void listenToOwn();

  rviz::ColorProperty* color_;
};

}  // namespace cobot_command::rviz_plugin
