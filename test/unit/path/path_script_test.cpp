// A path as motions of a script: what is sent, and what cannot be said.
#include "cobot_command/path/path_script.h"

#include "path_support.h"
#include <gmock/gmock.h>

namespace cobot_command::path {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::StartsWith;

class PathScripts : public Paths {
 protected:
  [[nodiscard]] std::vector<PointScript> scripts(const std::vector<PathPoint>& points) const {
    auto made = scriptOf(planned(points), 0, scene, {arm::Pose::Identity(), arm::Pose::Identity()});
    EXPECT_TRUE(made) << made.error().found;
    return made.value_or(std::vector<PointScript>());
  }
  [[nodiscard]] std::string only(const PathPoint& point) const {
    return script::toText(scripts({point}).at(0).lines);
  }
  [[nodiscard]] std::vector<std::string> toldOf(const PathPoint& point) const {
    return scripts({point}).at(0).approximations;
  }
  /// Nothing of it has to be rounded.
  [[nodiscard]] PathPoint quarterTurn() const {
    PathPoint point = toJoints({90, 0, 90, 0, 90, 0});
    point.speed = 90;
    point.acceleration = point.deceleration = 180;
    return point;
  }
  /// 40 mm sideways, in the robot base.
  [[nodiscard]] PathPoint aside() const {
    arm::ControllerPose pose = flangeAt(scene.start);
    pose[1] += 40;
    return toPose(pose);
  }
};

TEST_F(PathScripts, sayAPtpInPercentOfTheRatedSpeedAndMilliseconds) {
  EXPECT_EQ(only(quarterTurn()), "PTP(\"JPP\",90,0,90,0,90,0,50,500,0,false)");
  EXPECT_THAT(toldOf(quarterTurn()), IsEmpty());
}

TEST_F(PathScripts, roundTheSpeedDownAndTheRampUp) {
  PathPoint point = quarterTurn();
  point.speed = 50;
  point.acceleration = point.deceleration = 100;
  EXPECT_THAT(only(point), HasSubstr(",27,500,0,false)"));
  EXPECT_THAT(toldOf(point), ElementsAre(StartsWith("point 0: 27.7778 % of the rated speed")));
  point.acceleration = point.deceleration = 3000;
  EXPECT_THAT(only(point), HasSubstr(",27,150,0,false)"));
}

TEST_F(PathScripts, tellWhatNoMotionCanSay) {
  PathPoint point = quarterTurn();
  point.profile_type = number(ProfileType::ModSine);
  point.acceleration_jerk = 100;
  point.deceleration = 90;
  EXPECT_THAT(toldOf(point), ElementsAre("point 0: profile MOD_SINE with a jerk of 100 %",
                                         "point 0: deceleration 90 with acceleration 180"));
}

TEST_F(PathScripts, goByTheFeedrate) {
  scene.feedrate = 0.5;
  EXPECT_THAT(only(quarterTurn()), HasSubstr(",25,1000,0,false)"));
}

TEST_F(PathScripts, sayALineInMillimetresASecondWithItsRadius) {
  PathPoint second = aside();
  second.pose[2] += 40;
  const auto made = scripts({blending(aside(), 5), second});
  EXPECT_THAT(script::toText(made[0].lines), StartsWith("Line(\"CAR\",517.5,"));
  EXPECT_THAT(script::toText(made[0].lines), HasSubstr(",100,200,5,false)"));
  EXPECT_THAT(made[0].approximations, IsEmpty());
  EXPECT_THAT(script::toText(made[1].lines), HasSubstr("Line(\"CAP\""));
}

TEST_F(PathScripts, tellThatTheyCannotSayHowFastALineTurns) {
  PathPoint point = aside();
  point.pose[5] += 30;
  EXPECT_THAT(toldOf(point), ElementsAre("point 0: speed and acceleration of the turn"));
}

TEST_F(PathScripts, sayAToleranceOfAPtpInPercentOfTheRamps) {
  PathPoint second = quarterTurn();
  second.joints[0] = 0;
  const auto made = scripts({blending(quarterTurn(), 5), second});
  EXPECT_THAT(script::toText(made[0].lines), ::testing::MatchesRegex(".*,50,500,[0-9]+,false\\)"));
  EXPECT_THAT(made[0].approximations, ElementsAre(HasSubstr("a tolerance of 5 % of the path, sent as")));
}

TEST_F(PathScripts, sayNoNumberThatTheControllerRefuses) {
  PathPoint short_turn = toJoints({3, 0, 90, 0, 90, 0});
  short_turn.speed = 360;
  EXPECT_THAT(only(short_turn), HasSubstr(",100,"));
  EXPECT_THAT(toldOf(short_turn), ::testing::Contains(HasSubstr("200 % of the rated speed")));
  PathPoint line = aside();
  line.speed = 1e12;
  line.acceleration = line.deceleration = 2000;
  EXPECT_THAT(only(line), HasSubstr(",4500,"));
  EXPECT_THAT(toldOf(line), ::testing::Contains(HasSubstr("mm/s")));
}

TEST_F(PathScripts, areSlowerWhereTheRampIsTooLongToSay) {
  PathPoint line = aside();
  line.acceleration = line.deceleration = 1;
  EXPECT_THAT(only(line), HasSubstr(",9,9"));
  EXPECT_THAT(toldOf(line), ::testing::Contains(HasSubstr("at most 9999 ms")));
}

TEST_F(PathScripts, stopWhereTheToleranceIsBelowAMillimetre) {
  PathPoint second = aside();
  second.pose[2] += 40;
  PathPoint first = blending(aside(), 0.7);
  first.acceleration = first.deceleration = 100;
  const auto made = scripts({first, second});
  EXPECT_THAT(script::toText(made[0].lines), StartsWith("Line(\"CAP\""));
  EXPECT_THAT(made[0].approximations, ::testing::Contains(HasSubstr("below 1 mm it is a stop")));
}

TEST_F(PathScripts, sayTheBlendOfALastPointForWhatComesBehind) {
  EXPECT_THAT(only(blending(aside(), 5)), StartsWith("Line(\"CAR\""));
  EXPECT_THAT(only(blending(aside(), 5)), HasSubstr(",5,false)"));
  EXPECT_THAT(only(blending(quarterTurn(), 100)), HasSubstr(",50,500,100,false)"));
}

TEST_F(PathScripts, goByTheFeedrateThatEachPointWasPlannedWith) {
  PathPlanner planner(scene);
  ASSERT_FALSE(planner.append(sectionOf({quarterTurn()})));
  PathScene slower = scene;
  slower.feedrate = 0.5;
  planner.setScene(slower);
  PathPoint back = quarterTurn();
  back.joints[0] = 0;
  ASSERT_FALSE(planner.append(sectionOf({back})));
  const auto made = scriptOf(planner.plan(), 0, planner.scene(), {});
  ASSERT_TRUE(made);
  EXPECT_THAT(script::toText((*made)[0].lines), HasSubstr(",50,500,"));
  EXPECT_THAT(script::toText((*made)[1].lines), HasSubstr(",25,1000,"));
}

TEST_F(PathScripts, sayAPoseWithThePostureItWasPlannedIn) {
  PathPoint point = aside();
  point.interpolation = number(Interpolation::Ptp);
  point.speed = 18;
  point.acceleration = point.deceleration = 36;
  EXPECT_THAT(only(point), HasSubstr("PTP(\"CPP\",517.5,"));
  EXPECT_THAT(only(point), HasSubstr(",false,0,2,4)"));
}

TEST_F(PathScripts, sayAnArcByItsPoint) {
  PathPoint arc = aside();
  arc.interpolation = number(Interpolation::Circular);
  arc.via_pose = flangeAt(scene.start);
  arc.via_pose[0] -= 20;
  arc.via_pose[1] += 20;
  EXPECT_THAT(only(arc), StartsWith("Circle(\"CAP\",497.5,"));
}

TEST_F(PathScripts, setBaseAndTcpInFrontOfPosesWhereOthersAreActive) {
  tables::Entries entries;
  entries.tools[1] = tables::Tool{"", arm::toPose({0, 0, 150, 0, 0, 0}), 0};
  scene.tables = *tables::DataTables::of(entries, {});
  PathPoint point = aside();
  point.pose[2] -= 150;
  point.pose_type = number(MovedFrame::Tool);
  point.pose_id = 1;
  const auto made =
      scriptOf(planned({quarterTurn(), toJoints({0, 0, 90, 0, 90, 0}), point, point}), 0, scene, {});
  ASSERT_TRUE(made);
  EXPECT_THAT(script::toText((*made)[0].lines), StartsWith("PTP("));
  EXPECT_THAT(script::toText((*made)[2].lines),
              StartsWith("ChangeBase(\"RobotBase\")\r\nChangeTCP(0,0,150,0,0,0)\r\nLine("));
  EXPECT_THAT(script::toText((*made)[3].lines), StartsWith("Line("));
}

TEST_F(PathScripts, cannotSayAWristMove) {
  const auto made =
      scriptOf(planned({quarterTurn(), toJoints({90, 0, 80, 0, 70, 0}, Interpolation::Wrist)}), 0, scene, {});
  ASSERT_FALSE(made);
  EXPECT_EQ(made.error().error_id, path_error::kNotInAScript);
  EXPECT_EQ(made.error().index, 1);
}

}  // namespace
}  // namespace cobot_command::path
