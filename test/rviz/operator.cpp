#include "operator.h"

#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QScreen>
#include <QTest>
#include <QVariant>
#include <QWheelEvent>
#include <QWindow>
#include <algorithm>
#include <stdexcept>
#include <utility>

#include "rviz_window.h"

namespace cobot_command::test {

Operator::Operator(QWidget& frame, QWidget& panel, std::string pictures)
    : frame_(frame), panel_(panel), pictures_(std::move(pictures)) {}

template <class Widget>
Widget& Operator::find(const QString& name) const {
  for (QWidget* place : {page_, &panel_}) {
    if (place == nullptr) continue;
    for (Widget* found : place->findChildren<Widget*>(name)) {
      if (found->isVisible()) return *found;
    }
  }
  throw std::runtime_error("nothing that is named " + name.toStdString() + " can be seen");
}

void Operator::open(const QString& page) {
  page_ = nullptr;
  clickAlways("main_menu");
  clickAlways("open_" + page);
  page_ = panel_.findChild<QWidget*>(page);
  if (page_ == nullptr || !page_->isVisible()) throw std::runtime_error("no page " + page.toStdString());
}

void Operator::typeRobot(const QString& name) {
  auto* robots = panel_.findChild<QComboBox*>("robots");
  // activateWindow(), which Qt 6 wants in its place, needs a window manager, and this screen has none.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wdeprecated-declarations"
  QApplication::setActiveWindow(&frame_);
#pragma GCC diagnostic pop
  robots->lineEdit()->setFocus();
  robots->lineEdit()->selectAll();
  QTest::keyClicks(robots->lineEdit(), name);
}

void Operator::chooseRobot(const QString& name) {
  typeRobot(name);
  QTest::keyClick(panel_.findChild<QComboBox*>("robots")->lineEdit(), Qt::Key_Return);
}

bool Operator::offersRobot(const QString& name) const {
  return panel_.findChild<QComboBox*>("robots")->findText(name) >= 0;
}

void Operator::scrollOverRobots() {
  auto* robots = panel_.findChild<QComboBox*>("robots");
  const QPoint middle = robots->rect().center();
  for (const int turn : {-120, 120}) {
    QWheelEvent wheel(middle, robots->mapToGlobal(middle), QPoint(), QPoint(0, turn), Qt::NoButton,
                      Qt::NoModifier, Qt::NoScrollPhase, false);
    QApplication::sendEvent(robots, &wheel);
    if (turn < 0 && robots->currentText() != "/") return;  // as it is to be seen
  }
}

void Operator::click(const QString& button) {
  QTest::mouseClick(&find<QPushButton>(button), Qt::LeftButton);
}

void Operator::clickAlways(const QString& button) {
  QTest::mouseClick(panel_.findChild<QPushButton*>(button), Qt::LeftButton);
}

void Operator::clickStop() {
  clickAlways("stop");
}

void Operator::enter(const QString& field, double number) {
  auto& box = find<QDoubleSpinBox>(field);
  box.selectAll();
  QTest::keyClicks(&box, QString::number(number, 'f', box.decimals()));
  QTest::keyClick(&box, Qt::Key_Return);
}

void Operator::enter(const QString& field, const QString& text) {
  auto& line = find<QLineEdit>(field);
  line.selectAll();
  QTest::keyClick(&line, Qt::Key_Delete);
  const bool has_keys =
      std::all_of(text.begin(), text.end(), [](QChar letter) { return letter < QChar(0x80); });
  if (has_keys) {
    QTest::keyClicks(&line, text);
  } else {
    line.insert(text);  // as from the clipboard: QTest has no keys for it
  }
}

void Operator::type(const QString& field, const QString& text) {
  auto& box = find<QDoubleSpinBox>(field);
  box.selectAll();
  QTest::keyClicks(&box, text);
}

void Operator::choose(const QString& field, int value) {
  auto& box = find<QComboBox>(field);
  const int wanted = box.findData(value);
  if (wanted < 0) throw std::runtime_error(field.toStdString() + " does not offer " + std::to_string(value));
  // By the keys, which work without the list being open.
  box.setFocus();
  while (box.currentIndex() != wanted) {
    QTest::keyClick(&box, box.currentIndex() < wanted ? Qt::Key_Down : Qt::Key_Up);
  }
}

void Operator::tick(const QString& field, bool on) {
  auto& box = find<QCheckBox>(field);
  if (box.isChecked() != on) QTest::keyClick(&box, Qt::Key_Space);
}

void Operator::press(const QString& button) {
  QTest::mousePress(&find<QPushButton>(button), Qt::LeftButton);
}

void Operator::release(const QString& button) {
  QTest::mouseRelease(&find<QPushButton>(button), Qt::LeftButton);
}

void Operator::releaseElsewhere() {
  QTest::mouseRelease(&frame_, Qt::LeftButton);
}

QString Operator::textAlways(const QString& label) const {
  return panel_.findChild<QLabel*>(label)->text();
}

bool Operator::isThere(const QString& widget) const {
  const auto* found = panel_.findChild<QWidget*>(widget);
  return found != nullptr && found->isVisible();
}

bool Operator::isInSight(const QString& widget) const {
  const auto& found = find<QWidget>(widget);
  const QRect whole(found.mapTo(&panel_, QPoint(0, 0)), found.size());
  return found.visibleRegion().boundingRect() == found.rect() && panel_.rect().contains(whole) &&
         frame_.rect().contains(QRect(found.mapTo(&frame_, QPoint(0, 0)), found.size()));
}

QPoint Operator::placeOf(const QString& widget) const {
  return find<QWidget>(widget).mapTo(&panel_, QPoint(0, 0));
}

bool Operator::isEnabled(const QString& button) const {
  return find<QPushButton>(button).isEnabled();
}

QString Operator::enteredIn(const QString& field) const {
  return find<QLineEdit>(field).text();
}

bool Operator::isLit(const QString& lamp) const {
  return find<QLabel>(lamp).property("on").toBool();
}

QString Operator::textOf(const QString& label) const {
  const auto& found = find<QWidget>(label);
  const QVariant text = found.property("text");
  return (text.isValid() ? text : found.property("plainText")).toString();
}

QString Operator::link() const {
  return panel_.findChild<QLabel*>("link")->text();
}

QString Operator::robot() const {
  return panel_.findChild<QComboBox*>("robots")->currentText();
}

double Operator::valueOf(const QString& field) const {
  return find<QDoubleSpinBox>(field).value();
}

QString Operator::outcome(double seconds) const {
  QString ended = "busy";
  const auto has_ended = [&] {
    for (const char* lamp : {"done", "checked", "error", "aborted"}) {
      if (isLit(lamp)) ended = lamp;
    }
    return ended != "busy";
  };
  static_cast<void>(holdsSoon(has_ended, seconds));
  return ended;
}

void Operator::takePicture(const QString& name) const {
  if (pictures_.empty()) return;
  QTest::qWait(300);  // RViz draws thirty times a second
  const QRect where(frame_.mapToGlobal(QPoint(0, 0)), frame_.size());
  const QPixmap picture = frame_.screen()->grabWindow(0, where.x(), where.y(), where.width(), where.height());
  if (!picture.save(QString::fromStdString(pictures_) + "/" + name + ".png")) {
    throw std::runtime_error("the picture cannot be written into " + pictures_);
  }
}

}  // namespace cobot_command::test
