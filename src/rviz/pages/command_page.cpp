#include "pages/command_page.h"

#include <QHBoxLayout>
#include <QPushButton>
#include <QVBoxLayout>
#include <utility>

#include "widgets/form_view.h"
#include "widgets/status_box.h"

namespace cobot_command::rviz_plugin {
namespace {

QPushButton* button(const QString& text, const char* name) {
  auto* made = new QPushButton(text);
  made->setObjectName(name);
  return made;
}

QWidget* emptyColumn() {
  auto* column = new QWidget;
  auto* layout = new QVBoxLayout(column);
  layout->setContentsMargins(0, 0, 0, 0);
  return column;
}

}  // namespace

CommandPage::CommandPage(const CommandPageSpec& spec)
    : Page(spec.name, spec.title),
      form_(spec.form()),
      make_block_(spec.block),
      moves_(spec.moves),
      view_(new FormView(form_)),
      footer_(emptyColumn()),
      status_(new StatusBox),
      pair_(*status_),
      above_form_(emptyColumn()),
      below_form_(emptyColumn()) {
  view_->onEdit([this] { changed(); });
  pair_.onChange([this] { enableExecute(); });
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(above_form_);
  layout->addWidget(view_);
  auto* helpers = new QHBoxLayout;
  addPresets(*helpers);
  addTakings(*helpers, spec.takings);
  helpers->addStretch();
  layout->addLayout(helpers);
  layout->addWidget(below_form_);
  layout->addStretch();
  auto* buttons = new QWidget;
  auto* row = new QHBoxLayout(buttons);
  row->setContentsMargins(0, 0, 0, 0);
  addButtons(*row, spec);
  footer_->layout()->addWidget(buttons);
  footer_->layout()->addWidget(status_);
}

void CommandPage::addAboveForm(QWidget* widget) {
  above_form_->layout()->addWidget(widget);
}

void CommandPage::addBelowForm(QWidget* widget) {
  below_form_->layout()->addWidget(widget);
}

void CommandPage::addPresets(QBoxLayout& layout) {
  for (std::size_t i = 0; i < form_.presets().size(); ++i) {
    QPushButton* preset =
        button(QString::fromStdString(form_.presets()[i].name), i == 0 ? "preset" : "other_preset");
    connect(preset, &QPushButton::clicked, this, [this, i] {
      form_.apply(form_.presets()[i]);
      refresh();
      changed();
    });
    layout.addWidget(preset);
  }
}

void CommandPage::addTakings(QBoxLayout& layout, const std::vector<Taking>& takings) {
  for (const Taking& taking : takings) {
    QPushButton* taker = button(taking.label, ("take_" + taking.tool).c_str());
    taker->setToolTip("Current position of the robot");
    connect(taker, &QPushButton::clicked, this, [this, taking] { take(taking); });
    layout.addWidget(taker);
  }
}

void CommandPage::addButtons(QBoxLayout& layout, const CommandPageSpec& spec) {
  check_button_ = button("Check", "check");
  check_button_->setToolTip("Plans the command; nothing is sent to the robot");
  execute_button_ = button(spec.execute, "execute");
  QPushButton* cancel = button(spec.cancel, "cancel");
  connect(check_button_, &QPushButton::clicked, this, [this] {
    view_->commit();
    pair_.showCheck();
    check_(form_);
  });
  connect(execute_button_, &QPushButton::clicked, this, [this] {
    view_->commit();
    pair_.showExecution();
    execute_(form_);
  });
  connect(cancel, &QPushButton::clicked, this, [this, all = spec.cancels_all] { pair_.cancel(all); });
  for (QPushButton* made : {check_button_, execute_button_, cancel}) layout.addWidget(made);
}

void CommandPage::take(const Taking& taking) {
  if (const auto tool = workplace_.robot->tool()) form_.setSix(taking.tool, *tool);
  const auto joints = workplace_.robot->joints();
  if (joints && !taking.joints.empty()) form_.setSix(taking.joints, *joints);
  refresh();
  changed();
}

void CommandPage::refresh() {
  view_->refresh();
}

void CommandPage::bind(const Workplace& workplace) {
  workplace_ = workplace;
  Block block = make_block_(workplace.robot->node());
  execute_ = std::move(block.execute);
  check_ = std::move(block.check);
  pair_.bind(std::move(block.execution), std::move(block.checking), *workplace.robot, *workplace.preview);
  check_button_->setVisible(pair_.canCheck());
}

void CommandPage::look() {
  pair_.look();
  enableExecute();
}

void CommandPage::changed() {
  pair_.forget();
  enableExecute();
  edited();
  tellEdit();
}

void CommandPage::enableExecute() {
  const bool refuses = !form_.has("buffer_mode") || form_.whole("buffer_mode") == 0;
  const bool there = !moves_ || (workplace_.robot != nullptr && workplace_.robot->isReady());
  execute_button_->setEnabled(there && (!refuses || !pair_.execution().isBusy()));
  check_button_->setEnabled(there);
}

void CommandPage::restore(const Values& values) {
  form_.restore(values);
  view_->refresh();
}

}  // namespace cobot_command::rviz_plugin
