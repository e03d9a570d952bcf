// The pick-and-place cycle (6.3.8): its picture, whose moves are edited one by one, and its commands.
#pragma once

#include <array>
#include <functional>

#include "forms/cycle.h"
#include "pages/command_pair.h"
#include "pages/page.h"

class QPushButton;
class QStackedWidget;

namespace cobot_command::rviz_plugin {

class CycleView;
class FormView;
class StatusBox;

class CyclePage : public Page {
 public:
  CyclePage();

  void bind(const Workplace& workplace) override;
  [[nodiscard]] QWidget* footer() override { return footer_; }
  void look() override;
  void withdraw() override { pair_.withdraw(); }
  [[nodiscard]] Values saved() const override;
  void restore(const Values& values) override;

 private:
  void fitHeight();
  QWidget* makeOverview();
  QWidget* makeEditor(std::size_t move);
  QPushButton* addButton(const char* text, const char* name, std::function<void()> action);
  void addCommands();
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
  QPushButton* check_ = nullptr;
  QPushButton* execute_ = nullptr;
  QWidget* footer_;  ///< of the panel, which puts it below the page
  StatusBox* status_;
  CommandPair pair_;
};

}  // namespace cobot_command::rviz_plugin
