// The pick-and-place cycle (6.3.8): its picture, whose moves are edited one by one, and its commands.
#pragma once

#include <array>
#include <functional>

#include "forms/cycle.h"
#include "pages/command_pair.h"
#include "pages/page.h"
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
  void look() override { pair_.look(); }
  void withdraw() override { pair_.withdraw(); }
  [[nodiscard]] Values saved() const override;
  void restore(const Values& values) override;

 private:
  void fitHeight();
  QWidget* makeOverview();
  QWidget* makeEditor(std::size_t move);
  void addButtons(QBoxLayout& layout);
  /// Takes what was typed and not confirmed.
  void commit();
  void changed();
  void refresh();

  Cycle cycle_;
  Workplace workplace_;
  std::function<void(bool check_only)> send_;
  QStackedWidget* views_;  ///< the overview, then an editor for each move
  CycleView* picture_ = nullptr;
  FormView* general_ = nullptr;
  std::array<FormView*, Cycle::kMoves> editors_{};
  StatusBox* status_;
  CommandPair pair_;
};

}  // namespace cobot_command::rviz_plugin
