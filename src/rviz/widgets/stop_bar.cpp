#include "widgets/stop_bar.h"

#include <QGridLayout>
#include <QLabel>
#include <QPushButton>

#include "clients/robot.h"
#include "widgets/status_box.h"

namespace cobot_command::rviz_plugin {
namespace {

constexpr int kHeight = 44;

QPushButton* button(const char* text, const char* name, const char* style) {
  auto* made = new QPushButton(text);
  made->setObjectName(name);
  made->setMinimumHeight(kHeight);
  made->setFocusPolicy(Qt::NoFocus);
  made->setStyleSheet(style);
  return made;
}

}  // namespace

StopBar::StopBar(QWidget* parent) : QWidget(parent), text_(new QLabel) {
  auto* stop =
      button("STOP", "stop", "background: #c0392b; color: white; font-weight: bold; font-size: 14pt;");
  auto* pause = button("Pause", "pause", "");
  auto* resume = button("Resume", "resume", "");
  stop->setToolTip("Stops the robot and empties its queue");
  pause->setToolTip("Holds the robot on its way");
  text_->setObjectName("stop_text");
  text_->setWordWrap(true);
  text_->setVisible(false);
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->addWidget(stop, 0, 0);
  grid->addWidget(pause, 0, 1);
  grid->addWidget(resume, 0, 2);
  grid->addWidget(text_, 1, 0, 1, 3);
  grid->setColumnStretch(0, 2);
  grid->setColumnStretch(1, 1);
  grid->setColumnStretch(2, 1);
  connect(stop, &QPushButton::pressed, this, [this] { robot_->stop(); });
  connect(pause, &QPushButton::clicked, this, [this] { robot_->pause(); });
  connect(resume, &QPushButton::clicked, this, [this] { robot_->resume(); });
}

void StopBar::bind(Robot& robot) {
  robot_ = &robot;
  text_->setVisible(false);
  robot.stopping().onChange([this, &robot] { tell("Stop", robot.stopping()); });
  robot.control().onChange([this, &robot] { tell("Pause, Resume", robot.control()); });
}

void StopBar::tell(const char* what, const Command& command) {
  using Phase = CommandState::Phase;
  const CommandState& state = command.state();
  QString text = QString("%1: ").arg(what);
  if (state.phase == Phase::Busy) text += QString::fromStdString(state.text);
  if (state.phase == Phase::Done) text += "done. " + QString::fromStdString(state.description);
  if (state.phase == Phase::Aborted) text += "taken away. " + QString::fromStdString(state.description);
  if (state.phase == Phase::Error) {
    text += QString("%1 %2 → %3")
                .arg(errorIdText(state.error_id), QString::fromStdString(state.description),
                     QString::fromStdString(state.remedy));
  }
  text_->setText(text);
  text_->setVisible(true);
}

}  // namespace cobot_command::rviz_plugin
