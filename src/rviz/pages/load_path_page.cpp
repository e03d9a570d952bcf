#include "pages/load_path_page.h"

#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>

#include "forms/forms.h"
#include "goals/path_points.h"
#include "widgets/number_box.h"
#include "widgets/text_block.h"
#include <cobot_command/SetFeedrate.h>
#include <std_srvs/Trigger.h>

namespace cobot_command::rviz_plugin {
namespace {

constexpr double kMostFeedrate = 125;

CommandPageSpec loadPathPage() {
  CommandPageSpec page{"load_path", "Load Path", loadPathForm, loadPathBlock, {}};
  page.moves = true;
  return page;
}

QString answerText(bool answered, bool success, const std::string& message) {
  if (!answered) return "The command node does not answer.";
  return message.empty() ? QString(success ? "Done." : "Refused.") : QString::fromStdString(message);
}

}  // namespace

LoadPathPage::LoadPathPage() : CommandPage(loadPathPage()), answer_(new TextBlock("path_answer")) {
  addBelowForm(makeFileButtons());
  addBelowForm(makeFeedrate());
  addBelowForm(answer_);
}

QWidget* LoadPathPage::makeFileButtons() {
  auto* row = new QWidget;
  auto* layout = new QHBoxLayout(row);
  layout->setContentsMargins(0, 0, 0, 0);
  auto* browse_button = new QPushButton("Browse ...");
  browse_button->setObjectName("browse");
  browse_button->setToolTip(
      "A file on this machine: it must be the command node's machine, or have the same files");
  auto* all = new QPushButton("All points");
  all->setObjectName("all_points");
  all->setToolTip("Counts the points of the file, if it can be read on this machine");
  connect(browse_button, &QPushButton::clicked, this, [this] { browse(); });
  connect(all, &QPushButton::clicked, this, [this] { takeAllPoints(); });
  layout->addWidget(browse_button);
  layout->addWidget(all);
  layout->addStretch();
  return row;
}

void LoadPathPage::browse() {
  auto* dialog = new QFileDialog(this, "Path file", "", "Paths (*.yaml *.yml);;All files (*)");
  dialog->setObjectName("browse_dialog");
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setFileMode(QFileDialog::ExistingFile);
  // That of the desktop would be modal, and take STOP away.
  dialog->setOption(QFileDialog::DontUseNativeDialog);
  dialog->setModal(false);
  connect(dialog, &QFileDialog::fileSelected, this, [this](const QString& file) {
    form().set("path_file", file.toStdString());
    takeAllPoints();
  });
  dialog->show();
}

void LoadPathPage::takeAllPoints() {
  const auto count = countPoints(form().text("path_file"));
  if (count && form().set("number_of_moves", *count)) {
    form().set("start_index", 0);
    answer_->show("");
  } else {
    answer_->show(
        count ? "The file has no points, or too many."
              : "The file cannot be read on this machine, or is not a path: enter the number of its points.");
  }
  refresh();
  changed();
}

QWidget* LoadPathPage::makeFeedrate() {
  auto* row = new QWidget;
  auto* layout = new QHBoxLayout(row);
  layout->setContentsMargins(0, 0, 0, 0);
  auto* feedrate = new NumberBox;
  feedrate->setObjectName("feedrate");
  feedrate->setRange(0, kMostFeedrate);
  feedrate->setValue(100);
  feedrate->setDecimals(0);
  feedrate->setSuffix(" %");
  feedrate->setKeyboardTracking(false);
  feedrate->setFocusPolicy(Qt::StrongFocus);
  auto* stop = new QPushButton("Stop on path");
  stop->setObjectName("stop_on_path");
  auto* resume = new QPushButton("Resume path");
  resume->setObjectName("resume_path");
  auto* set = new QPushButton("Set");
  set->setObjectName("set_feedrate");
  connect(set, &QPushButton::clicked, this, [this, feedrate] {
    feedrate->interpretText();
    setFeedrate(feedrate->value());
  });
  connect(stop, &QPushButton::clicked, this, [this] { trigger("stop_on_path"); });
  connect(resume, &QPushButton::clicked, this, [this] { trigger("resume_path"); });
  layout->addWidget(new QLabel("Feedrate"));
  for (QWidget* widget : std::initializer_list<QWidget*>{feedrate, set, stop, resume}) {
    layout->addWidget(widget);
  }
  layout->addStretch();
  return row;
}

void LoadPathPage::setFeedrate(double percent) {
  answer_->show("Requested ...");
  cobot_command::SetFeedrate service;
  service.request.percent = percent;
  workplace().calls->call<cobot_command::SetFeedrate>(
      workplace().robot->node().resolveName("set_feedrate"), service,
      [this](bool answered, const cobot_command::SetFeedrate& answer) {
        answer_->show(answerText(answered, answer.response.success, answer.response.message));
      });
}

void LoadPathPage::trigger(const char* service) {
  answer_->show("Requested ...");
  workplace().calls->call<std_srvs::Trigger>(
      workplace().robot->node().resolveName(service), {},
      [this](bool answered, const std_srvs::Trigger& answer) {
        answer_->show(answerText(answered, answer.response.success, answer.response.message));
      });
}

}  // namespace cobot_command::rviz_plugin
