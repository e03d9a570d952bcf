// Move Absolute (6.3.6), with the target in RViz: dragged there, the arm at it as a ghost, in each of the
// configurations that reach it.
#pragma once

#include <optional>

#include "pages/command_page.h"

namespace cobot_command::rviz_plugin {

class ElidedLabel;

class MoveAbsolutePage : public CommandPage {
 public:
  MoveAbsolutePage();

  void bind(const Workplace& workplace) override;

 protected:
  void edited() override { showTarget(); }
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;

 private:
  QWidget* makeStepper();
  void showTarget();
  void drag(const Target::Six& target);
  /// To another one of the configurations that reach the target: by 1 or -1.
  void step(int by);
  /// Nothing: it is kept as it is.
  [[nodiscard]] std::optional<Configuration> chosen();

  ElidedLabel* configuration_;
};

}  // namespace cobot_command::rviz_plugin
