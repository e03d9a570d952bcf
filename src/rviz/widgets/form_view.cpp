#include "widgets/form_view.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QEvent>
#include <QFormLayout>
#include <QGridLayout>
#include <QGroupBox>
#include <QLabel>
#include <QLineEdit>
#include <algorithm>

#include "widgets/number_box.h"

namespace cobot_command::rviz_plugin {
namespace {

constexpr int kCellsInRow = 3;

QString toText(const std::string& text) {
  return QString::fromStdString(text);
}

/// As much of it as the field has room for, which counts bytes: a letter that is none of English is two of
/// them or more.
QString fitting(QString text, std::size_t longest) {
  while (static_cast<std::size_t>(text.toUtf8().size()) > longest) {
    text.chop(text.at(text.size() - 1).isLowSurrogate() ? 2 : 1);
  }
  return text;
}

/// Who scrolls a page does not mean to change the number that the pointer happens to be above.
class WheelGuard : public QObject {
 public:
  using QObject::QObject;

 protected:
  bool eventFilter(QObject* object, QEvent* event) override {
    const auto* widget = qobject_cast<QWidget*>(object);
    if (event->type() != QEvent::Wheel || widget == nullptr || widget->hasFocus()) return false;
    event->ignore();
    return true;
  }
};

}  // namespace

FormView::FormView(Form& form, QWidget* parent) : QWidget(parent), form_(form) {
  auto* layout = new QFormLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  for (const Field& field : form.fields()) {
    if (!field.group.empty()) {
      const bool known =
          std::any_of(groups_.begin(), groups_.end(), [&](const Group& g) { return g.name == field.group; });
      if (!known) addGroup(*layout, field.group);
      continue;
    }
    QWidget* editor = editorOf(field);
    layout->addRow(toText(field.kind == Field::Kind::Switch ? "" : field.label), editor);
    entries_.back().label = layout->labelForField(editor);
  }
  refresh();
}

void FormView::addGroup(QFormLayout& layout, const std::string& name) {
  auto* box = new QGroupBox(toText(name));
  auto* grid = new QGridLayout(box);
  grid->setContentsMargins(6, 4, 6, 6);
  int cell = 0;
  for (const Field& field : form_.fields()) {
    if (field.group != name) continue;
    auto* column = new QWidget;
    auto* inside = new QFormLayout(column);
    inside->setContentsMargins(0, 0, 0, 0);
    inside->setRowWrapPolicy(field.kind == Field::Kind::Choice || field.label.size() > 3
                                 ? QFormLayout::WrapAllRows
                                 : QFormLayout::DontWrapRows);
    QWidget* editor = editorOf(field);
    inside->addRow(toText(field.kind == Field::Kind::Switch ? "" : field.label), editor);
    entries_.back().label = column;
    grid->addWidget(column, cell / kCellsInRow, cell % kCellsInRow);
    ++cell;
  }
  for (int column = 0; column < kCellsInRow; ++column) grid->setColumnStretch(column, 1);
  layout.addRow(box);
  groups_.push_back({name, box});
}

QWidget* FormView::editorOf(const Field& field) {
  entries_.push_back({field.key, nullptr, nullptr, nullptr});
  QWidget* editor = nullptr;
  switch (field.kind) {
    case Field::Kind::Number:
      editor = numberEditor(field);
      break;
    case Field::Kind::Choice:
      editor = choiceEditor(field);
      break;
    case Field::Kind::Switch:
      editor = switchEditor(field);
      break;
    case Field::Kind::Text:
      editor = textEditor(field);
      break;
  }
  editor->setObjectName(toText(field.key));
  editor->setToolTip(toText(field.hint));
  editor->setFocusPolicy(Qt::StrongFocus);
  editor->installEventFilter(new WheelGuard(editor));
  entries_.back().editor = editor;
  return editor;
}

QWidget* FormView::numberEditor(const Field& field) {
  auto* box = new NumberBox;
  box->setDecimals(field.decimals);
  box->setRange(field.lowest, field.highest);
  box->setKeyboardTracking(false);
  box->setMinimumWidth(60);
  if (!field.unit.empty()) box->setSuffix(toText(" " + field.unit));
  entries_.back().put = [box](const Field& now) { box->setValue(now.number); };
  connect(box, qOverload<double>(&QDoubleSpinBox::valueChanged), this, [this, key = field.key](double value) {
    form_.set(key, value);
    edited();
  });
  return box;
}

QWidget* FormView::choiceEditor(const Field& field) {
  auto* box = new QComboBox;
  box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  entries_.back().put = [box](const Field& now) {
    box->clear();
    for (const Option& option : now.options) box->addItem(toText(option.label), option.value);
    box->setCurrentIndex(box->findData(static_cast<int>(now.number)));
  };
  connect(box, qOverload<int>(&QComboBox::activated), this, [this, box, key = field.key] {
    form_.set(key, box->currentData().toInt());
    edited();
  });
  return box;
}

QWidget* FormView::switchEditor(const Field& field) {
  auto* box = new QCheckBox(toText(field.label));
  entries_.back().put = [box](const Field& now) { box->setChecked(now.number != 0); };
  connect(box, &QCheckBox::toggled, this, [this, key = field.key](bool on) {
    form_.set(key, on ? 1 : 0);
    edited();
  });
  return box;
}

QWidget* FormView::textEditor(const Field& field) {
  auto* line = new QLineEdit;
  line->setPlaceholderText(toText(field.hint));
  entries_.back().put = [line](const Field& now) {
    if (line->text() != toText(now.text)) line->setText(toText(now.text));
  };
  connect(line, &QLineEdit::textChanged, this,
          [this, key = field.key, longest = field.longest](const QString& text) {
            form_.set(key, fitting(text, longest).toStdString());
            edited();
          });
  return line;
}

void FormView::commit() {
  for (QDoubleSpinBox* box : findChildren<QDoubleSpinBox*>()) box->interpretText();
}

void FormView::edited() {
  if (refreshes_) return;
  refresh();
  if (listener_) listener_();
}

void FormView::refresh() {
  refreshes_ = true;
  for (const Entry& entry : entries_) {
    const Field& field = form_.field(entry.key);
    const bool blocked = entry.editor->blockSignals(true);
    entry.put(field);
    entry.editor->blockSignals(blocked);
    entry.editor->setVisible(field.shown);
    if (entry.label != nullptr) entry.label->setVisible(field.shown);
  }
  for (const Group& group : groups_) {
    group.box->setVisible(std::any_of(form_.fields().begin(), form_.fields().end(), [&](const Field& field) {
      return field.group == group.name && field.shown;
    }));
  }
  refreshes_ = false;
}

}  // namespace cobot_command::rviz_plugin
