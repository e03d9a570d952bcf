#include "pages/move_absolute_page.h"

#include <QHBoxLayout>
#include <QPushButton>
#include <algorithm>
#include <cmath>

#include "forms/forms.h"
#include "widgets/elided.h"

namespace cobot_command::rviz_plugin {
namespace {

constexpr double kSteps = 1000;  // of what is dragged, in a mm or a degree

CommandPageSpec moveAbsolutePage() {
  CommandPageSpec page{"move_absolute",
                       "Move Absolute",
                       moveAbsoluteForm,
                       moveAbsoluteBlock,
                       {{"Take current position", "target", "joints"}}};
  page.moves = true;
  return page;
}

QString nameOf(const Configuration& configuration) {
  return QString("%1, %2, %3")
      .arg(configuration[0] == 0 ? "righty" : "lefty", configuration[1] == 2 ? "above" : "below",
           configuration[2] == 4 ? "noflip" : "flip");
}

}  // namespace

MoveAbsolutePage::MoveAbsolutePage()
    : CommandPage(moveAbsolutePage()), configuration_(new ElidedLabel("configuration")) {
  addAboveForm(makeStepper());
}

QWidget* MoveAbsolutePage::makeStepper() {
  auto* row = new QWidget;
  auto* layout = new QHBoxLayout(row);
  layout->setContentsMargins(0, 0, 0, 0);
  auto* before = new QPushButton("◀");
  before->setObjectName("configuration_before");
  auto* next = new QPushButton("▶");
  next->setObjectName("configuration_next");
  for (QPushButton* button : {before, next}) {
    button->setToolTip("Another configuration that reaches the target");
  }
  connect(before, &QPushButton::clicked, this, [this] { step(-1); });
  connect(next, &QPushButton::clicked, this, [this] { step(1); });
  layout->addWidget(before);
  layout->addWidget(next);
  layout->addWidget(configuration_, 1);
  return row;
}

void MoveAbsolutePage::bind(const Workplace& workplace) {
  CommandPage::bind(workplace);
  workplace.target->onDrag([this](const Target::Six& target) { drag(target); });
  workplace.robot->onFrames([this] {
    if (isVisible()) showTarget();
  });
}

void MoveAbsolutePage::showEvent(QShowEvent* event) {
  CommandPage::showEvent(event);
  showTarget();
}

void MoveAbsolutePage::hideEvent(QHideEvent* event) {
  CommandPage::hideEvent(event);
  if (workplace().target != nullptr) workplace().target->hide();
}

std::optional<Configuration> MoveAbsolutePage::chosen() {
  if (!form().field("config1").shown) return std::nullopt;
  return Configuration{form().whole("config1"), form().whole("config2"), form().whole("config3")};
}

void MoveAbsolutePage::showTarget() {
  if (workplace().target == nullptr) return;
  const auto configuration = chosen();
  configuration_->show(configuration ? nameOf(*configuration) : QString("current configuration"));
  if (form().field("target.0").shown) {
    workplace().target->show(form().six("target"), configuration);
  } else {
    workplace().target->hide();
    workplace().preview->showArm(form().six("joints"));
  }
}

void MoveAbsolutePage::drag(const Target::Six& target) {
  Target::Six rounded{};
  std::transform(target.begin(), target.end(), rounded.begin(),
                 [](double number) { return std::round(number * kSteps) / kSteps; });
  if (!form().setSix("target", rounded)) return;
  refresh();
  changed();
}

void MoveAbsolutePage::step(int by) {
  const std::vector<Configuration>& reaching = workplace().target->configurations();
  if (reaching.empty() || !form().field("robot_pose_enable").shown) {
    configuration_->show(reaching.empty() ? "no configuration reaches the target"
                                          : "a line keeps the configuration of its start");
    return;
  }
  const auto now = chosen();
  const auto found = now ? std::find(reaching.begin(), reaching.end(), *now) : reaching.end();
  const auto count = static_cast<int>(reaching.size());
  const int place =
      found == reaching.end() ? 0 : (static_cast<int>(found - reaching.begin()) + by + count) % count;
  const Configuration& other = reaching[static_cast<std::size_t>(place)];
  form().set("robot_pose_enable", 1);
  form().set("config1", other[0]);
  form().set("config2", other[1]);
  form().set("config3", other[2]);
  refresh();
  changed();
}

}  // namespace cobot_command::rviz_plugin
