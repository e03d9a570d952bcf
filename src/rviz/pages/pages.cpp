#include "pages/pages.h"

#include <QDateTime>
#include <QDoubleSpinBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>

#include "forms/forms.h"
#include "widgets/number_box.h"
#include "widgets/wording.h"
#include <cobot_command/SetFeedrate.h>
#include <std_srvs/Trigger.h>

namespace cobot_command::rviz_plugin {
namespace {

constexpr double kMostFeedrate = 125;

CommandPageSpec connectPage() {
  return {"connect", "Connect", connectForm, connectBlock, {}, "Connect", "Disconnect", true};
}

CommandPageSpec loadPathPage() {
  return {"load_path", "Load Path", loadPathForm, loadPathBlock, {}};
}

CommandPageSpec interfacePage() {
  return {"interface", "Interface", interfaceForm, interfaceBlock, {}, "Enable", "Disable", true};
}

QLabel* textBlock(const char* name) {
  auto* label = new QLabel;
  label->setObjectName(name);
  label->setWordWrap(true);
  label->setTextInteractionFlags(Qt::TextSelectableByMouse);
  return label;
}

QString timeText(const ros::Time& time) {
  if (time.isZero()) return "never";
  return QDateTime::fromMSecsSinceEpoch(static_cast<qint64>(time.toSec() * 1000))
      .toString("yyyy-MM-dd hh:mm:ss");
}

QString answerText(bool answered, bool success, const std::string& message) {
  if (!answered) return "The command node does not answer.";
  return message.empty() ? QString(success ? "Done." : "Refused.") : QString::fromStdString(message);
}

QString groupText(const cobot_command::GroupState& state) {
  constexpr std::array<const char*, 3> kInterface{"not initialized", "initialized", "synchronized"};
  constexpr std::array<const char*, 3> kSequence{"idle", "executing", "interrupted"};
  QString text = QString("Interface: %1\nRobot: %2, %3\nQueue: %4 %, speed override %5 %")
                     .arg(wordFor(kInterface, state.ri_state))
                     .arg(state.enabled ? "enabled" : "not enabled")
                     .arg(wordFor(kSequence, state.sequence))
                     .arg(state.queue_usage, 0, 'f', 0)
                     .arg(state.speed_override, 0, 'f', 0);
  if (!state.out_of_sync.empty()) text += "\nOut of sync: " + QString::fromStdString(state.out_of_sync);
  return text;
}

}  // namespace

CommandPageSpec changeBasePage() {
  return {"change_base", "Change Base", changeBaseForm, changeBaseBlock, {}};
}

CommandPageSpec changeTcpPage() {
  return {"change_tcp", "Change TCP", changeTcpForm, changeTcpBlock, {}};
}

CommandPageSpec moveRelativePage() {
  return {"move_relative", "Move Relative", moveRelativeForm, moveRelativeBlock, {}};
}

CommandPageSpec moveCirclePage() {
  return {"move_circle",
          "Move Circle",
          moveCircleForm,
          moveCircleBlock,
          {{"Take as arc position", "arc", ""}, {"Take as end position", "end", ""}}};
}

ConnectPage::ConnectPage() : CommandPage(connectPage()), connection_(textBlock("connection")) {
  addBelowForm(connection_);
}

void ConnectPage::look() {
  CommandPage::look();
  const auto status = workplace().robot->commandStatus();
  connection_->setText(status
                           ? QString("%1\nLast connection: %2\nLast loss: %3")
                                 .arg(QString::fromStdString(status->diagnosis))
                                 .arg(timeText(status->last_connected))
                                 .arg(timeText(status->last_lost))
                           : QString("There is no command node here: start one, or choose another robot."));
}

LoadPathPage::LoadPathPage() : CommandPage(loadPathPage()), answer_(textBlock("path_answer")) {
  addBelowForm(makeFeedrate());
  addBelowForm(answer_);
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
  answer_->setText("Asked ...");
  cobot_command::SetFeedrate service;
  service.request.percent = percent;
  workplace().calls->call<cobot_command::SetFeedrate>(
      workplace().robot->node().resolveName("set_feedrate"), service,
      [this](bool answered, const cobot_command::SetFeedrate& answer) {
        answer_->setText(answerText(answered, answer.response.success, answer.response.message));
      });
}

void LoadPathPage::trigger(const char* service) {
  answer_->setText("Asked ...");
  workplace().calls->call<std_srvs::Trigger>(
      workplace().robot->node().resolveName(service), {},
      [this](bool answered, const std_srvs::Trigger& answer) {
        answer_->setText(answerText(answered, answer.response.success, answer.response.message));
      });
}

InterfacePage::InterfacePage() : CommandPage(interfacePage()), group_(textBlock("group_state")) {
  addBelowForm(group_);
}

void InterfacePage::look() {
  CommandPage::look();
  const auto state = workplace().robot->groupState();
  group_->setText(state ? groupText(*state) : QString());
}

}  // namespace cobot_command::rviz_plugin
