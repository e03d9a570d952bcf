#include "pages/command_page.h"

#include <QHBoxLayout>
#include <QPushButton>
#include <QVBoxLayout>

#include "widgets/form_view.h"
#include "widgets/status_box.h"

namespace cobot_command::rviz_plugin {
namespace {

QPushButton* button(const QString& text, const char* name) {
  auto* made = new QPushButton(text);
  made->setObjectName(name);
  return made;
}

}  // namespace

CommandPage::CommandPage(const CommandPageSpec& spec)
    : Page(spec.name, spec.title),
      form_(spec.form()),
      make_block_(spec.block),
      view_(new FormView(form_)),
      status_(new StatusBox),
      below_form_(new QWidget) {
  view_->onEdit([this] { edited(); });
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(view_);
  auto* helpers = new QHBoxLayout;
  addPresets(*helpers);
  addTakings(*helpers, spec.takings);
  helpers->addStretch();
  layout->addLayout(helpers);
  new QVBoxLayout(below_form_);
  below_form_->layout()->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(below_form_);
  auto* buttons = new QHBoxLayout;
  addButtons(*buttons, spec);
  layout->addLayout(buttons);
  layout->addWidget(status_);
  layout->addStretch();
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
      edited();
    });
    layout.addWidget(preset);
  }
}

void CommandPage::addTakings(QBoxLayout& layout, const std::vector<Taking>& takings) {
  for (const Taking& taking : takings) {
    QPushButton* taker = button(taking.label, ("take_" + taking.tool).c_str());
    taker->setToolTip("Where the robot is now");
    connect(taker, &QPushButton::clicked, this, [this, taking] { take(taking); });
    layout.addWidget(taker);
  }
}

void CommandPage::addButtons(QBoxLayout& layout, const CommandPageSpec& spec) {
  check_ = button("Check", "check");
  check_->setToolTip("Plans it, and sends nothing");
  QPushButton* execute = button(spec.execute, "execute");
  QPushButton* cancel = button(spec.cancel, "cancel");
  connect(check_, &QPushButton::clicked, this, [this] {
    shown_ = block_.checking.get();
    block_.check(form_);
  });
  connect(execute, &QPushButton::clicked, this, [this] {
    shown_ = block_.execution.get();
    block_.execute(form_);
  });
  connect(cancel, &QPushButton::clicked, this, [this] {
    block_.execution->cancel();
    if (block_.checking) block_.checking->cancel();
  });
  layout.addWidget(check_);
  layout.addWidget(execute);
  layout.addWidget(cancel);
}

void CommandPage::take(const Taking& taking) {
  if (const auto tool = workplace_.robot->tool()) form_.setSix(taking.tool, *tool);
  const auto joints = workplace_.robot->joints();
  if (joints && !taking.joints.empty()) form_.setSix(taking.joints, *joints);
  refresh();
  edited();
}

void CommandPage::refresh() {
  view_->refresh();
}

void CommandPage::bind(const Workplace& workplace) {
  workplace_ = workplace;
  block_ = make_block_(workplace.robot->node());
  shown_ = block_.execution.get();
  watch(*block_.execution);
  check_->setVisible(block_.checking != nullptr);
  if (block_.checking) watch(*block_.checking);
  status_->show(shown_->state());
}

void CommandPage::watch(Command& command) {
  command.onChange([this, &command] {
    if (shown_ == &command) status_->show(command.state());
    showEnd(command);
  });
}

void CommandPage::showEnd(const Command& command) {
  if (block_.checking.get() == &command) {
    if (!command.isBusy()) workplace_.preview->show(command.plan());
  } else if (command.state().phase == CommandState::Phase::Done) {
    workplace_.preview->hide();
  }
}

void CommandPage::look() {
  block_.execution->look();
  if (block_.checking) block_.checking->look();
}

void CommandPage::restore(const Values& values) {
  form_.restore(values);
  view_->refresh();
}

}  // namespace cobot_command::rviz_plugin
