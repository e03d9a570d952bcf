// Chooses a robot by the namespace of its command node: from the list, or typed and confirmed by Enter.
// Nothing else chooses one, and it never goes on showing another one than the one that is commanded.
#pragma once

#include <QComboBox>
#include <functional>
#include <string>
#include <vector>

namespace cobot_command::rviz_plugin {

class RobotBox : public QComboBox {
 public:
  RobotBox();

  /// The one that is commanded.
  void show(const QString& name);
  [[nodiscard]] const QString& shown() const { return name_; }
  /// In the list; not under the hand of somebody who types, or has it open.
  void offer(const std::vector<std::string>& names);
  void onChoose(std::function<void(const QString&)> listener) { listener_ = std::move(listener); }

 protected:
  void focusOutEvent(QFocusEvent* event) override;
  /// Scrolling chooses none.
  void wheelEvent(QWheelEvent* event) override;
  /// The arrow keys open the list.
  void keyPressEvent(QKeyEvent* event) override;
  /// What was typed goes as soon as anything else is clicked: also buttons that take no focus.
  bool eventFilter(QObject* object, QEvent* event) override;

 private:
  void mark();

  QString name_;
  std::function<void(const QString&)> listener_;
};

}  // namespace cobot_command::rviz_plugin
