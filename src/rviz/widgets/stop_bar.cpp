#include "widgets/stop_bar.h"

#include <QGridLayout>

#include "clients/fleet.h"
#include "clients/robot.h"
#include "widgets/elided.h"
#include "widgets/status_box.h"

namespace cobot_command::rviz_plugin {
namespace {

constexpr int kHeight = 44;
constexpr int kStopLines = 3;     // who has not stopped, and what to do, has to fit
constexpr int kLooksAtDone = 50;  // so long it is said that something was done
constexpr const char* kRed = "background: #c0392b; color: white; font-weight: bold; font-size: %1pt;";

template <class Button>
Button* button(const char* text, const char* name, const QString& style) {
  auto* made = new Button(text);
  made->setObjectName(name);
  made->setMinimumHeight(kHeight);
  made->setFocusPolicy(Qt::NoFocus);
  made->setStyleSheet(style);
  return made;
}

}  // namespace

StopBar::StopBar(Fleet& fleet, QWidget* parent)
    : QWidget(parent),
      fleet_(fleet),
      stop_(button<ElidedButton>("STOP", "stop", QString(kRed).arg(14))),
      stop_all_(button<QPushButton>("STOP ALL", "stop_all", QString(kRed).arg(10))),
      stop_line_{new ElidedLabel("stop_text", kStopLines)},
      control_line_{new ElidedLabel("control_text")} {
  auto* pause = button<QPushButton>("Pause", "pause", "");
  auto* resume = button<QPushButton>("Resume", "resume", "");
  stop_->setToolTip("Stops the robot and empties its queue");
  stop_all_->setToolTip("Stops every robot in the list and empties their queues");
  pause->setToolTip("Pauses the robot on its path");
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(0, 0, 0, 0);
  int column = 0;
  for (QPushButton* made : std::initializer_list<QPushButton*>{stop_, stop_all_, pause, resume}) {
    grid->addWidget(made, 0, column);
    grid->setColumnStretch(column, column == 0 ? 2 : 1);
    ++column;
  }
  grid->addWidget(stop_line_.label, 1, 0, 1, column);
  grid->addWidget(control_line_.label, 2, 0, 1, column);
  stop_all_->hide();
  connect(stop_, &QPushButton::pressed, this, [this] { stop(); });
  connect(stop_all_, &QPushButton::pressed, this, [this] { stopAll(); });
  connect(pause, &QPushButton::clicked, this, [this] { control(true); });
  connect(resume, &QPushButton::clicked, this, [this] { control(false); });
}

void StopBar::stop() {
  if (stop_listener_) stop_listener_();
  robot_->control().withdraw();
  leaveFleet();
  robot_->stop();
}

void StopBar::stopAll() {
  if (stop_listener_) stop_listener_();
  robot_->control().withdraw();
  fleet_.stop();
  fleet_looks_ = 1;
  lookAtFleet();
}

void StopBar::control(bool pauses) {
  pauses_ = pauses;
  if (pauses) {
    robot_->pause();
  } else {
    robot_->resume();
  }
}

void StopBar::bind(Robot& robot, const QString& name) {
  robot_ = &robot;
  if (!fleet_.isBusy()) leaveFleet();
  stop_->setText(name == "/" ? QString("STOP") : "STOP " + name);
  stop_->setToolTip("Stops " + name + " and empties its queue");
  for (Line* line : {&stop_line_, &control_line_}) write(*line, "", false);
  robot.stopping().onChange(
      [this, &robot] { tell(stop_line_, "Stop", "the robot is at standstill", robot.stopping()); });
  robot.control().onChange([this, &robot] {
    tell(control_line_, pauses_ ? "Pause" : "Resume", pauses_ ? "the robot is paused" : "the robot continues",
         robot.control());
  });
}

void StopBar::tell(Line& line, const QString& what, const QString& done, const Command& command) {
  using Phase = CommandState::Phase;
  const CommandState& state = command.state();
  const QString found = QString::fromStdString(state.description);
  QString words;
  if (state.phase == Phase::Busy) words = QString::fromStdString(state.text);
  if (state.unanswered) words.prepend("Use the emergency stop: ");
  if (state.phase == Phase::Done) words = found.isEmpty() ? done : found;
  if (state.phase == Phase::Aborted) words = found.isEmpty() ? QString("aborted") : "aborted: " + found;
  if (state.phase == Phase::Error) {
    const QString id = state.error_id == 0 ? QString() : errorIdText(state.error_id) + " ";
    words = id + found + " → " + QString::fromStdString(state.remedy);
  }
  write(line, state.phase == Phase::Idle ? QString() : what + ": " + words,
        state.unanswered || state.phase == Phase::Error);
}

void StopBar::write(Line& line, const QString& text, bool failed) {
  line.validity.begin();
  line.looks = 0;
  line.label->show(text);
  line.label->setStyleSheet(failed ? "color: #c0392b; font-weight: bold;" : "");
}

void StopBar::look() {
  stop_all_->setVisible(fleet_.isMany());
  lookAt(stop_line_, robot_->stopping());
  lookAt(control_line_, robot_->control());
  lookAtFleet();
}

void StopBar::lookAt(Line& line, Command& command) {
  using Phase = CommandState::Phase;
  const Phase phase = command.state().phase;
  if (phase == Phase::Error && line.validity.isOver(robot_->situation())) command.forget();
  if ((phase == Phase::Done || phase == Phase::Aborted) && ++line.looks > kLooksAtDone) command.forget();
}

void StopBar::leaveFleet() {
  fleet_looks_ = 0;
  fleet_.forget();
}

void StopBar::lookAtFleet() {
  if (fleet_looks_ == 0) return;
  const bool over = !fleet_.isBusy() && !fleet_.hasFailed() && ++fleet_looks_ > kLooksAtDone;
  if (over) leaveFleet();
  write(stop_line_, over ? QString() : "Stop all: " + QString::fromStdString(fleet_.told()),
        fleet_.hasFailed());
}

}  // namespace cobot_command::rviz_plugin
