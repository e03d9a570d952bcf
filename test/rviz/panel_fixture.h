// What the tests of the panel begin with: RViz with a robot that is ready, and an operator in front of it.
#pragma once

#include <QStringList>

#include "operator.h"
#include "rviz_window.h"
#include <gtest/gtest.h>

namespace cobot_command::test {

class Panel : public ::testing::Test {
 public:
  static RvizWindow* window;  ///< of the program, which has one

 protected:
  Panel();
  ~Panel() override;

  [[nodiscard]] bool isReady() const { return at_panel.link().startsWith("ready"); }
  /// So that each test begins there, whatever was before.
  void moveToPreset();
  /// Along y [mm], and returns while it moves; on the page Move Relative.
  void moveSlowly(double way);
  /// Of J1, on the page that jogs.
  [[nodiscard]] double jointValue() const { return at_panel.textOf("value_0").split(' ').front().toDouble(); }

  Operator at_panel;
};

}  // namespace cobot_command::test
