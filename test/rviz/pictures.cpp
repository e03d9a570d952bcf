// Makes the pictures of the pages: RViz beside a simulated robot, or a cell, at the moments that the pages
// speak of. Of scripts/pictures.
//
//     rviz_pictures robot FOLDER [option of RViz...]     the panel, and paths; connects the robot itself
//     rviz_pictures cell FOLDER [option of RViz...]      a zone that one robot holds and another one waits
//     for
#include <QApplication>
#include <QDir>
#include <QImage>
#include <QPixmap>
#include <QScreen>
#include <QSet>
#include <QTest>
#include <algorithm>
#include <fstream>
#include <iostream>
#include <stdexcept>
#include <string>

#include "operator.h"
#include "rviz_window.h"
#include <cobot_command/CellDistances.h>
#include <cobot_command/CellState.h>
#include <ros/node_handle.h>
#include <rviz/render_panel.h>
#include <rviz/visualization_frame.h>

namespace cobot_command::test {
namespace {

const QSize kWindow(1280, 720);  // a small screen: all that counts is to be seen there
constexpr int kFrame = 140;      // [ms] of the animation

void require(bool holds, const std::string& what) {
  if (!holds) throw std::runtime_error("the pictures cannot be made: " + what);
}

class Camera {
 public:
  Camera(RvizWindow& window, QString folder) : window_(window), folder_(std::move(folder)) {
    window_.frame().resize(kWindow);
    window_.frame().move(0, 0);
    QDir().mkpath(folder_ + "/frames");
    // A window that was just opened is black, and the splash screen lies over it.
    require(holdsSoon([this] { return isDrawn(); }, 60), "RViz draws nothing");
  }

  void takeAll(const QString& name) const { save(grab(window_.frame()), name); }
  void takeScene(const QString& name) const {
    QTest::qWait(500);  // RViz draws up to thirty times a second
    takeSceneNow(name);
  }
  void takeSceneNow(const QString& name) const { save(grab(scene()), name); }
  void takeFrame() { save(grab(window_.frame()), QString("frames/%1").arg(frames_++, 4, 10, QChar('0'))); }

 private:
  [[nodiscard]] QWidget& scene() const {
    auto* panel = window_.frame().findChild<rviz::RenderPanel*>();
    require(panel != nullptr, "RViz has no scene");
    return *panel;
  }

  static QPixmap grab(const QWidget& widget) {
    const QPoint corner = widget.mapToGlobal(QPoint(0, 0));
    return QApplication::primaryScreen()->grabWindow(0, corner.x(), corner.y(), widget.width(),
                                                     widget.height());
  }

  /// A scene has background and floor, and no robot before there are joints.
  [[nodiscard]] bool isDrawn() const {
    for (const QWidget* window : QApplication::topLevelWidgets()) {
      if (window->inherits("QSplashScreen") && window->isVisible()) return false;
    }
    const QImage image = grab(scene()).toImage();
    QSet<QRgb> colours;
    for (int x = 0; x < image.width(); x += 5) {
      for (int y = 0; y < image.height(); y += 5) colours.insert(image.pixel(x, y));
    }
    return colours.size() > 2 && colours.contains(qRgb(238, 240, 243));
  }

  void save(const QPixmap& picture, const QString& name) const {
    require(picture.save(folder_ + "/" + name + ".png"),
            "no file can be written in " + folder_.toStdString());
  }

  RvizWindow& window_;
  QString folder_;
  int frames_ = 0;
};

class Photographer {
 public:
  Photographer(RvizWindow& window, QString folder)
      : folder_(std::move(folder)), camera_(window, folder_), at_panel_(window.frame(), window.panel(), "") {}

  void takeAll() {
    connect();
    takeMoves();
    takeJog();
    takeCycle();
    takePaths();
  }

 private:
  void expect(const QString& outcome) const {
    const QString found = at_panel_.outcome(60);
    require(found == outcome, found.toStdString() + " in place of " + outcome.toStdString() + ": " +
                                  at_panel_.textOf("status_text").toStdString());
  }

  void connect() {
    at_panel_.open("connect");
    at_panel_.click("preset");
    at_panel_.click("execute");
    require(holdsSoon([this] { return at_panel_.link().startsWith("ready"); }), "the robot is not connected");
  }

  void shoot(const char* name) {
    QTest::qWait(700);  // what was asked of the command node is there, and drawn
    camera_.takeAll(name);
  }

  void takeMoves() {
    at_panel_.open("move_absolute");
    at_panel_.click("preset");
    at_panel_.click("check");
    expect("checked");
    shoot("panel-move-absolute");
    at_panel_.enter("speed_percent", 60);
    at_panel_.click("execute");
    expect("done");
    at_panel_.click("preset");
    at_panel_.enter("target.1", 200);
    for (int i = 0; i < 2; ++i) {
      QTest::qWait(500);
      at_panel_.click("configuration_next");
    }
    shoot("panel-ghost");
    at_panel_.click("preset");
    at_panel_.enter("target.2", 1050);
    at_panel_.click("check");
    expect("error");
    shoot("panel-refused");
    at_panel_.click("preset");
  }

  void takeJog() {
    at_panel_.open("jog");
    at_panel_.choose("mode", 1);
    at_panel_.tick("stepwise", true);
    at_panel_.enter("increment_mm", 60);
    at_panel_.click("jog_2_minus");
    QTest::qWait(400);
    camera_.takeAll("panel-jog");
    expect("done");
    at_panel_.tick("stepwise", false);
  }

  void takeCycle() {
    at_panel_.open("pick_and_place");
    at_panel_.click("preset");
    for (const char* move : {"edit_3", "edit_6"}) {
      at_panel_.click(move);
      at_panel_.enter("dwell", 0.5);
      at_panel_.click("back");
    }
    at_panel_.click("execute");
    require(holdsSoon([this] { return at_panel_.link().contains("moving"); }), "the cycle does not begin");
    while (at_panel_.isLit("busy")) {
      camera_.takeFrame();
      QTest::qWait(kFrame);
    }
    expect("done");
  }

  void takePaths() {
    at_panel_.open("load_path");
    at_panel_.click("preset");
    at_panel_.click("execute");
    require(holdsSoon([this] { return at_panel_.link().contains("moving"); }),
            "the path does not begin: " + at_panel_.textOf("status_text").toStdString());
    QTest::qWait(2500);
    camera_.takeScene("preview-driven");
    expect("done");
    const QString file = folder_ + "/refused.yaml";
    std::ofstream(file.toStdString()) << R"(points:
  - {interpolation_type: PTP, joints: [0, 0, 90, 0, 90, 0], termination_type: STOP, speed: 60, acceleration: 180, deceleration: 180}
  - {interpolation_type: CP_LINEAR, target_point_type: CARTESIAN, pose: [520, -120, 300, 180, 0, 90], speed: 100, acceleration: 400,
     deceleration: 400, orientation_speed: 30, orientation_acceleration: 100, orientation_deceleration: 100}
  - {interpolation_type: PTP, joints: [0, 20, 170, 0, 90, 0]}
)";
    at_panel_.enter("path_file", file);
    at_panel_.click("all_points");
    at_panel_.click("check");
    expect("error");
    camera_.takeScene("preview-refused");
  }

  QString folder_;
  Camera camera_;
  Operator at_panel_;
};

/// Zone Z1 when one robot holds it and another one waits for it, and both are as close as they come then.
void takeCell(RvizWindow& window, const QString& folder) {
  const Camera camera(window, folder);
  bool contended = false;
  double closest = 1e9;
  ros::NodeHandle node;
  const ros::Subscriber state = node.subscribe<cobot_command::CellState>(
      "/cell/state", 1, [&](const cobot_command::CellState::ConstPtr& told) {
        contended =
            std::any_of(told->zones.begin(), told->zones.end(), [](const cobot_command::CellZone& zone) {
              return zone.state == cobot_command::CellZone::HELD && !zone.waiting.empty();
            });
      });
  const ros::Subscriber distances = node.subscribe<cobot_command::CellDistances>(
      "/cell/distances", 1, [&](const cobot_command::CellDistances::ConstPtr& told) {
        for (const auto& pair : told->pairs) {
          if (!contended || !pair.known || pair.now >= closest) continue;
          closest = pair.now;
          camera.takeSceneNow("cell-monitor");
        }
      });
  require(holdsSoon([&] { return closest < 0.19; }, 120), "no robot waits for another one close by");
}

}  // namespace
}  // namespace cobot_command::test

int main(int argc, char** argv) {
  using namespace cobot_command::test;
  if (argc < 3 || (std::string(argv[1]) != "robot" && std::string(argv[1]) != "cell")) {
    std::cerr << "Usage: rviz_pictures robot|cell FOLDER [option of RViz...]\n";
    return 2;
  }
  try {
    const bool of_robot = std::string(argv[1]) == "robot";
    const QString folder = argv[2];
    argv[2] = argv[0];
    RvizWindow window(argc - 2, argv + 2, of_robot);
    if (of_robot) {
      Photographer(window, folder).takeAll();
    } else {
      takeCell(window, folder);
    }
  } catch (const std::exception& fault) {
    std::cerr << fault.what() << "\n";
    return 1;
  }
  return 0;
}
