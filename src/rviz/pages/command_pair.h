// What carries out a page's command, and what only plans it: they share the lamps. The execution has them as
// long as it is shown, and takes them when it ends, so that the end of a motion is never missed for a check
// that came after it.
#pragma once

#include <functional>
#include <memory>

#include "clients/command.h"
#include "clients/situation.h"

namespace cobot_command::rviz_plugin {

class Preview;
class Robot;
class StatusBox;

class CommandPair {
 public:
  /// `status` outlives it.
  explicit CommandPair(StatusBox& status) : status_(status) {}

  /// Of another robot. `checking`: nothing: there is nothing to plan.
  void bind(std::unique_ptr<Command> execution, std::unique_ptr<Command> checking, const Robot& robot,
            Preview& preview);
  [[nodiscard]] bool canCheck() const { return checking_ != nullptr; }
  [[nodiscard]] const Command& execution() const { return *execution_; }

  /// Before sending it.
  void showExecution() { shown_ = execution_.get(); }
  void showCheck() { shown_ = checking_.get(); }
  /// `all`: also goals that others have begun.
  void cancel(bool all);
  void withdraw();
  /// What was commanded has become something else: how the last one ended says nothing of it.
  void forget();
  void look();
  void onChange(std::function<void()> listener) { listener_ = std::move(listener); }

 private:
  void watch(Command& command);
  void showState();
  void showInScene(const Command& command);

  StatusBox& status_;
  const Robot* robot_ = nullptr;
  Preview* preview_ = nullptr;
  std::unique_ptr<Command> execution_;
  std::unique_ptr<Command> checking_;
  Command* shown_ = nullptr;
  Validity validity_;  ///< of a refusal that is shown
  std::function<void()> listener_;
};

}  // namespace cobot_command::rviz_plugin
