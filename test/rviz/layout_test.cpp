// Where things are: what has to be at hand is, however small the window and however long a text.
#include <QLabel>
#include <QPushButton>
#include <QTest>
#include <QTextEdit>
#include <memory>
#include <vector>

#include "panel_fixture.h"
#include <OgreMovableObject.h>
#include <OgreSceneNode.h>
#include <gtest/gtest.h>
#include <ros/node_handle.h>
#include <rviz/display.h>
#include <rviz/display_group.h>
#include <rviz/visualization_frame.h>
#include <rviz/visualization_manager.h>
#include <sensor_msgs/JointState.h>

namespace cobot_command::test {
namespace {

constexpr const char* kWithCommands[] = {"connect",     "change_base",    "change_tcp",
                                         "interface",   "move_relative",  "move_absolute",
                                         "move_circle", "pick_and_place", "load_path"};

/// Gives the window back its size.
class WindowOf {
 public:
  explicit WindowOf(QSize size) : frame_(Panel::window->frame()), before_(frame_.size()) {
    frame_.resize(size);
    static_cast<void>(holdsSoon([&] { return frame_.size() == size; }));
  }
  WindowOf(const WindowOf&) = delete;
  WindowOf& operator=(const WindowOf&) = delete;
  ~WindowOf() { frame_.resize(before_); }

 private:
  QWidget& frame_;
  QSize before_;
};

TEST_F(Panel, hasItsButtonsAndHowACommandGoesInSightInASmallWindow) {
  // A small screen, and what RViz takes by itself.
  for (const QSize size : {QSize(1280, 720), QSize(1200, 846)}) {
    const WindowOf small(size);
    ASSERT_EQ(window->frame().size(), size) << "it needs more room";
    for (const char* page : kWithCommands) {
      at_panel.open(page);
      for (const char* part :
           {"stop", "pause", "resume", "execute", "cancel", "error_id", "busy", "done", "status_text"}) {
        EXPECT_TRUE(holdsSoon([&] { return at_panel.isInSight(part); }, 2)) << page << ": " << part;
      }
      at_panel.takePicture(QString("small_%1_%2").arg(size.height()).arg(page));
    }
    at_panel.open("jog");
    for (const char* part : {"jog_0_minus", "jog_5_plus", "cancel", "busy", "status_text"}) {
      EXPECT_TRUE(holdsSoon([&] { return at_panel.isInSight(part); }, 2)) << part;
    }
    at_panel.takePicture(QString("small_%1_jog").arg(size.height()));
  }
}

TEST_F(Panel, keepsItsButtonsWhereTheyAre) {
  at_panel.open("move_absolute");
  at_panel.click("preset");
  const QPoint before = at_panel.placeOf("execute");
  at_panel.tick("robot_pose_enable", true);
  at_panel.tick("blending_enable", true);
  QTest::qWait(50);
  EXPECT_EQ(at_panel.placeOf("execute"), before);
  at_panel.enter("target.2", 1050);
  at_panel.click("check");
  EXPECT_EQ(at_panel.outcome(), "error");
  EXPECT_EQ(at_panel.placeOf("execute"), before);
  at_panel.click("preset");
}

TEST_F(Panel, growsNoWiderThanItIsForAnyText) {
  QWidget& panel = window->panel();
  const QString long_text(255, 'W');
  at_panel.open("connect");
  at_panel.enter("host", long_text);
  QTest::qWait(200);
  const int needed = panel.minimumSizeHint().width();
  EXPECT_LE(needed, 470) << "as cobot.rviz has it";
  std::vector<std::pair<QWidget*, QString>> before;
  for (QLabel* label : panel.findChildren<QLabel*>()) {
    if (label->objectName().isEmpty() || label->objectName().startsWith("qt_")) continue;
    for (const char* fixed :
         {"busy", "checked", "done", "error", "aborted", "error_id", "command_id_ack", "title"}) {
      if (label->objectName() == fixed) label = nullptr;
      if (label == nullptr) break;
    }
    if (label == nullptr || label->objectName().startsWith("value_")) continue;
    before.emplace_back(label, label->text());
    label->setText(long_text);
  }
  for (QTextEdit* text : panel.findChildren<QTextEdit*>()) {
    before.emplace_back(text, text->toPlainText());
    text->setPlainText(long_text);
  }
  auto* stop = panel.findChild<QPushButton*>("stop");
  const QString name = stop->text();
  stop->setText("STOP /" + long_text);
  EXPECT_GE(before.size(), 6u);
  EXPECT_EQ(panel.minimumSizeHint().width(), needed);
  for (const auto& [widget, text] : before) {
    if (auto* label = qobject_cast<QLabel*>(widget)) label->setText(text);
    if (auto* edit = qobject_cast<QTextEdit*>(widget)) edit->setPlainText(text);
  }
  stop->setText(name);
  at_panel.click("preset");
}

/// So many things of a scene are to be seen.
int visibleIn(Ogre::SceneNode& node) {
  int count = 0;
  for (unsigned short i = 0; i < node.numAttachedObjects(); ++i) {
    count += node.getAttachedObject(i)->getVisible() ? 1 : 0;
  }
  for (unsigned short i = 0; i < node.numChildren(); ++i) {
    count += visibleIn(static_cast<Ogre::SceneNode&>(*node.getChild(i)));
  }
  return count;
}

TEST_F(Panel, showsNoArmBeforeItsJointsAreKnown) {
  rviz::DisplayGroup& displays = *window->rviz().getManager()->getRootDisplayGroup();
  rviz::Display* arm = displays.createDisplay("cobot_command/Arm");
  displays.addDisplay(arm);
  arm->initialize(window->rviz().getManager());
  arm->subProp("Joints")->setValue("/nobody/joint_states");
  arm->setEnabled(true);
  QTest::qWait(200);  // frames of RViz
  EXPECT_EQ(visibleIn(*arm->getSceneNode()), 0);
  ros::Publisher joints =
      ros::NodeHandle().advertise<sensor_msgs::JointState>("/nobody/joint_states", 1, true);
  sensor_msgs::JointState known;
  known.name = {"shoulder_1_joint", "shoulder_2_joint", "elbow_1_joint",
                "wrist_1_joint",    "wrist_2_joint",    "wrist_3_joint"};
  known.position = {0, 0, 1.57, 0, 1.57, 0};
  joints.publish(known);
  EXPECT_TRUE(holdsSoon([&] { return visibleIn(*arm->getSceneNode()) > 0; }));
  delete displays.takeDisplay(arm);
}

}  // namespace
}  // namespace cobot_command::test
