#include "pages/command_pair.h"

#include <utility>

#include "preview/preview.h"
#include "widgets/status_box.h"

namespace cobot_command::rviz_plugin {

void CommandPair::bind(std::unique_ptr<Command> execution, std::unique_ptr<Command> checking,
                       Preview& preview) {
  execution_ = std::move(execution);
  checking_ = std::move(checking);
  preview_ = &preview;
  shown_ = execution_.get();
  watch(*execution_);
  if (checking_) watch(*checking_);
  status_.show(shown_->state());
  if (listener_) listener_();
}

void CommandPair::watch(Command& command) {
  command.onChange([this, &command] {
    if (&command == execution_.get() && !command.isBusy()) shown_ = &command;
    if (shown_ == &command) status_.show(command.state());
    showInScene(command);
    if (listener_) listener_();
  });
}

void CommandPair::showInScene(const Command& command) {
  if (checking_.get() == &command) {
    if (!command.isBusy()) preview_->show(command.plan());
  } else if (command.state().phase == CommandState::Phase::Done) {
    preview_->hide();
  }
}

void CommandPair::cancel(bool all) {
  if (all) {
    execution_->cancelAll();
  } else {
    execution_->cancel();
  }
  if (checking_) checking_->cancel();
}

void CommandPair::withdraw() {
  execution_->withdraw();
  if (checking_) checking_->withdraw();
}

void CommandPair::look() {
  execution_->look();
  if (checking_) checking_->look();
}

}  // namespace cobot_command::rviz_plugin
