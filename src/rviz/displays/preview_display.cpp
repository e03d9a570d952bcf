#include "displays/preview_display.h"

#include <array>

#include "own_topics.h"
#include <pluginlib/class_list_macros.hpp>

namespace cobot_command::rviz_plugin {
namespace {

struct Part {
  const char* display;
  const char* name;
  const char* topic;
  const char* ending;  ///< of the topic that is subscribed
  const char* type;
};

constexpr std::array<Part, 3> kParts{
    {{"rviz/InteractiveMarkers", "Draggable target", kPreviewTarget, "/update",
      "visualization_msgs/InteractiveMarkerUpdate"},
     {"rviz/MarkerArray", "Infeasible points, frame names", kPreviewMarkers, "",
      "visualization_msgs/MarkerArray"},
     {"rviz/Marker", "Driven path", kDrivenPath, "", "visualization_msgs/Marker"}}};

}  // namespace

void PreviewDisplay::onInitialize() {
  DisplayGroup::onInitialize();
  for (const Part& part : kParts) {
    rviz::Display* display = createDisplay(part.display);
    addDisplay(display);
    display->initialize(context_);
    display->setName(part.name);
    display->setEnabled(true);
  }
  listenToOwn();
}

void PreviewDisplay::listenToOwn() {
  for (int i = 0; i < numDisplays(); ++i) {
    const Part& part = kParts.at(static_cast<std::size_t>(i));
    getDisplayAt(i)->setTopic(QString::fromStdString(ownTopic(part.topic)) + part.ending, part.type);
  }
}

// Not those of a group, which would make its displays anew.
void PreviewDisplay::load(const rviz::Config& config) {
  Display::load(config);
  listenToOwn();
}

void PreviewDisplay::save(rviz::Config config) const {
  Display::save(config);
}

}  // namespace cobot_command::rviz_plugin

PLUGINLIB_EXPORT_CLASS(cobot_command::rviz_plugin::PreviewDisplay, rviz::Display)
