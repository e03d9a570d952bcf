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

QLabel* line(const char* name) {
  auto* made = new QLabel;
  made->setObjectName(name);
  made->setSizePolicy(QSizePolicy::Ignored,
                      QSizePolicy::Fixed);  // as long as it is: all of it is in the tooltip
  return made;
}

}  // namespace

StopBar::StopBar(QWidget* parent)
    : QWidget(parent),
      stop_(button("STOP", "stop", "background: #c0392b; color: white; font-weight: bold; font-size: 14pt;")),
      stop_text_(line("stop_text")),
      control_text_(line("control_text")) {
  auto* pause = button("Pause", "pause", "");
  auto* resume = button("Resume", "resume", "");
  stop_->setToolTip("Stops the robot and empties its queue");
  pause->setToolTip("Holds the robot on its way");
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->addWidget(stop_, 0, 0);
  grid->addWidget(pause, 0, 1);
  grid->addWidget(resume, 0, 2);
  grid->addWidget(stop_text_, 1, 0, 1, 3);
  grid->addWidget(control_text_, 2, 0, 1, 3);
  for (QLabel* text : {stop_text_, control_text_}) text->setFixedHeight(text->fontMetrics().height() + 2);
  grid->setColumnStretch(0, 2);
  grid->setColumnStretch(1, 1);
  grid->setColumnStretch(2, 1);
  connect(stop_, &QPushButton::pressed, this, [this] { stop(); });
  connect(pause, &QPushButton::clicked, this, [this] { robot_->pause(); });
  connect(resume, &QPushButton::clicked, this, [this] { robot_->resume(); });
}

void StopBar::stop() {
  if (stop_listener_) stop_listener_();
  robot_->control().withdraw();
  robot_->stop();
}

void StopBar::bind(Robot& robot, const QString& name) {
  robot_ = &robot;
  stop_->setText(name == "/" ? QString("STOP") : "STOP " + name);
  stop_text_->clear();
  control_text_->clear();
  robot.stopping().onChange([this, &robot] { tell(*stop_text_, "Stop", robot.stopping()); });
  robot.control().onChange([this, &robot] { tell(*control_text_, "Pause, Resume", robot.control()); });
}

void StopBar::tell(QLabel& text, const QString& what, const Command& command) {
  using Phase = CommandState::Phase;
  const CommandState& state = command.state();
  const bool failed = state.unanswered || state.phase == Phase::Error;
  QString words;
  if (state.phase == Phase::Busy) words = QString::fromStdString(state.text);
  if (state.unanswered) words += ". Use the emergency stop.";
  if (state.phase == Phase::Done) words = "done. " + QString::fromStdString(state.description);
  if (state.phase == Phase::Aborted) words = "taken away. " + QString::fromStdString(state.description);
  if (state.phase == Phase::Error) {
    words = QString("%1 %2 → %3")
                .arg(errorIdText(state.error_id), QString::fromStdString(state.description),
                     QString::fromStdString(state.remedy));
  }
  text.setText(state.phase == Phase::Idle ? QString() : what + ": " + words);
  text.setToolTip(text.text());
  text.setStyleSheet(failed ? "color: #c0392b; font-weight: bold;" : "");
}

}  // namespace cobot_command::rviz_plugin
