#include "pages/pages.h"

#include <QDateTime>

#include "forms/forms.h"
#include "widgets/text_block.h"
#include "widgets/wording.h"

namespace cobot_command::rviz_plugin {
namespace {

CommandPageSpec moving(CommandPageSpec page) {
  page.moves = true;
  return page;
}

CommandPageSpec connectPage() {
  return {"connect", "Connect", connectForm, connectBlock, {}, "Connect", "Disconnect", true};
}

CommandPageSpec interfacePage() {
  return {"interface", "Interface", interfaceForm, interfaceBlock, {}, "Enable", "Disable", true};
}

QString timeText(const ros::Time& time) {
  if (time.isZero()) return "never";
  return QDateTime::fromMSecsSinceEpoch(static_cast<qint64>(time.toSec() * 1000))
      .toString("yyyy-MM-dd hh:mm:ss");
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
  return moving({"move_relative", "Move Relative", moveRelativeForm, moveRelativeBlock, {}});
}

CommandPageSpec moveCirclePage() {
  return moving({"move_circle",
                 "Move Circle",
                 moveCircleForm,
                 moveCircleBlock,
                 {{"Take as arc position", "arc", ""}, {"Take as end position", "end", ""}}});
}

ConnectPage::ConnectPage() : CommandPage(connectPage()), connection_(new TextBlock("connection")) {
  addBelowForm(connection_);
}

void ConnectPage::look() {
  CommandPage::look();
  const auto status = workplace().robot->commandStatus();
  connection_->show(status ? QString("%1\nLast connection: %2\nLast loss: %3")
                                 .arg(QString::fromStdString(status->diagnosis))
                                 .arg(timeText(status->last_connected))
                                 .arg(timeText(status->last_lost))
                           : QString("There is no command node here: start one, or choose another robot."));
}

InterfacePage::InterfacePage() : CommandPage(interfacePage()), group_(new TextBlock("group_state")) {
  addBelowForm(group_);
}

void InterfacePage::look() {
  CommandPage::look();
  const auto state = workplace().robot->groupState();
  group_->show(state ? groupText(*state) : QString());
}

}  // namespace cobot_command::rviz_plugin
