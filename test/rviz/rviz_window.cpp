#include "rviz_window.h"

#include <QApplication>
#include <QElapsedTimer>
#include <QTest>
#include <stdexcept>

#include <ros/this_node.h>
#include <rviz/visualization_frame.h>
#include <rviz/visualizer_app.h>

namespace cobot_command::test {

bool holdsSoon(const std::function<bool()>& condition, double seconds) {
  QElapsedTimer since;
  since.start();
  while (!condition()) {
    if (static_cast<double>(since.elapsed()) > 1000 * seconds) return false;
    QTest::qWait(10);
  }
  return true;
}

std::string ownTopic(const std::string& name) {
  return ros::this_node::getName() + "/" + name;
}

RvizWindow::RvizWindow(int argc, char** argv, bool has_panel)
    : argc_(argc),
      application_(std::make_unique<QApplication>(argc_, argv)),
      rviz_(std::make_unique<rviz::VisualizerApp>()) {
// Needed by the RViz of Debian 12, deprecated in that of Debian 13.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wdeprecated-declarations"
  rviz_->setApp(application_.get());
#pragma GCC diagnostic pop
  if (!rviz_->init(argc, argv)) throw std::runtime_error("RViz does not start");
  const bool there = holdsSoon([this, has_panel] {
    for (QWidget* window : QApplication::topLevelWidgets()) {
      auto* frame = qobject_cast<rviz::VisualizationFrame*>(window);
      if (frame == nullptr) continue;
      frame_ = frame;
      panel_ = window->findChild<QWidget*>("cobot_panel");
    }
    return panel_ != nullptr || (frame_ != nullptr && !has_panel);
  });
  if (!there) throw std::runtime_error("RViz has no panel named Cobot: is its library found?");
}

QWidget& RvizWindow::frame() const {
  return *frame_;
}

RvizWindow::~RvizWindow() {
  // RViz asks whether a changed configuration is to be saved, and would wait for an answer.
  if (frame_ != nullptr) frame_->setWindowModified(false);
}

}  // namespace cobot_command::test
