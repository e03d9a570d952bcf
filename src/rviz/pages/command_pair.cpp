#include "pages/command_pair.h"

#include <utility>

#include "clients/robot.h"
#include "preview/preview.h"
#include "widgets/status_box.h"

namespace cobot_command::rviz_plugin {

void CommandPair::bind(std::unique_ptr<Command> execution, std::unique_ptr<Command> checking,
                       const Robot& robot, Preview& preview) {
  execution_ = std::move(execution);
  checking_ = std::move(checking);
  robot_ = &robot;
  preview_ = &preview;
  shown_ = execution_.get();
  watch(*execution_);
  if (checking_) watch(*checking_);
  showState();
  if (listener_) listener_();
}

void CommandPair::watch(Command& command) {
  command.onChange([this, &command] {
    // One that was forgotten has not ended now.
    const bool ended = !command.isBusy() && command.state().phase != CommandState::Phase::Idle;
    if (&command == execution_.get() && ended) shown_ = &command;
    if (shown_ == &command) showState();
    showInScene(command);
    if (listener_) listener_();
  });
}

void CommandPair::showState() {
  status_.show(shown_->state(), shown_ == checking_.get());
  validity_.begin();
}

void CommandPair::showInScene(const Command& command) {
  if (checking_.get() == &command) {
    if (!command.isBusy()) preview_->show(command.plan());  // of one that was forgotten: nothing
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

void CommandPair::forget() {
  execution_->forget();
  if (checking_) checking_->forget();
}

void CommandPair::look() {
  execution_->look();
  if (checking_) checking_->look();
  const CommandState& state = shown_->state();
  const bool refused = state.phase == CommandState::Phase::Error && state.refused;
  if (refused && validity_.isOver(robot_->situation())) shown_->forget();
}

}  // namespace cobot_command::rviz_plugin
