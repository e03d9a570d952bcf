// A page with the form of one block: presets, "take the current position", Check, Execute, Cancel, and the
// outputs of the block.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "clients/block.h"
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
};

class CommandPage : public Page {
 public:
  explicit CommandPage(const CommandPageSpec& spec);

  void bind(const Workplace& workplace) override;
  void look() override;
  [[nodiscard]] Values saved() const override { return form_.saved(); }
  void restore(const Values& values) override;

 protected:
  [[nodiscard]] const Workplace& workplace() const { return workplace_; }
  [[nodiscard]] Form& form() { return form_; }
  /// Shows what the form has, when it was changed here.
  void refresh();
  /// Somebody has changed the form: by hand, a preset, or by taking where the robot is.
  virtual void edited() {}
  /// Between the form and the buttons.
  void addBelowForm(QWidget* widget);

 private:
  void addPresets(QBoxLayout& layout);
  void addTakings(QBoxLayout& layout, const std::vector<Taking>& takings);
  void addButtons(QBoxLayout& layout, const CommandPageSpec& spec);
  void take(const Taking& taking);
  void watch(Command& command);
  /// Of a check that has ended its plan; of a motion that is done nothing any more.
  void showEnd(const Command& command);

  Form form_;
  std::function<Block(const ros::NodeHandle&)> make_block_;
  Workplace workplace_;
  Block block_;
  Command* shown_ = nullptr;  ///< that was started last: the check, or the execution
  FormView* view_;
  StatusBox* status_;
  QPushButton* check_ = nullptr;
  QWidget* below_form_ = nullptr;
};

}  // namespace cobot_command::rviz_plugin
