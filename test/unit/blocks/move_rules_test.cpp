// Each move's own rules: movements and formats, robot pose, targets, arc; and the exact script text.

#include "block_goals.h"
#include <gtest/gtest.h>

namespace cobot_command::testing {
namespace {

using namespace blocks;

template <class Goal>
Goal moving(Movement movement, int format) {
  return with<Goal>([&](auto& g) {
    g.movement_command = static_cast<int>(movement);
    g.data_format = format;
  });
}

template <class Goal>
void expectTargetChecks(SixValues Goal::*target) {
  for (std::size_t i = 0; i < 6; ++i) {
    const auto coordinate = [&](double value) {
      return errorWith<Goal>([&](auto& g) { (g.*target)[i] = value; });
    };
    for (const double value : {100000.0, -100000.0, 0.0, -0.0}) EXPECT_EQ(coordinate(value), 0) << value;
    for (const double value : {1e308, 100000.001, -100000.001}) {
      EXPECT_EQ(coordinate(value), own_error::kCoordinateRange) << value;
    }
    for (const double value : {kNan, kInf, -kInf}) EXPECT_EQ(coordinate(value), own_error::kNotFinite);
  }
}

// --- MoveAbsolute

TEST(MoveAbsoluteRules, refuseFormatsThatTheMovementDoesNotHave) {
  const auto error = [](Movement movement, int format) {
    return errorOf(moving<MoveAbsoluteGoal>(movement, format));
  };
  for (const int format : {0, 1}) EXPECT_EQ(error(Movement::Ptp, format), 0) << format;
  for (const int format : {-1, 2, 3, 4, 5, 99, std::numeric_limits<int>::min()}) {
    EXPECT_EQ(error(Movement::Ptp, format), motion_error::kFormatForPtp) << format;
  }
  for (const int format : {1, 2, 3, 4}) EXPECT_EQ(error(Movement::Line, format), 0) << format;
  for (const int format : {-1, 0, 5, 99, std::numeric_limits<int>::max()}) {
    EXPECT_EQ(error(Movement::Line, format), motion_error::kFormatForLine) << format;
  }
  for (const int movement : {-1, 2, 99}) {
    EXPECT_EQ(error(static_cast<Movement>(movement), 1), own_error::kMovementUnknown) << movement;
  }
}

TEST(MoveAbsoluteRules, sayWhichFormatWasFoundAndWhichThereAre) {
  EXPECT_EQ(check(moving<MoveAbsoluteGoal>(Movement::Ptp, 7)).front().found,
            "data_format is 7 (JPP 0, CPP 1, CPR 2, CAP 3, CAR 4)");
}

TEST(MoveAbsoluteRules, checkTheRobotPoseWhereItIsEnabled) {
  const auto pose = [](std::array<int, 3> bits) {
    return errorWith<MoveAbsoluteGoal>([&](auto& g) {
      g.robot_pose_enable = true;
      g.robot_pose = bits;
    });
  };
  for (const int c1 : {0, 1}) {
    for (const int c2 : {2, 3}) {
      for (const int c3 : {4, 5}) EXPECT_EQ(pose({c1, c2, c3}), 0);
    }
  }
  for (const int bad : {-1, 2}) EXPECT_EQ(pose({bad, 2, 4}), motion_error::kPose1Range);
  for (const int bad : {1, 4}) EXPECT_EQ(pose({0, bad, 4}), motion_error::kPose2Range);
  for (const int bad : {3, 6}) EXPECT_EQ(pose({0, 2, bad}), motion_error::kPose3Range);
  EXPECT_EQ(errorWith<MoveAbsoluteGoal>([](auto& g) { g.robot_pose = {7, 7, 7}; }), 0) << "not enabled";
}

TEST(MoveAbsoluteRules, refuseARobotPoseWhereThereIsNone) {
  auto line = moving<MoveAbsoluteGoal>(Movement::Line, 1);
  line.robot_pose_enable = true;
  EXPECT_EQ(errorOf(line), motion_error::kPoseWithLine);
  auto joints = moving<MoveAbsoluteGoal>(Movement::Ptp, 0);
  joints.robot_pose_enable = true;
  EXPECT_EQ(errorOf(joints), own_error::kPoseWithJoints);
}

TEST(MoveAbsoluteRules, refuseTargetsThatAreNoNumbersOrAbsurd) {
  expectTargetChecks(&MoveAbsoluteGoal::target);
}

TEST(MoveAbsoluteRules, refuseAPoseAsTargetInJoints) {
  auto goal = moving<MoveAbsoluteGoal>(Movement::Ptp, 0);
  goal.target_pose = framedPose();
  EXPECT_EQ(idsOf(goal), std::vector<int>{own_error::kPoseNeedsCartesian});
  goal.data_format = 1;
  EXPECT_EQ(errorOf(goal), 0);
}

TEST(MoveAbsoluteRules, giveTheScriptOfEachMovementAndFormat) {
  EXPECT_EQ(scriptOf(good<MoveAbsoluteGoal>()), "PTP(\"CPP\",417.5,-122.3,343.9,180,0,90,10,200,0,false)");
  auto joints = moving<MoveAbsoluteGoal>(Movement::Ptp, 0);
  joints.target = {0.001, -0.125, 90.4567, 0, 90, -179.999};
  EXPECT_EQ(scriptOf(joints), "PTP(\"JPP\",0.001,-0.125,90.4567,0,90,-179.999,10,200,0,false)");
  const char* const names[] = {"", "CPP", "CPR", "CAP", "CAR"};
  for (const int format : {1, 2, 3, 4}) {
    auto line = moving<MoveAbsoluteGoal>(Movement::Line, format);
    line.speed = 100;
    line.blending_enable = true;
    line.blending_value = 50;
    EXPECT_EQ(scriptOf(line),
              std::string("Line(\"") + names[format] + "\",417.5,-122.3,343.9,180,0,90,100,200,50,false)");
  }
}

TEST(MoveAbsoluteRules, sendTheRobotPoseOfAPtp) {
  const auto goal = with<MoveAbsoluteGoal>([](auto& g) {
    g.robot_pose_enable = true;
    g.robot_pose = {1, 3, 5};
  });
  EXPECT_EQ(scriptOf(goal), "PTP(\"CPP\",417.5,-122.3,343.9,180,0,90,10,200,0,false,1,3,5)");
}

// --- MoveRelative

TEST(MoveRelativeRules, refuseFormatsThatTheMovementDoesNotHave) {
  const auto error = [](Movement movement, int format) {
    return errorOf(moving<MoveRelativeGoal>(movement, format));
  };
  for (const int format : {0, 1, 5}) EXPECT_EQ(error(Movement::Ptp, format), 0) << format;
  for (const int format : {-1, 2, 3, 4, 6, 7, 8, 9, 99}) {
    EXPECT_EQ(error(Movement::Ptp, format), relative_error::kFormatForPtp) << format;
  }
  for (const int format : {1, 2, 3, 4, 5, 6, 7, 8}) EXPECT_EQ(error(Movement::Line, format), 0) << format;
  for (const int format : {-1, 0, 9, 99}) {
    EXPECT_EQ(error(Movement::Line, format), relative_error::kFormatForLine) << format;
  }
  for (const int movement : {-1, 2}) {
    EXPECT_EQ(error(static_cast<Movement>(movement), 1), own_error::kMovementUnknown) << movement;
  }
}

TEST(MoveRelativeRules, refuseOffsetsThatAreNoNumbersOrAbsurd) {
  expectTargetChecks(&MoveRelativeGoal::target);
}

TEST(MoveRelativeRules, giveTheScriptOfEachMovementAndFormat) {
  const char* const names[] = {"JPP", "CPP", "CPR", "CAP", "CAR", "TPP", "TPR", "TAP", "TAR"};
  for (const int format : {0, 1, 5}) {
    EXPECT_EQ(scriptOf(moving<MoveRelativeGoal>(Movement::Ptp, format)),
              std::string("Move_PTP(\"") + names[format] + "\",0,0,10,45,0,0,10,200,0,false)");
  }
  for (const int format : {1, 2, 3, 4, 5, 6, 7, 8}) {
    EXPECT_EQ(scriptOf(moving<MoveRelativeGoal>(Movement::Line, format)),
              std::string("Move_Line(\"") + names[format] + "\",0,0,10,45,0,0,10,200,0,false)");
  }
}

// --- MoveCircle

TEST(MoveCircleRules, takeTwoFormatsAndNoOthers) {
  for (const int format : {0, 1}) {
    EXPECT_EQ(errorWith<MoveCircleGoal>([&](auto& g) { g.data_format = format; }), 0);
  }
  for (const int format : {-1, 2, 99}) {
    EXPECT_EQ(errorWith<MoveCircleGoal>([&](auto& g) { g.data_format = format; }),
              own_error::kFormatForCircle);
  }
}

TEST(MoveCircleRules, refusePointsThatAreNoNumbersOrAbsurd) {
  expectTargetChecks(&MoveCircleGoal::arc_point);
  expectTargetChecks(&MoveCircleGoal::end_point);
  const auto failures = check(with<MoveCircleGoal>([](auto& g) { g.end_point[2] = kNan; }));
  EXPECT_EQ(failures.front().found, "coordinate 3 of end_point is nan");
}

TEST(MoveCircleRules, takeArcsOfUpToOneTurn) {
  const auto arc = [](double value) {
    return errorWith<MoveCircleGoal>([&](auto& g) { g.arc_angle = value; });
  };
  for (const double value : {0.0, -0.0, 0.001, 270.0, 360.0}) EXPECT_EQ(arc(value), 0) << value;
  for (const double value : {-0.001, 360.001, kNan, kInf, -kInf}) {
    EXPECT_EQ(arc(value), own_error::kArcAngleRange) << value;
  }
}

TEST(MoveCircleRules, sendWholeDegreesAndNeverZeroForAnArc) {
  const auto angle = [](double value) {
    const std::string text = scriptOf(with<MoveCircleGoal>([&](auto& g) { g.arc_angle = value; }));
    const std::size_t begin = text.find(",0,", text.find(",200,")) + 3;
    return text.substr(begin, text.rfind(',') - begin);
  };
  EXPECT_EQ(angle(0), "0");
  EXPECT_EQ(angle(1e-9), "1") << "0 would mean: to the end point";
  EXPECT_EQ(angle(0.4), "1");
  EXPECT_EQ(angle(89.5), "90");
  EXPECT_EQ(angle(359.6), "360");
  EXPECT_EQ(angle(360), "360");
}

TEST(MoveCircleRules, giveTheScriptOfEachFormat) {
  EXPECT_EQ(scriptOf(good<MoveCircleGoal>()),
            "Circle(\"CPP\",417.5,-122.3,343.9,180,0,90,381.7,208.74,343.9,180,0,135,10,200,0,0,false)");
  const auto goal = with<MoveCircleGoal>([](auto& g) {
    g.data_format = static_cast<int>(CircleFormat::Cap);
    g.speed = 100;
    g.blending_enable = true;
    g.blending_value = 50;
    g.arc_angle = 270;
  });
  EXPECT_EQ(scriptOf(goal),
            "Circle(\"CAP\",417.5,-122.3,343.9,180,0,90,381.7,208.74,343.9,180,0,135,100,200,50,270,false)");
}

}  // namespace
}  // namespace cobot_command::testing
