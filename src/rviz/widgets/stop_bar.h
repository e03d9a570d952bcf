// Stop, Pause and Resume: at hand whatever page is open.
#pragma once

#include <QWidget>
#include <functional>
#include <utility>

class QLabel;
class QPushButton;

namespace cobot_command::rviz_plugin {

class Command;
class Robot;

class StopBar : public QWidget {
 public:
  explicit StopBar(QWidget* parent = nullptr);

  /// Another robot, by the name that is written on the button; the one before is not used any more.
  void bind(Robot& robot, const QString& name);
  /// In front of the stop itself.
  void onStop(std::function<void()> listener) { stop_listener_ = std::move(listener); }

 private:
  void stop();
  static void tell(QLabel& text, const QString& what, const Command& command);

  Robot* robot_ = nullptr;
  QPushButton* stop_;
  QLabel* stop_text_;
  QLabel* control_text_;
  std::function<void()> stop_listener_;
};

}  // namespace cobot_command::rviz_plugin
