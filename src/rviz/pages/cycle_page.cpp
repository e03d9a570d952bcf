#include "pages/cycle_page.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QStackedWidget>
#include <QVBoxLayout>
#include <memory>
#include <utility>

#include "clients/action_command.h"
#include "goals/goals.h"
#include "widgets/cycle_view.h"
#include "widgets/form_view.h"
#include "widgets/status_box.h"
#include <cobot_command/PickAndPlaceAction.h>

namespace cobot_command::rviz_plugin {
namespace {

/// In saved configurations: keys of a move behind its number, "1.speed_percent".
std::string keyOf(std::size_t move, const std::string& key) {
  return std::to_string(move + 1) + "." + key;
}

}  // namespace

CyclePage::CyclePage()
    : Page("pick_and_place", "PnP Sequence"),
      cycle_(presetCycle()),
      views_(new QStackedWidget),
      footer_(new QWidget),
      status_(new StatusBox),
      pair_(*status_) {
  auto* layout = new QVBoxLayout(this);
  views_->addWidget(makeOverview());
  for (std::size_t move = 0; move < Cycle::kMoves; ++move) views_->addWidget(makeEditor(move));
  pair_.onChange([this] { picture_->showStep(pair_.execution().state().step); });
  for (FormView* editor : editors_) editor->onEdit([this] { changed(); });
  general_->onEdit([this] { changed(); });
  connect(views_, &QStackedWidget::currentChanged, this, [this] { fitHeight(); });
  fitHeight();
  layout->addWidget(views_);
  layout->addStretch();
  addCommands();
}

void CyclePage::fitHeight() {
  // As high as the view that is open: else all are as high as the highest.
  for (int i = 0; i < views_->count(); ++i) {
    const bool open = i == views_->currentIndex();
    views_->widget(i)->setSizePolicy(QSizePolicy::Preferred,
                                     open ? QSizePolicy::Preferred : QSizePolicy::Ignored);
  }
}

QWidget* CyclePage::makeOverview() {
  auto* overview = new QWidget;
  auto* layout = new QVBoxLayout(overview);
  layout->setContentsMargins(0, 0, 0, 0);
  picture_ = new CycleView(cycle_,
                           [this](std::size_t move) { views_->setCurrentIndex(static_cast<int>(move) + 1); });
  general_ = new FormView(cycle_.general);
  layout->addWidget(picture_);
  layout->addWidget(general_);
  return overview;
}

QWidget* CyclePage::makeEditor(std::size_t move) {
  auto* editor = new QWidget;
  editor->setObjectName(QString("editor_%1").arg(move + 1));
  auto* layout = new QVBoxLayout(editor);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(new QLabel(QString("<b>Move %1: %2</b>").arg(move + 1).arg(Cycle::kNames[move])));
  editors_[move] = new FormView(cycle_.moves[move]);
  layout->addWidget(editors_[move]);
  auto* buttons = new QHBoxLayout;
  auto* take = new QPushButton("Take current position");
  take->setObjectName("take_target");
  connect(take, &QPushButton::clicked, this, [this, move] {
    if (const auto tool = workplace_.robot->tool()) cycle_.moves[move].setSix("target", *tool);
    if (const auto joints = workplace_.robot->joints()) cycle_.moves[move].setSix("joints", *joints);
    editors_[move]->refresh();
    changed();
  });
  auto* back = new QPushButton("Back to the cycle");
  back->setObjectName("back");
  connect(back, &QPushButton::clicked, this, [this] { views_->setCurrentIndex(0); });
  buttons->addWidget(take);
  buttons->addWidget(back);
  layout->addLayout(buttons);
  return editor;
}

QPushButton* CyclePage::addButton(const char* text, const char* name, std::function<void()> action) {
  auto* button = new QPushButton(text, footer_);
  button->setObjectName(name);
  connect(button, &QPushButton::clicked, this, std::move(action));
  return button;
}

void CyclePage::addCommands() {
  auto* preset = addButton("Preset values", "preset", [this] {
    // Assigned one by one: the views look at these forms.
    const Cycle values = presetCycle();
    for (std::size_t move = 0; move < Cycle::kMoves; ++move) cycle_.moves[move] = values.moves[move];
    cycle_.general = values.general;
    refresh();
    changed();
  });
  check_ = addButton("Check", "check", [this] {
    commit();
    pair_.showCheck();
    send_(true);
  });
  execute_ = addButton("Execute", "execute", [this] {
    commit();
    pair_.showExecution();
    send_(false);
  });
  auto* cancel = addButton("Cancel", "cancel", [this] { pair_.cancel(false); });
  auto* layout = new QVBoxLayout(footer_);
  layout->setContentsMargins(0, 0, 0, 0);
  auto* buttons = new QHBoxLayout;
  for (QPushButton* button : {preset, check_, execute_, cancel}) buttons->addWidget(button);
  layout->addLayout(buttons);
  layout->addWidget(status_);
}

void CyclePage::look() {
  pair_.look();
  for (QPushButton* button : {check_, execute_}) button->setEnabled(workplace_.robot->isReady());
}

void CyclePage::bind(const Workplace& workplace) {
  using PickAndPlace = ActionCommand<cobot_command::PickAndPlaceAction>;
  workplace_ = workplace;
  auto execution = std::make_unique<PickAndPlace>(workplace.robot->node(), "pick_and_place");
  auto checking = std::make_unique<PickAndPlace>(workplace.robot->node(), "pick_and_place");
  send_ = [this, &execute = *execution, &check = *checking](bool check_only) {
    (check_only ? check : execute).send(toPickAndPlace(cycle_, check_only));
  };
  pair_.bind(std::move(execution), std::move(checking), *workplace.robot, *workplace.preview);
}

void CyclePage::commit() {
  for (FormView* editor : editors_) editor->commit();
  general_->commit();
}

Page::Values CyclePage::saved() const {
  Values values = cycle_.general.saved();
  for (std::size_t move = 0; move < Cycle::kMoves; ++move) {
    for (const auto& [key, value] : cycle_.moves[move].saved()) values[keyOf(move, key)] = value;
  }
  return values;
}

void CyclePage::restore(const Values& values) {
  cycle_.general.restore(values);
  for (std::size_t move = 0; move < Cycle::kMoves; ++move) {
    Values of_move;
    for (const auto& [key, value] : cycle_.moves[move].saved()) {
      const auto kept = values.find(keyOf(move, key));
      of_move[key] = kept == values.end() ? value : kept->second;
    }
    cycle_.moves[move].restore(of_move);
  }
  refresh();
}

void CyclePage::changed() {
  pair_.forget();
  picture_->update();
  tellEdit();
}

void CyclePage::refresh() {
  for (FormView* editor : editors_) editor->refresh();
  general_->refresh();
  picture_->update();
}

}  // namespace cobot_command::rviz_plugin
