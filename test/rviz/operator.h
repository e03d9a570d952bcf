// What an operator does with the panel, by the mouse and the keyboard, and what he reads there.
#pragma once

#include <QPoint>
#include <QString>
#include <string>

class QWidget;

namespace cobot_command::test {

class Operator {
 public:
  /// Pictures of pages go into the folder; empty: none are made.
  Operator(QWidget& frame, QWidget& panel, std::string pictures);

  /// From the main menu.
  void open(const QString& page);
  /// By its namespace.
  void chooseRobot(const QString& name);
  [[nodiscard]] bool offersRobot(const QString& name) const;
  void scrollOverRobots();
  /// In the box of robots, and does not confirm it.
  void typeRobot(const QString& name);
  /// On the page that is open.
  void click(const QString& button);
  void enter(const QString& field, double number);
  void enter(const QString& field, const QString& text);
  /// And does not confirm it.
  void type(const QString& field, const QString& text);
  void choose(const QString& field, int value);
  void tick(const QString& field, bool on);
  void press(const QString& button);
  void release(const QString& button);
  /// The mouse, where something else has taken it.
  void releaseElsewhere();
  /// Always at hand.
  void clickStop();
  [[nodiscard]] bool isThere(const QString& widget) const;
  /// All of it, without scrolling.
  [[nodiscard]] bool isInSight(const QString& widget) const;
  /// In the panel.
  [[nodiscard]] QPoint placeOf(const QString& widget) const;
  [[nodiscard]] bool isEnabled(const QString& button) const;
  void clickAlways(const QString& button);

  [[nodiscard]] bool isLit(const QString& lamp) const;
  [[nodiscard]] QString textOf(const QString& label) const;
  [[nodiscard]] QString link() const;
  [[nodiscard]] QString robot() const;
  /// Always at hand.
  [[nodiscard]] QString textAlways(const QString& label) const;
  [[nodiscard]] double valueOf(const QString& field) const;
  [[nodiscard]] QString enteredIn(const QString& field) const;
  /// How the command of the page ended: "done", "checked", "error" or "aborted"; "busy" when it has not
  /// within so many seconds.
  [[nodiscard]] QString outcome(double seconds = 20) const;

  void takePicture(const QString& name) const;

 private:
  template <class Widget>
  Widget& find(const QString& name) const;

  QWidget& frame_;
  QWidget& panel_;
  std::string pictures_;
  QWidget* page_ = nullptr;
};

}  // namespace cobot_command::test
