// What the panel of this RViz shows in the scene besides the ghost of the arm: the target that can be
// dragged, what cannot be and why, the path that was driven. Each is a display of RViz, on the topics of this
// RViz and no other.
#pragma once

#include <rviz/display_group.h>

namespace cobot_command::rviz_plugin {

class PreviewDisplay : public rviz::DisplayGroup {
  Q_OBJECT
 public:
  void load(const rviz::Config& config) override;
  void save(rviz::Config config) const override;

 protected:
  void onInitialize() override;

 private:
  /// Whatever topics a configuration has: they are of the RViz that has saved it.
  void listenToOwn();
};

}  // namespace cobot_command::rviz_plugin
