// Stop, Pause and Resume: at hand whatever page is open.
#pragma once

#include <QWidget>

class QLabel;

namespace cobot_command::rviz_plugin {

class Command;
class Robot;

class StopBar : public QWidget {
 public:
  explicit StopBar(QWidget* parent = nullptr);

  /// Another robot; the one before is not used any more.
  void bind(Robot& robot);

 private:
  void tell(const char* what, const Command& command);

  Robot* robot_ = nullptr;
  QLabel* text_;
};

}  // namespace cobot_command::rviz_plugin
