// The pick-and-place cycle (6.3.8): its picture, whose moves are edited one by one, and its commands.
#pragma once

#include <array>
#include <memory>

#include "clients/action_command.h"
#include "forms/cycle.h"
#include "pages/page.h"
#include <cobot_command/PickAndPlaceAction.h>

class QBoxLayout;
class QStackedWidget;

namespace cobot_command::rviz_plugin {

class CycleView;
class FormView;
class StatusBox;

class CyclePage : public Page {
 public:
  CyclePage();

  void bind(const Workplace& workplace) override;
  void look() override;
  [[nodiscard]] Values saved() const override;
  void restore(const Values& values) override;

 private:
  using PickAndPlace = ActionCommand<cobot_command::PickAndPlaceAction>;

  void fitHeight();
  QWidget* makeOverview();
  QWidget* makeEditor(std::size_t move);
  void addButtons(QBoxLayout& layout);
  void start(PickAndPlace& command, bool check_only);
  void watch(PickAndPlace& command);
  void refresh();

  Cycle cycle_;
  Workplace workplace_;
  std::unique_ptr<PickAndPlace> execution_;
  std::unique_ptr<PickAndPlace> checking_;
  PickAndPlace* shown_ = nullptr;  ///< that was started last
  QStackedWidget* views_;          ///< the overview, then an editor for each move
  CycleView* picture_ = nullptr;
  FormView* general_ = nullptr;
  std::array<FormView*, Cycle::kMoves> editors_{};
  StatusBox* status_;
};

}  // namespace cobot_command::rviz_plugin
