#include "widgets/status_box.h"

#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QVBoxLayout>
#include <QVariant>
#include <cmath>

#include "widgets/text_block.h"

namespace cobot_command::rviz_plugin {
namespace {

constexpr int kFirstOfPaths = 1000;
constexpr int kLastOfPaths = 1061;
constexpr int kLines = 4;
constexpr int kProgressHeight = 18;  // [pixels]

QLabel* lamp(const QString& text, const char* name) {
  auto* label = new QLabel(text);
  label->setObjectName(name);
  label->setAlignment(Qt::AlignCenter);
  return label;
}

void light(QLabel& label, bool on, const char* colour) {
  label.setProperty("on", on);
  label.setStyleSheet(
      on ? QString("background: %1; color: white; border-radius: 3px; padding: 3px;").arg(colour)
         : QString("background: palette(midlight); color: gray; border-radius: 3px; padding: 3px;"));
}

QString durationText(const CommandState& state, bool checks) {
  QString text =
      QString("%1 %2 s").arg(checks ? "It can be done: planned" : "planned").arg(state.planned, 0, 'f', 2);
  if (!checks && state.actual > 0) text += QString(", took %1 s").arg(state.actual, 0, 'f', 2);
  return text;
}

/// In words: what goes on, or how it ended, and what to do.
QString textOf(const CommandState& state, bool checks) {
  using Phase = CommandState::Phase;
  if (state.phase == Phase::Busy) return QString::fromStdString(state.text);
  QString text = QString::fromStdString(state.description);
  if (!state.remedy.empty()) text += (text.isEmpty() ? "" : "\n→ ") + QString::fromStdString(state.remedy);
  if (state.phase != Phase::Done) return text;
  if (state.planned > 0) text += (text.isEmpty() ? "" : "\n") + durationText(state, checks);
  if (checks && text.isEmpty()) text = "It can be done";
  return checks ? text + ". Nothing was sent to the robot." : text;
}

}  // namespace

QString errorIdText(int error_id) {
  if (error_id == 0) return "–";
  if (error_id >= kFirstOfPaths && error_id <= kLastOfPaths) return QString::number(error_id);
  return QString("16#%1").arg(QString::number(error_id, 16).toUpper());
}

StatusBox::StatusBox(QWidget* parent)
    : QWidget(parent),
      busy_(lamp("Busy", "busy")),
      checked_(lamp("Checked", "checked")),
      done_(lamp("Done", "done")),
      error_(lamp("Error", "error")),
      aborted_(lamp("Aborted", "aborted")),
      error_id_(new QLabel),
      ack_(new QLabel),
      progress_(new QProgressBar),
      text_(new TextBlock("status_text", kLines)) {
  error_id_->setObjectName("error_id");
  ack_->setObjectName("command_id_ack");
  progress_->setRange(0, 100);
  progress_->setMaximumHeight(kProgressHeight);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  auto* lamps = new QHBoxLayout;
  for (QLabel* label : {busy_, checked_, done_, error_, aborted_}) lamps->addWidget(label, 1);
  auto* numbers = new QGridLayout;
  numbers->addWidget(new QLabel("ErrorID"), 0, 0);
  numbers->addWidget(error_id_, 0, 1);
  numbers->addWidget(new QLabel("CmdID_Ack"), 0, 2);
  numbers->addWidget(ack_, 0, 3);
  numbers->addWidget(progress_, 0, 4);
  for (const int column : {1, 3}) numbers->setColumnStretch(column, 2);
  numbers->setColumnStretch(4, 5);
  layout->addLayout(lamps);
  layout->addLayout(numbers);
  layout->addWidget(text_);
  show({});
}

void StatusBox::show(const CommandState& state, bool checks) {
  using Phase = CommandState::Phase;
  light(*busy_, state.phase == Phase::Busy, "#2f6fb5");
  light(*checked_, checks && state.phase == Phase::Done, "#4f6b78");
  light(*done_, !checks && state.phase == Phase::Done, "#2e8b57");
  light(*error_, state.phase == Phase::Error, "#c0392b");
  light(*aborted_, state.phase == Phase::Aborted, "#b9770e");
  error_id_->setText(errorIdText(state.error_id));
  ack_->setText(state.command_id_ack == 0 ? "–" : QString::number(state.command_id_ack));
  const bool done = !checks && state.phase == Phase::Done;
  progress_->setEnabled(!checks && (done || state.progress >= 0));
  progress_->setValue(done ? 100 : static_cast<int>(std::lround(100 * std::max(0.0, state.progress))));
  text_->show(textOf(state, checks));
}

}  // namespace cobot_command::rviz_plugin
