#include "panel/cobot_panel.h"

#include <QAbstractButton>
#include <QApplication>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QStackedWidget>
#include <QTimer>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

#include "pages/cycle_page.h"
#include "pages/jog_page.h"
#include "pages/load_path_page.h"
#include "pages/main_page.h"
#include "pages/move_absolute_page.h"
#include "pages/pages.h"
#include "widgets/elided.h"
#include "widgets/robot_box.h"
#include "widgets/stop_bar.h"
#include "widgets/wording.h"
#include <pluginlib/class_list_macros.hpp>
#include <ros/master.h>
#include <ros/this_node.h>

namespace cobot_command::rviz_plugin {
namespace {

constexpr int kPeriod = 100;    // [ms]
constexpr int kListening = 20;  // [ms]
constexpr int kLooksAtFault = 40;
constexpr int kLooksBetweenLists = 30;  // of the robots that there are

/// "/robot_1/command_status" → "/robot_1".
std::string namespaceOf(const std::string& topic) {
  const std::size_t end = topic.rfind('/');
  return end == 0 || end == std::string::npos ? "/" : topic.substr(0, end);
}

/// From the root, as it is shown: ROS has nothing for the root itself.
std::string absolute(const std::string& name) {
  const std::string resolved = ros::names::resolve(name);
  return resolved.empty() ? "/" : resolved;
}

std::vector<std::string> findRobots() {
  ros::master::V_TopicInfo topics;
  std::vector<std::string> names;
  if (!ros::master::getTopics(topics)) return names;
  for (const ros::master::TopicInfo& topic : topics) {
    if (topic.datatype == "cobot_command/CommandStatus") names.push_back(namespaceOf(topic.name));
  }
  std::sort(names.begin(), names.end());
  return names;
}

QString connectionText(const std::optional<cobot_command::CommandStatus>& status) {
  if (!status) return "no command node";
  constexpr std::array<const char*, 5> kStates{"not connected", "connecting", "connecting",
                                               "not in the Listen node", "ready"};
  QString text = wordFor(kStates, status->link_state);
  if (!status->host.empty()) {
    text += QString(" · %1:%2").arg(QString::fromStdString(status->host)).arg(status->port);
  }
  return text;
}

QString robotText(const std::optional<cobot_command::RobotStatus>& status) {
  if (!status) return "";
  if (status->e_stopped == cobot_command::RobotStatus::TRUE) return " · emergency stop";
  if (status->in_error == cobot_command::RobotStatus::TRUE) return " · in error";
  if (status->safeguard == cobot_command::RobotStatus::TRUE) return " · safeguard";
  if (status->project_paused == cobot_command::RobotStatus::TRUE) return " · paused";
  if (status->in_motion == cobot_command::RobotStatus::TRUE) return " · moving";
  return "";
}

/// What an operator has to do before the robot can be moved; empty: nothing.
QString firstThing(const std::optional<cobot_command::CommandStatus>& status, const QString& robot) {
  if (!status) return "First: start the command node of " + robot + ", or choose another robot";
  switch (status->link_state) {
    case cobot_command::CommandStatus::DISCONNECTED:
      return "First: connect the robot (Main menu, Connect)";
    case cobot_command::CommandStatus::NOT_LISTENING:
      return "First: let the project of the robot enter its Listen node";
    default:
      return "";
  }
}

}  // namespace

CobotPanel::CobotPanel(QWidget* parent)
    : rviz::Panel(parent),
      robots_(new RobotBox),
      connection_(new ElidedLabel("link")),
      stop_bar_(new StopBar(fleet_)),
      guide_(new ElidedLabel("guide")),
      title_(new QLabel),
      stack_(new QStackedWidget),
      timer_(new QTimer(this)),
      listening_(new QTimer(this)) {
  setObjectName("cobot_panel");
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(makeHeader());
  layout->addWidget(stop_bar_);
  layout->addWidget(guide_);
  layout->addWidget(makeNavigation());
  layout->addWidget(stack_, 1);
  guide_->setStyleSheet("color: #9a6700; font-weight: bold;");
  makePages();
  choose(QString::fromStdString(ros::this_node::getNamespace()));
  connect(timer_, &QTimer::timeout, this, [this] { look(); });
  connect(listening_, &QTimer::timeout, this, [this] { robot_->listen(); });
}

CobotPanel::~CobotPanel() {
  timer_->stop();
  listening_->stop();
  preview_->leave();
  // Pages hold clients of the robot, and listen to it: they go first.
  delete stack_;
  delete stop_bar_;
}

void CobotPanel::onInitialize() {
  timer_->start(kPeriod);
  listening_->start(kListening);
}

QWidget* CobotPanel::makeHeader() {
  auto* header = new QWidget;
  auto* layout = new QHBoxLayout(header);
  layout->setContentsMargins(0, 0, 0, 0);
  robots_->onChoose([this](const QString& name) { choose(name); });
  layout->addWidget(new QLabel("Robot"));
  layout->addWidget(robots_);
  layout->addWidget(connection_, 1);
  return header;
}

QWidget* CobotPanel::makeNavigation() {
  auto* row = new QWidget;
  auto* layout = new QHBoxLayout(row);
  layout->setContentsMargins(0, 0, 0, 0);
  auto* menu = new QPushButton("Main menu");
  menu->setObjectName("main_menu");
  connect(menu, &QPushButton::clicked, this, [this] { open(*pages_.front()); });
  title_->setObjectName("title");
  layout->addWidget(title_, 1);
  layout->addWidget(menu);
  return row;
}

void CobotPanel::makePages() {
  auto* connect_page = new ConnectPage;
  auto* base = new CommandPage(changeBasePage());
  auto* tcp = new CommandPage(changeTcpPage());
  auto* interface = new InterfacePage;
  auto* relative = new CommandPage(moveRelativePage());
  auto* absolute = new MoveAbsolutePage;
  auto* circle = new CommandPage(moveCirclePage());
  auto* cycle = new CyclePage;
  auto* path = new LoadPathPage;
  auto* jog = new JogPage;
  auto* main = new MainPage({{"Configuration", {connect_page, base, tcp, interface}},
                             {"Motion", {relative, absolute, circle, cycle, path, jog}}},
                            [this](const Page& page) { open(page); });
  pages_ = {main, connect_page, base, tcp, interface, relative, absolute, circle, cycle, path, jog};
  for (Page* page : pages_) {
    auto* scroll = new QScrollArea;
    scroll->setWidget(page);
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAsNeeded);
    auto* screen = new QWidget;
    auto* layout = new QVBoxLayout(screen);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(scroll, 1);
    if (QWidget* footer = page->footer()) layout->addWidget(footer);
    stack_->addWidget(screen);
  }
  for (Page* page : pages_) page->onEdit([this] { Q_EMIT configChanged(); });
  stop_bar_->onStop([this] {
    for (Page* page : pages_) page->withdraw();
  });
  open(*main);
}

void CobotPanel::choose(const QString& name) {
  std::string fault;
  const bool valid = ros::names::validate(name.toStdString(), fault);
  if (!valid) {
    fault_ = "'" + name + "' is not a namespace";
    fault_looks_ = kLooksAtFault;
  }
  const std::string wanted = valid ? absolute(name.toStdString()) : name_.toStdString();
  if (robot_ && name_.toStdString() == wanted) {
    robots_->show(name_);
    return;
  }
  putUpButtons();
  if (preview_) preview_->leave();
  // The clients of the one before go only when the pages have new ones.
  auto robot = std::make_unique<Robot>(wanted);
  auto preview = std::make_unique<Preview>(*robot);
  auto target = std::make_unique<Target>(*robot, *preview);
  auto calls = std::make_unique<BackgroundCalls>();
  const Workplace workplace{robot.get(), calls.get(), preview.get(), target.get()};
  const QString left_name = std::exchange(name_, QString::fromStdString(wanted));
  for (Page* page : pages_) page->bind(workplace);
  stop_bar_->bind(*robot, name_);
  target_ = std::move(target);
  preview_ = std::move(preview);
  calls_ = std::move(calls);
  leave(std::exchange(robot_, std::move(robot)), left_name);
  robots_->show(name_);
  Q_EMIT configChanged();
}

void CobotPanel::leave(std::unique_ptr<Robot> robot, const QString& name) {
  if (!robot || !robot->stopping().isBusy()) return;
  robot->onTool([] {});
  robot->onFrames([] {});
  robot->control().onChange([] {});
  robot->stopping().onChange([this, name, &stopping = robot->stopping()] {
    const CommandState& state = stopping.state();
    if (state.phase != CommandState::Phase::Error && !state.unanswered) return;
    fault_ = name + ": Stop: " + QString::fromStdString(state.unanswered ? state.text : state.description);
    fault_looks_ = kLooksAtFault;
  });
  left_.push_back(std::move(robot));
}

void CobotPanel::putUpButtons() {
  for (QAbstractButton* button : findChildren<QAbstractButton*>()) button->setDown(false);
}

void CobotPanel::open(const Page& page) {
  const auto place = std::find(pages_.begin(), pages_.end(), &page) - pages_.begin();
  stack_->setCurrentIndex(static_cast<int>(place));
  title_->setText("<b>" + page.title() + "</b>");
}

void CobotPanel::look() {
  questions_.deliver();
  calls_->deliver();
  target_->look();
  preview_->look();
  robot_->look();
  for (const auto& robot : left_) {
    robot->listen();
    robot->look();
  }
  left_.erase(std::remove_if(left_.begin(), left_.end(),
                             [](const auto& robot) { return !robot->stopping().isBusy(); }),
              left_.end());
  fleet_.look();
  for (Page* page : pages_) page->look();
  stop_bar_->look();
  showConnection();
  showGuide();
  if (looks_++ % kLooksBetweenLists == 0) askForRobots();
}

void CobotPanel::showConnection() {
  QString now = connectionText(robot_->commandStatus());
  if (robot_->isStreaming()) now += robotText(robot_->robotStatus());
  if (robot_->isSilent()) now = "no data from the command node: the display is outdated";
  if (fault_looks_ > 0) --fault_looks_;
  connection_->show(fault_looks_ > 0 ? fault_ : now);
}

void CobotPanel::showGuide() {
  const bool blocked = QApplication::activeModalWidget() != nullptr;
  guide_->show(blocked ? "A dialog is open: STOP cannot be pressed. Close it, or use the emergency stop"
                       : firstThing(robot_->commandStatus(), name_));
}

void CobotPanel::askForRobots() {
  if (is_asking_) return;
  is_asking_ = true;
  const auto ask = [this]() -> std::function<void()> {
    return [this, names = findRobots()] { offerRobots(names); };
  };
  questions_.post(ask, [this] { is_asking_ = false; });
}

void CobotPanel::offerRobots(const std::vector<std::string>& names) {
  is_asking_ = false;
  fleet_.offer(names);
  robots_->offer(names);
}

void CobotPanel::save(rviz::Config config) const {
  rviz::Panel::save(config);
  config.mapSetValue("Robot", name_);
  config.mapSetValue("Page", stack_->currentIndex());
  rviz::Config forms = config.mapMakeChild("Forms");
  for (const Page* page : pages_) {
    const Page::Values values = page->saved();
    if (values.empty()) continue;
    rviz::Config form = forms.mapMakeChild(page->objectName());
    for (const auto& [key, value] : values) {
      form.mapSetValue(QString::fromStdString(key), QString::fromStdString(value));
    }
  }
}

void CobotPanel::load(const rviz::Config& config) {
  rviz::Panel::load(config);
  const rviz::Config forms = config.mapGetChild("Forms");
  for (Page* page : pages_) {
    const rviz::Config form = forms.mapGetChild(page->objectName());
    Page::Values values;
    for (rviz::Config::MapIterator it = form.mapIterator(); it.isValid(); it.advance()) {
      values[it.currentKey().toStdString()] = it.currentChild().getValue().toString().toStdString();
    }
    page->restore(values);
  }
  QString robot;
  if (config.mapGetString("Robot", &robot)) {
    choose(robot);
  }
  int page = 0;
  if (config.mapGetInt("Page", &page) && page > 0 && page < static_cast<int>(pages_.size())) {
    open(*pages_[static_cast<std::size_t>(page)]);
  }
}

}  // namespace cobot_command::rviz_plugin

PLUGINLIB_EXPORT_CLASS(cobot_command::rviz_plugin::CobotPanel, rviz::Panel)
