// The panel "Cobot" of RViz: a robot, its stop, and the pages.
#pragma once

#include <memory>
#include <vector>

#include "clients/background_calls.h"
#include "clients/fleet.h"
#include "clients/robot.h"
#include "pages/page.h"
#include <rviz/panel.h>

class QLabel;
class QStackedWidget;
class QTimer;

namespace cobot_command::rviz_plugin {

class ElidedLabel;
class RobotBox;
class StopBar;

class CobotPanel : public rviz::Panel {
  Q_OBJECT
 public:
  explicit CobotPanel(QWidget* parent = nullptr);
  ~CobotPanel() override;

  void onInitialize() override;
  void load(const rviz::Config& config) override;
  void save(rviz::Config config) const override;

 private:
  void makePages();
  QWidget* makeHeader();
  QWidget* makeNavigation();
  /// Another robot, by its namespace.
  void choose(const QString& name);
  /// A button that was pressed for the robot before does nothing for another one when it is let go.
  void putUpButtons();
  /// A stop that waits for its node, or for its answer, is sent and told though another robot is chosen.
  void leave(std::unique_ptr<Robot> robot, const QString& name);
  void open(const Page& page);
  void look();
  void showConnection();
  /// What has to be done first, or what keeps the operator from stopping the robot.
  void showGuide();
  /// Beside the user interface, as a master may hang.
  void askForRobots();
  void offerRobots(const std::vector<std::string>& names);

  BackgroundCalls questions_;               ///< to the master
  std::unique_ptr<BackgroundCalls> calls_;  ///< to the robot: what hangs with one holds up no other
  std::unique_ptr<Robot> robot_;
  std::vector<std::unique_ptr<Robot>> left_;  ///< that are still to be stopped
  std::unique_ptr<Preview> preview_;
  std::unique_ptr<Target> target_;
  std::vector<Page*> pages_;  ///< the first one is Main
  Fleet fleet_;
  RobotBox* robots_;
  ElidedLabel* connection_;
  StopBar* stop_bar_;
  ElidedLabel* guide_;
  QLabel* title_;
  QStackedWidget* stack_;
  QTimer* timer_;
  QTimer* listening_;    ///< to the robot
  QString name_;         ///< of the robot that is commanded, from the root
  QString fault_;        ///< of a name that was entered
  int fault_looks_ = 0;  ///< so long it is shown
  int looks_ = 0;
  bool is_asking_ = false;
};

}  // namespace cobot_command::rviz_plugin
