#include "panel_fixture.h"

#include <QStringList>
#include <cstdlib>
#include <string>

namespace cobot_command::test {
namespace {

std::string picturesFolder() {
  const char* folder = std::getenv("COBOT_PICTURES");
  return folder == nullptr ? "" : folder;
}

}  // namespace

RvizWindow* Panel::window = nullptr;

Panel::Panel() : at_panel(window->frame(), window->panel(), picturesFolder()) {
  if (isReady()) return;
  at_panel.open("connect");
  at_panel.click("preset");
  at_panel.click("execute");
  EXPECT_TRUE(holdsSoon([this] { return isReady(); })) << at_panel.link().toStdString();
}

Panel::~Panel() {
  if (at_panel.robot() != "/") at_panel.chooseRobot("/");
}

void Panel::moveToPreset() {
  at_panel.open("move_absolute");
  at_panel.click("preset");
  at_panel.enter("speed_percent", 100);
  ASSERT_TRUE(holdsSoon([this] { return at_panel.isEnabled("execute"); })) << "its joints are not known yet";
  at_panel.click("execute");
  ASSERT_EQ(at_panel.outcome(), "done") << at_panel.textOf("status_text").toStdString();
}

void Panel::moveSlowly(double way) {
  ASSERT_NO_FATAL_FAILURE(moveToPreset());
  at_panel.open("move_relative");
  at_panel.click("preset");
  at_panel.choose("movement_command", 0);
  at_panel.choose("data_format", 3);
  at_panel.enter("target.1", way);
  at_panel.enter("speed_mm_s", 10);
  at_panel.click("execute");
  ASSERT_TRUE(holdsSoon([this] { return at_panel.link().contains("moving"); }));
}

}  // namespace cobot_command::test
