// Stop, Pause and Resume: at hand whatever page is open.
#pragma once

#include <QWidget>
#include <functional>
#include <utility>

#include "clients/situation.h"

class QPushButton;

namespace cobot_command::rviz_plugin {

class Command;
class ElidedButton;
class ElidedLabel;
class Fleet;
class Robot;

class StopBar : public QWidget {
 public:
  explicit StopBar(Fleet& fleet, QWidget* parent = nullptr);

  /// Another robot, by the name that is written on the button; the one before is not used any more.
  void bind(Robot& robot, const QString& name);
  /// Before the stop itself.
  void onStop(std::function<void()> listener) { stop_listener_ = std::move(listener); }
  /// A few times a second: messages whose cause has gone go.
  void look();

 private:
  /// A line under the buttons, and since when it is there.
  struct Line {
    ElidedLabel* label;
    Validity validity{};
    int looks = 0;
  };

  void stop();
  void stopAll();
  void control(bool pauses);
  void tell(Line& line, const QString& what, const QString& done, const Command& command);
  void write(Line& line, const QString& text, bool failed);
  void lookAt(Line& line, Command& command);
  void lookAtFleet();
  /// What came of the last stop of all is told no longer.
  void leaveFleet();

  Fleet& fleet_;
  Robot* robot_ = nullptr;
  ElidedButton* stop_;
  QPushButton* stop_all_;
  Line stop_line_;
  Line control_line_;
  bool pauses_ = false;  ///< what was asked last: a pause, and not that the robot goes on
  int fleet_looks_ = 0;  ///< since its last stop was given; 0: none was
  std::function<void()> stop_listener_;
};

}  // namespace cobot_command::rviz_plugin
