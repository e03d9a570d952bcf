// A page with the form of one block: presets, "take the current position", Check, Execute, Cancel, and the
// outputs of the block.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "clients/block.h"
#include "pages/command_pair.h"
#include "pages/page.h"

class QBoxLayout;
class QPushButton;

namespace cobot_command::rviz_plugin {

class FormView;
class StatusBox;

/// A button that puts where the robot is into six fields of the form.
struct Taking {
  const char* label;
  std::string tool;    ///< the prefix that gets the active TCP in the active base
  std::string joints;  ///< the prefix that gets the joints; empty: none does
};

struct CommandPageSpec {
  const char* name;
  QString title;
  std::function<Form()> form;
  std::function<Block(const ros::NodeHandle&)> block;
  std::vector<Taking> takings;
  QString execute = "Execute";
  QString cancel = "Cancel";
  bool cancels_all = false;  ///< also what another client has begun
  bool moves = false;        ///< what it commands needs a robot that is connected
};

class CommandPage : public Page {
 public:
  explicit CommandPage(const CommandPageSpec& spec);

  void bind(const Workplace& workplace) override;
  [[nodiscard]] QWidget* footer() override { return footer_; }
  void look() override;
  void withdraw() override { pair_.withdraw(); }
  [[nodiscard]] Values saved() const override { return form_.saved(); }
  void restore(const Values& values) override;

 protected:
  [[nodiscard]] const Workplace& workplace() const { return workplace_; }
  [[nodiscard]] Form& form() { return form_; }
  /// Shows what the form has, when it was changed here.
  void refresh();
  /// The form has become another one: how the last command ended says nothing of it.
  void changed();
  /// Somebody has changed the form: by hand, a preset, or by taking where the robot is.
  virtual void edited() {}
  /// What does not move when fields come and go.
  void addAboveForm(QWidget* widget);
  /// Between the form and the buttons.
  void addBelowForm(QWidget* widget);

 private:
  void addPresets(QBoxLayout& layout);
  void addTakings(QBoxLayout& layout, const std::vector<Taking>& takings);
  void addButtons(QBoxLayout& layout, const CommandPageSpec& spec);
  void take(const Taking& taking);
  /// Execute would be refused while this block is busy, unless its goals wait or take over; and a move before
  /// there is a link.
  void enableExecute();

  Form form_;
  std::function<Block(const ros::NodeHandle&)> make_block_;
  Workplace workplace_;
  std::function<void(const Form&)> execute_;
  std::function<void(const Form&)> check_;
  bool moves_;
  FormView* view_;
  QWidget* footer_;  ///< of the panel, which puts it below the page
  StatusBox* status_;
  CommandPair pair_;
  QPushButton* check_button_ = nullptr;
  QPushButton* execute_button_ = nullptr;
  QWidget* above_form_;
  QWidget* below_form_;
};

}  // namespace cobot_command::rviz_plugin
