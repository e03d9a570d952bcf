// A chain without an end: sections behind each other, of which all that rests is taken out in between.
#include <random>
#include <string>
#include <utility>

#include "path_support.h"

#include "cobot_command/path/path_pieces.h"
#include "cobot_command/path/pvt_block.h"

namespace cobot_command::path {
namespace {

using std::chrono::milliseconds;

class PathChains : public Paths {
 protected:
  /// Ten points up and down, of which some stop, and one does not move.
  [[nodiscard]] std::vector<PathPoint> tenPoints() const {
    std::vector<PathPoint> points;
    arm::ControllerPose pose = flangeAt(scene.start);
    for (int i = 0; i < 10; ++i) {
      if (i != 6) pose[i % 4 < 2 ? 1 : 2] += 20;
      points.push_back(blending(toPose(pose), 3));
    }
    points[3].termination_type = number(Termination::Stop);
    points[8] = incremental(toJoints({3, 1, 0, 0, 0, 5}));
    return points;
  }
  static void append(PathPlanner& planner, const std::vector<PathPoint>& points, int first, int count) {
    PathSection section = sectionOf(points);
    section.start_index = first;
    section.number_of_moves = count;
    const auto refusal = planner.append(section);
    ASSERT_FALSE(refusal) << refusal->found;
  }
  [[nodiscard]] std::string linesOf(const PathPlan& plan) const {
    std::string lines;
    const auto pieces = piecesOf(plan, scene);
    EXPECT_TRUE(pieces) << pieces.error().found;
    for (const PathPiece& piece : *pieces) lines += script::toText(scriptOf(piece.block, {})) + "\n";
    return lines;
  }
  /// What the arm does in one part after the other.
  static void expectSame(const PathPlan& whole, const std::vector<PathPlan>& parts) {
    Duration begin{};
    std::size_t point = 0;
    for (const PathPlan& part : parts) {
      for (const PlannedPoint& one : part.points()) {
        ASSERT_EQ(one.start + begin, whole.points().at(point).start) << point;
        ASSERT_EQ(one.index, whole.points()[point].index);
        ++point;
      }
      for (Duration time{}; time < part.duration(); time += milliseconds(1)) {
        ASSERT_EQ(part.at(time).position, whole.at(begin + time).position) << toSeconds(begin + time);
        ASSERT_EQ(part.at(time).velocity, whole.at(begin + time).velocity) << toSeconds(begin + time);
      }
      begin += part.duration();
    }
    ASSERT_EQ(begin, whole.duration());
    ASSERT_EQ(point, whole.points().size());
  }
};

TEST_F(PathChains, areTheSameInOneGoalAndInSeveralOfWhichTheRestedPartsAreTakenOut) {
  const std::vector<PathPoint> points = tenPoints();
  const PathPlan whole = planned(points);
  const std::string lines = linesOf(whole);
  for (const int size : {10, 5, 1}) {
    PathPlanner planner(scene);
    std::vector<PathPlan> parts;
    std::string part_lines;
    for (int first = 0; first < 10; first += size) {
      append(planner, points, first, size);
      parts.push_back(planner.takeRested());
      part_lines += linesOf(parts.back());
      if (planner.plan().duration() > Duration::zero()) {
        EXPECT_EQ(planner.plan().points().front().start, Duration::zero());
      }
    }
    planner.closeEnd();
    parts.push_back(planner.takeRested());
    part_lines += linesOf(parts.back());
    expectSame(whole, parts);
    EXPECT_EQ(part_lines, lines) << size;
  }
}

TEST_F(PathChains, areTheSameWhereverTheyAreCutAndWhateverIsTakenOut) {
  std::mt19937 engine(4711);
  const auto any = [&](int last) { return std::uniform_int_distribution<int>(0, last)(engine); };
  for (int run = 0; run < 20; ++run) {
    std::vector<PathPoint> points;
    for (int i = 0; i < 12; ++i) {
      PathPoint point = incremental(toPose({0, 10.0 * any(3) - 12, 10.0 * any(3) - 12, 0, 0, 0}));
      point.termination_type = number(any(3) == 0 ? Termination::Stop : Termination::Blend);
      point.command_tolerance = any(6);
      point.acceleration_jerk = point.deceleration_jerk = run % 2 == 0 ? 0 : 20.0 + 20.0 * any(4);
      points.push_back(point);
    }
    const PathPlan whole = planned(points);
    PathPlanner planner(scene);
    std::vector<PathPlan> parts;
    for (int first = 0; first < 12;) {
      const int size = std::min(12 - first, 1 + any(4));
      append(planner, points, first, size);
      if (any(1) == 0) parts.push_back(planner.takeRested());
      first += size;
    }
    planner.closeEnd();
    parts.push_back(planner.takeRested());
    EXPECT_TRUE(planner.plan().points().empty());
    expectSame(whole, parts);
  }
}

TEST_F(PathChains, keepWhatMayBlendWithTheNextSection) {
  PathPlanner planner(scene);
  const auto points = tenPoints();
  append(planner, points, 0, 3);
  EXPECT_TRUE(planner.takeRested().points().empty()) << "all of it blends on";
  EXPECT_EQ(planner.plan().points().size(), 3U);
  append(planner, points, 3, 3);
  EXPECT_EQ(planner.takeRested().points().size(), 4U);
  EXPECT_EQ(planner.plan().points().size(), 2U);
  EXPECT_TRUE(planner.takeRested().points().empty());
  append(planner, points, 6, 1);
  const PathPlan rested = planner.takeRested();
  EXPECT_EQ(rested.points().size(), 3U) << "a move without a way ends a chain of blends";
  EXPECT_TRUE(planner.plan().points().empty());
  EXPECT_EQ(planner.plan().at({}).position, endOf(rested));
}

TEST_F(PathChains, countATolerance0AsAStop) {
  PathPlanner planner(scene);
  ASSERT_FALSE(planner.append(sectionOf({blending(toJoints({20, 0, 90, 0, 90, 0}), 0)})));
  EXPECT_EQ(planner.takeRested().points().size(), 1U);
}

TEST_F(PathChains, whoseEndIsClosedGoOnFromRest) {
  PathPlanner planner(scene);
  const auto points = tenPoints();
  append(planner, points, 0, 2);
  planner.closeEnd();
  PathPlanner taken = planner;
  append(planner, points, 2, 1);
  EXPECT_EQ(planner.plan().points()[1].overlap, Duration::zero());
  EXPECT_TRUE(planner.plan().points()[1].losesBlend());
  EXPECT_FALSE(planner.plan().points()[0].losesBlend());

  const PathPlan rested = taken.takeRested();
  ASSERT_EQ(rested.points().size(), 2U);
  EXPECT_TRUE(rested.points()[1].losesBlend());
  append(taken, points, 2, 1);
  EXPECT_EQ(taken.plan().points()[0].start, Duration::zero());
  EXPECT_EQ(taken.plan().at({}).position, endOf(rested));
  EXPECT_EQ(endOf(taken.plan()), endOf(planner.plan()));
}

TEST_F(PathChains, areClosedOnlyBeforeTheNextSection) {
  PathPlanner planner(scene);
  const auto points = tenPoints();
  append(planner, points, 0, 1);
  planner.closeEnd();
  EXPECT_TRUE(planner.append(sectionOf({toJoints({0, 0, 170, 0, 90, 0})}))) << "a refusal opens nothing";
  append(planner, points, 1, 1);
  append(planner, points, 2, 1);
  EXPECT_EQ(planner.plan().points()[0].overlap, Duration::zero());
  EXPECT_GT(planner.plan().points()[1].overlap, Duration::zero());
}

TEST_F(PathChains, stayAsLargeAsWhatIsOpen) {
  PathPlanner planner(scene);
  for (int i = 0; i < 200; ++i) {
    const double y = i % 2 == 0 ? 15 : -15;
    PathPoint to = incremental(toPose({0, y, 0, 0, 0, 0}));
    ASSERT_FALSE(planner.append(sectionOf({blending(to, 2), to, blending(to, 2)})));
    EXPECT_EQ(planner.takeRested().points().size(), i == 0 ? 2U : 3U);
    EXPECT_EQ(planner.plan().points().size(), 1U);
    EXPECT_LT(planner.plan().duration(), std::chrono::seconds(1));
  }
}

TEST_F(PathChains, addIncrementsToWhatWasTakenOut) {
  PathPlanner planner(scene);
  const arm::ControllerPose from = flangeAt(scene.start);
  arm::ControllerPose pose = from;
  pose[1] += 30;
  ASSERT_FALSE(planner.append(sectionOf({toPose(pose)})));
  EXPECT_EQ(planner.takeRested().points().size(), 1U);
  ASSERT_FALSE(planner.append(sectionOf({incremental(toPose({0, 0, -20, 0, 0, 0}))})));
  pose[2] -= 20;
  const arm::ControllerPose found = flangeAt(endOf(planner.plan()));
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(found.at(i), pose.at(i), 1e-6);
}

TEST_F(PathChains, addIncrementsToWhereTheArmIsWhenTheWorldHasMoved) {
  scene.world = arm::Pose::Identity();
  PathPlanner planner(scene);
  arm::ControllerPose pose = flangeAt(scene.start);
  pose[1] += 30;
  const auto in_world = [](PathPoint point) {
    point.ref_frame_type = number(Reference::World);
    return point;
  };
  ASSERT_FALSE(planner.append(sectionOf({in_world(toPose(pose))})));
  PathScene moved = scene;
  moved.world = arm::toPose({0, 500, 0, 0, 0, 0});
  planner.setScene(moved);
  const auto refusal = planner.append(sectionOf({in_world(incremental(toPose({0, 0, -20, 0, 0, 0})))}));
  ASSERT_FALSE(refusal) << refusal->found;
  pose[2] -= 20;
  const arm::ControllerPose found = flangeAt(endOf(planner.plan()));
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(found.at(i), pose.at(i), 1e-6);
}

TEST_F(PathChains, takeTheSceneOfEachSection) {
  PathPlanner planner(scene);
  PathPoint to = incremental(toPose({0, 100, 0, 0, 0, 0}));
  ASSERT_FALSE(planner.append(sectionOf({blending(to, 10)})));
  const Duration full = planner.plan().duration();

  PathScene slow = scene;
  slow.feedrate = 0.5;
  slow.start = degrees(90, 0, 90, 0, 90, 0);  // not looked at: the path goes on from its end
  tables::Entries entries;
  entries.frames[3] = tables::Frame{"", arm::toPose({100, 0, 0, 0, 0, 0})};
  slow.tables = *tables::DataTables::of(entries, {});
  slow.world = arm::toPose({0, 0, -500, 0, 0, 0});
  planner.setScene(slow);
  ASSERT_FALSE(planner.append(sectionOf({blending(to, 10)})));
  ASSERT_EQ(planner.plan().points().size(), 2U);
  EXPECT_GT(planner.plan().points()[0].overlap, Duration::zero());
  EXPECT_EQ(planner.plan().points()[0].feedrate, 1.0);
  EXPECT_EQ(planner.plan().points()[1].feedrate, 0.5);
  EXPECT_NEAR(toSeconds(planner.plan().points()[1].motion->duration()), 2 * toSeconds(full), 2 * kGrid);

  arm::ControllerPose pose = flangeAt(endOf(planner.plan()));
  const arm::ControllerPose there = pose;
  pose[0] -= 100;
  pose[1] += 10;
  PathPoint in_frame = toPose(pose);
  in_frame.ref_frame_type = number(Reference::User);
  in_frame.ref_frame_id = 3;
  pose = there;
  pose[1] += 20;
  pose[2] += 500;
  PathPoint in_world = toPose(pose);
  in_world.ref_frame_type = number(Reference::World);
  EXPECT_EQ(planner.takeRested().points().size(), 0U);
  const auto refusal = planner.append(sectionOf({in_frame, in_world}));
  ASSERT_FALSE(refusal) << refusal->found;
  EXPECT_NEAR(flangeAt(endOf(planner.plan()))[1], there[1] + 20, 1e-6);
  EXPECT_NEAR(flangeAt(endOf(planner.plan()))[2], there[2], 1e-6);

  planner.setScene(scene);
  EXPECT_EQ(planner.append(sectionOf({in_frame}))->error_id, path_error::kFrameNotConfigured);
  EXPECT_EQ(planner.append(sectionOf({in_world}))->error_id, path_error::kWorldUnknown);
}

}  // namespace
}  // namespace cobot_command::path
