#include "widgets/robot_box.h"

#include <QAbstractItemView>
#include <QApplication>
#include <QCompleter>
#include <QKeyEvent>
#include <QLineEdit>
#include <QSignalBlocker>
#include <QWheelEvent>

namespace cobot_command::rviz_plugin {

RobotBox::RobotBox() {
  setObjectName("robots");
  setEditable(true);
  setInsertPolicy(QComboBox::NoInsert);
  setCompleter(nullptr);  // it would make a robot of another one's first letters
  setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  setMinimumContentsLength(12);
  setToolTip(
      "The namespace of the robot's command node: choose it from the list, or type it and press Enter");
  // Of its own a box chooses what was typed, where the list has it, when the focus goes: by the click on a
  // button of another robot.
  disconnect(lineEdit(), &QLineEdit::editingFinished, this, nullptr);
  disconnect(lineEdit(), &QLineEdit::returnPressed, this, nullptr);
  const auto choose = [this] {
    if (listener_) listener_(currentText());
  };
  connect(lineEdit(), &QLineEdit::returnPressed, this, choose);
  connect(this, qOverload<int>(&QComboBox::activated), this, choose);
  connect(lineEdit(), &QLineEdit::textChanged, this, [this] { mark(); });
  QApplication::instance()->installEventFilter(this);
}

void RobotBox::show(const QString& name) {
  const QSignalBlocker blocked(this);
  name_ = name;
  if (findText(name_) < 0) addItem(name_);
  setCurrentIndex(findText(name_));
  setEditText(name_);
  mark();
}

void RobotBox::offer(const std::vector<std::string>& names) {
  if (lineEdit()->hasFocus() || view()->isVisible()) return;
  const QSignalBlocker blocked(this);
  clear();
  for (const std::string& name : names) addItem(QString::fromStdString(name));
  show(name_);
}

void RobotBox::mark() {
  const bool confirmed = lineEdit()->text() == name_;
  lineEdit()->setStyleSheet(confirmed ? "" : "color: #9a6700; font-style: italic;");
}

void RobotBox::focusOutEvent(QFocusEvent* event) {
  QComboBox::focusOutEvent(event);
  if (event->reason() != Qt::PopupFocusReason) show(name_);
}

void RobotBox::wheelEvent(QWheelEvent* event) {
  event->ignore();
}

void RobotBox::keyPressEvent(QKeyEvent* event) {
  switch (event->key()) {
    case Qt::Key_Up:
    case Qt::Key_Down:
    case Qt::Key_PageUp:
    case Qt::Key_PageDown:
      showPopup();
      return;
    case Qt::Key_Escape:
      show(name_);
      return;
    default:
      QComboBox::keyPressEvent(event);
  }
}

bool RobotBox::eventFilter(QObject* object, QEvent* event) {
  if (event->type() == QEvent::MouseButtonPress && lineEdit() != nullptr && lineEdit()->text() != name_) {
    const auto* widget = qobject_cast<QWidget*>(object);
    if (widget != nullptr && widget != this && !isAncestorOf(widget) &&
        widget->window() != view()->window()) {
      show(name_);
    }
  }
  return QComboBox::eventFilter(object, event);
}

}  // namespace cobot_command::rviz_plugin
