#include "widgets/status_box.h"

#include <QGridLayout>
#include <QLabel>
#include <QProgressBar>
#include <QVariant>
#include <cmath>

namespace cobot_command::rviz_plugin {
namespace {

constexpr int kFirstOfPaths = 1000;
constexpr int kLastOfPaths = 1061;

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

/// In words: what goes on, or how it ended, and what to do.
QString textOf(const CommandState& state) {
  using Phase = CommandState::Phase;
  if (state.phase == Phase::Busy) return QString::fromStdString(state.text);
  QString text = QString::fromStdString(state.description);
  if (!state.remedy.empty()) text += (text.isEmpty() ? "" : "\n→ ") + QString::fromStdString(state.remedy);
  if (state.phase == Phase::Done && state.planned > 0) {
    text += QString("%1planned %2 s").arg(text.isEmpty() ? "" : "\n").arg(state.planned, 0, 'f', 2);
    if (state.actual > 0) text += QString(", took %1 s").arg(state.actual, 0, 'f', 2);
  }
  return text;
}

}  // namespace

QString errorIdText(int error_id) {
  if (error_id == 0) return "–";
  if (error_id >= kFirstOfPaths && error_id <= kLastOfPaths) return QString::number(error_id);
  return QString("16#%1").arg(QString::number(error_id, 16).toUpper());
}

StatusBox::StatusBox(QWidget* parent)
    : QGroupBox("Command status", parent),
      busy_(lamp("Busy", "busy")),
      done_(lamp("Done", "done")),
      error_(lamp("Error", "error")),
      aborted_(lamp("Aborted", "aborted")),
      error_id_(new QLabel),
      ack_(new QLabel),
      text_(new QLabel),
      progress_(new QProgressBar) {
  error_id_->setObjectName("error_id");
  ack_->setObjectName("command_id_ack");
  text_->setObjectName("status_text");
  text_->setWordWrap(true);
  text_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  text_->setMinimumHeight(48);
  text_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
  progress_->setRange(0, 100);
  auto* grid = new QGridLayout(this);
  int column = 0;
  for (QLabel* label : {busy_, done_, error_, aborted_}) grid->addWidget(label, 0, column++);
  grid->addWidget(new QLabel("ErrorID"), 1, 0);
  grid->addWidget(error_id_, 1, 1);
  grid->addWidget(new QLabel("CmdID_Ack"), 1, 2);
  grid->addWidget(ack_, 1, 3);
  grid->addWidget(progress_, 2, 0, 1, 4);
  grid->addWidget(text_, 3, 0, 1, 4);
  show({});
}

void StatusBox::show(const CommandState& state) {
  using Phase = CommandState::Phase;
  light(*busy_, state.phase == Phase::Busy, "#2f6fb5");
  light(*done_, state.phase == Phase::Done, "#2e8b57");
  light(*error_, state.phase == Phase::Error, "#c0392b");
  light(*aborted_, state.phase == Phase::Aborted, "#b9770e");
  error_id_->setText(errorIdText(state.error_id));
  ack_->setText(state.command_id_ack == 0 ? "–" : QString::number(state.command_id_ack));
  progress_->setEnabled(state.progress >= 0);
  progress_->setValue(
      state.phase == Phase::Done ? 100 : static_cast<int>(std::lround(100 * std::max(0.0, state.progress))));
  text_->setText(textOf(state));
}

}  // namespace cobot_command::rviz_plugin
