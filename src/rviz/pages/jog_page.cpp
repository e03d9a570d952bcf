#include "pages/jog_page.h"

#include <QApplication>
#include <QEvent>
#include <QGridLayout>
#include <QLabel>
#include <QMouseEvent>
#include <QPushButton>
#include <QTimer>
#include <QVBoxLayout>

#include "forms/forms.h"
#include "goals/goals.h"
#include "widgets/form_view.h"
#include "widgets/status_box.h"
#include <std_msgs/Empty.h>

namespace cobot_command::rviz_plugin {
namespace {

constexpr int kTick = 20;  // [ms]
constexpr int kButtonHeight = 28;

bool isOfJoints(const Form& form) {
  return form.whole("mode") == cobot_command::JogGoal::AXES;
}

}  // namespace

JogPage::JogPage()
    : Page("jog", "Jog"),
      form_(jogForm()),
      view_(new FormView(form_)),
      footer_(new QWidget),
      status_(new StatusBox),
      holding_(new QTimer(this)) {
  auto* layout = new QVBoxLayout(this);
  // On top, where nothing that comes and goes below moves them under the mouse.
  auto* grid = new QGridLayout;
  for (int axis = 0; axis < kAxes; ++axis) addAxis(*grid, axis);
  layout->addLayout(grid);
  layout->addWidget(view_);
  layout->addStretch();
  auto* below = new QVBoxLayout(footer_);
  below->setContentsMargins(0, 0, 0, 0);
  auto* cancel = new QPushButton("Cancel");
  cancel->setObjectName("cancel");
  connect(cancel, &QPushButton::clicked, this, [this] { jog_->cancel(); });
  below->addWidget(cancel);
  below->addWidget(status_);
  holding_->setInterval(kTick);
  holding_->setTimerType(Qt::PreciseTimer);
  connect(holding_, &QTimer::timeout, this, [this] { tick(); });
  view_->onEdit([this] {
    jog_->forget();
    showWhere();
    tellEdit();
  });
  QApplication::instance()->installEventFilter(this);
}

void JogPage::addAxis(QGridLayout& grid, int axis) {
  const auto place = static_cast<std::size_t>(axis);
  names_[place] = new QLabel;
  values_[place] = new QLabel("–");
  values_[place]->setObjectName(QString("value_%1").arg(axis));
  values_[place]->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  grid.addWidget(names_[place], axis, 0);
  grid.addWidget(makeButton(axis, -1), axis, 1);
  grid.addWidget(values_[place], axis, 2);
  grid.addWidget(makeButton(axis, 1), axis, 3);
}

QPushButton* JogPage::makeButton(int axis, int direction) {
  auto* button = new QPushButton(direction < 0 ? "−" : "+");
  button->setObjectName(QString("jog_%1_%2").arg(axis).arg(direction < 0 ? "minus" : "plus"));
  button->setMinimumHeight(kButtonHeight);
  button->setFocusPolicy(Qt::NoFocus);  // no key repeats it, or keeps it pressed
  buttons_.push_back(button);
  connect(button, &QPushButton::pressed, this, [this, axis, direction] { press(axis, direction); });
  connect(button, &QPushButton::released, this, [this] { release(); });
  return button;
}

void JogPage::press(int axis, int direction) {
  view_->commit();
  pressed_ = Pressed{axis, direction};
  begin();
}

void JogPage::begin() {
  if (!pressed_ || jog_->isBusy()) return;
  const Pressed pressed = *pressed_;
  pressed_.reset();
  if (!form_.isOn("stepwise")) {
    keep_alive_->begin();
    holding_->start();
  }
  jog_->send(toJog(form_, pressed.axis, pressed.direction));
}

void JogPage::release() {
  holding_->stop();
  if (keep_alive_) keep_alive_->end();
  pressed_.reset();
  for (QPushButton* button : buttons_) button->setDown(false);
  // A node that comes later is not to move the arm for a button that nobody holds.
  if (jog_) jog_->withdraw();
}

void JogPage::follow() {
  status_->show(jog_->state());
  validity_.begin();
  if (jog_->isBusy()) return;
  holding_->stop();
  keep_alive_->end();
  begin();
}

void JogPage::hideEvent(QHideEvent* event) {
  release();
  Page::hideEvent(event);
}

void JogPage::tick() {
  // A menu, or a dialog, takes the mouse, and its buttons are not heard of here.
  if (QApplication::activePopupWidget() != nullptr || QApplication::activeModalWidget() != nullptr) {
    release();
    return;
  }
  keep_alive_->tick();
}

bool JogPage::eventFilter(QObject* object, QEvent* event) {
  const bool left = event->type() == QEvent::MouseButtonRelease &&
                    static_cast<const QMouseEvent*>(event)->button() == Qt::LeftButton;
  const bool away =
      event->type() == QEvent::ApplicationDeactivate || event->type() == QEvent::WindowDeactivate;
  if (left || away) release();
  return Page::eventFilter(object, event);
}

void JogPage::bind(const Workplace& workplace) {
  release();
  workplace_ = workplace;
  ros::NodeHandle node = workplace.robot->node();
  keep_alive_ = std::make_unique<KeepAlive>(
      [topic = node.advertise<std_msgs::Empty>("jog_keep_alive", 1)] { topic.publish(std_msgs::Empty()); });
  jog_ = std::make_unique<ActionCommand<cobot_command::JogAction>>(node, "jog");
  jog_->onChange([this] { follow(); });
  status_->show(jog_->state());
  showWhere();
}

void JogPage::look() {
  jog_->look();
  const CommandState& state = jog_->state();
  const bool refused = state.phase == CommandState::Phase::Error && state.refused;
  if (refused && validity_.isOver(workplace_.robot->situation())) jog_->forget();
  enableButtons();
  showWhere();
}

void JogPage::enableButtons() {
  const bool ready = workplace_.robot->isReady();
  for (QPushButton* button : buttons_) button->setEnabled(ready);
  if (!ready) release();
}

void JogPage::showWhere() {
  constexpr std::array kCartesian{"X", "Y", "Z", "RX", "RY", "RZ"};
  const bool joints = isOfJoints(form_);
  const auto now = joints ? workplace_.robot->joints() : workplace_.robot->tool();
  for (std::size_t i = 0; i < names_.size(); ++i) {
    names_[i]->setText(joints ? QString("J%1").arg(i + 1) : QString(kCartesian[i]));
    const QString unit = joints || i >= 3 ? "°" : "mm";
    values_[i]->setText(now ? QString("%1 %2").arg((*now)[i], 0, 'f', 2).arg(unit) : QString("–"));
  }
}

void JogPage::restore(const Values& values) {
  form_.restore(values);
  view_->refresh();
}

}  // namespace cobot_command::rviz_plugin
