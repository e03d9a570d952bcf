// Moves the arm by hand: as long as a button is held, or in steps. The watchdog is in the command node: what
// is published while the button is held keeps the arm moving, and nothing else does.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "clients/action_command.h"
#include "clients/keep_alive.h"
#include "forms/form.h"
#include "pages/page.h"
#include <cobot_command/JogAction.h>

class QGridLayout;
class QLabel;
class QPushButton;
class QTimer;

namespace cobot_command::rviz_plugin {

class FormView;
class StatusBox;

class JogPage : public Page {
 public:
  JogPage();

  void bind(const Workplace& workplace) override;
  [[nodiscard]] QWidget* footer() override { return footer_; }
  void look() override;
  void withdraw() override { release(); }
  [[nodiscard]] Values saved() const override { return form_.saved(); }
  void restore(const Values& values) override;

 protected:
  /// A button that is out of sight is not held any more.
  void hideEvent(QHideEvent* event) override;
  bool eventFilter(QObject* object, QEvent* event) override;

 private:
  static constexpr int kAxes = 6;

  void addAxis(QGridLayout& grid, int axis);
  QPushButton* makeButton(int axis, int direction);
  void press(int axis, int direction);
  void release();
  /// Sends what is pressed, once the arm has come to rest from before: a keep-alive names no jog, and would
  /// keep that one going.
  void begin();
  void tick();
  void follow();
  void showWhere();
  /// Only where there is a link.
  void enableButtons();

  struct Pressed {
    int axis;
    int direction;
  };

  Form form_;
  std::optional<Pressed> pressed_;  ///< and not sent yet
  Workplace workplace_;
  std::unique_ptr<ActionCommand<cobot_command::JogAction>> jog_;
  std::unique_ptr<KeepAlive> keep_alive_;
  Validity validity_;  ///< of a refusal that is shown
  FormView* view_;
  QWidget* footer_;  ///< of the panel, which puts it below the page
  StatusBox* status_;
  QTimer* holding_;  ///< ticks while a button is held: the user interface lives
  std::vector<QPushButton*> buttons_;
  std::array<QLabel*, kAxes> names_{};
  std::array<QLabel*, kAxes> values_{};
};

}  // namespace cobot_command::rviz_plugin
