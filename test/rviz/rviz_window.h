// RViz itself in this process, with the configuration of bringup.launch.
#pragma once

#include <functional>
#include <memory>
#include <string>

class QApplication;
class QWidget;

namespace rviz {
class VisualizationFrame;
class VisualizerApp;
}  // namespace rviz

namespace cobot_command::test {

class RvizWindow {
 public:
  /// As from the command line: -d FILE, -f FRAME. Waits until it is there, with its panel where it is to have
  /// one.
  RvizWindow(int argc, char** argv, bool has_panel = true);
  RvizWindow(const RvizWindow&) = delete;
  RvizWindow& operator=(const RvizWindow&) = delete;
  ~RvizWindow();

  [[nodiscard]] QWidget& panel() const { return *panel_; }
  [[nodiscard]] QWidget& frame() const;
  [[nodiscard]] rviz::VisualizationFrame& rviz() const { return *frame_; }

 private:
  int argc_;
  std::unique_ptr<QApplication> application_;
  std::unique_ptr<rviz::VisualizerApp> rviz_;
  rviz::VisualizationFrame* frame_ = nullptr;
  QWidget* panel_ = nullptr;
};

/// Of this RViz, as its panels name them: "preview" → "/rviz/preview".
[[nodiscard]] std::string ownTopic(const std::string& name);

/// Serves the user interface, and through it ROS, until it holds; false: it does not within so many seconds.
[[nodiscard]] bool holdsSoon(const std::function<bool()>& condition, double seconds = 20);

}  // namespace cobot_command::test
