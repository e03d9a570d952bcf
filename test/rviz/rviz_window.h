// RViz itself in this process, with the configuration of bringup.launch.
#pragma once

#include <functional>
#include <memory>
#include <string>

class QApplication;
class QWidget;

namespace rviz {
class VisualizerApp;
}

namespace cobot_command::test {

class RvizWindow {
 public:
  /// As from the command line: -d FILE, -f FRAME. Waits until the panel is there.
  RvizWindow(int argc, char** argv);
  RvizWindow(const RvizWindow&) = delete;
  RvizWindow& operator=(const RvizWindow&) = delete;
  ~RvizWindow();

  [[nodiscard]] QWidget& panel() const { return *panel_; }
  [[nodiscard]] QWidget& frame() const { return *frame_; }

 private:
  int argc_;
  std::unique_ptr<QApplication> application_;
  std::unique_ptr<rviz::VisualizerApp> rviz_;
  QWidget* frame_ = nullptr;
  QWidget* panel_ = nullptr;
};

/// Serves the user interface, and through it ROS, until it holds; false: it does not within so many seconds.
[[nodiscard]] bool holdsSoon(const std::function<bool()>& condition, double seconds = 20);

}  // namespace cobot_command::test
