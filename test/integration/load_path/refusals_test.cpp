// What is refused before motion: by its number, the point and the joint, and not a byte of it on the wire.
#include <functional>
#include <string>

#include "path_goals.h"

namespace cobot_command::testing {
namespace {

using namespace blocks;
using path::PathPoint;

struct Recipe {
  int error_id;
  int index;
  int joint;
  std::function<void(LoadPathGoal&)> spoil;  ///< three points to joints, all right
};

/// Point 1, as it is or as a line 20 mm above the start.
Recipe point(int error_id, const std::function<void(PathPoint&)>& spoil, int joint = -1) {
  return {error_id, 1, joint, [spoil](LoadPathGoal& goal) { spoil(goal.path[1]); }};
}
Recipe line(int error_id, const std::function<void(PathPoint&)>& spoil, int joint = -1) {
  return point(
      error_id,
      [spoil](PathPoint& point) {
        point = pathLine({417.5, -122.3, 481.05, 180, 0, 90});
        spoil(point);
      },
      joint);
}

void ofTool(PathPoint& point, int id) {
  point.pose_type = static_cast<int>(path::MovedFrame::Tool);
  point.pose_id = id;
}
void inFrame(PathPoint& point, path::Reference type, int id) {
  point.ref_frame_type = static_cast<int>(type);
  point.ref_frame_id = id;
}
void blends(PathPoint& point, double tolerance) {
  point.termination_type = static_cast<int>(path::Termination::Blend);
  point.command_tolerance = tolerance;
}

/// Section 10 of the contract, its rows in their order.
std::vector<Recipe> recipes() {
  return {
      {1010, -1, -1, [](auto& g) { g.number_of_moves = 0; }},
      {1010, -1, -1,
       [](auto& g) {
         g.path.resize(20, g.path[0]);
         g.start_index = 15;
         g.number_of_moves = 6;
       }},
      {1012, -1, -1,
       [](auto& g) {
         g.path.resize(20, g.path[0]);
         g.start_index = 20;
         g.number_of_moves = 1;
       }},
      {1013, 0, -1, [](auto& g) { g.path[0].speed = 0; }},
      point(1014, [](auto& p) { p.acceleration_jerk = 101; }),
      line(1015, [](auto& p) { p.orientation_speed = 0; }),
      point(1017, [](auto& p) { p.move_type = 2; }),
      point(1018, [](auto& p) { p.target_type = 3; }),
      line(1020, [](auto& p) { p.interpolation = 4; }),
      line(1022, [](auto& p) { blends(p, -0.1); }),
      point(1023, [](auto& p) { blends(p, 100.1); }),
      point(1024, [](auto& p) { p.termination_type = 1; }),
      point(1025, [](auto& p) { p.profile_type = 4; }),
      point(1026, [](auto& p) { p.robot_configuration = 16; }),
      line(1027, [](auto& p) { p.pose_type = 0; }),
      line(1028, [](auto& p) { inFrame(p, static_cast<path::Reference>(3), 0); }),
      line(1029, [](auto& p) { ofTool(p, 16); }),
      line(1030, [](auto& p) { inFrame(p, path::Reference::User, -1); }),
      line(1031, [](auto& p) { ofTool(p, 7); }),
      line(1032, [](auto& p) { inFrame(p, path::Reference::User, 7); }),
      point(
          1033, [](auto& p) { p.joints[2] = 160; }, 2),
      line(1035,
           [](auto& p) {
             p.move_type = static_cast<int>(path::MoveType::Incremental);
             inFrame(p, path::Reference::User, 0);
           }),
      line(1037, [](auto& p) { p.pose[0] = kNan; }),
      line(1040, [](auto& p) { inFrame(p, path::Reference::World, 0); }),
      point(1044,
            [](auto& p) {
              p.target_type = static_cast<int>(path::TargetType::Cartesian);
              p.pose = {800, -122.3, 100, 180, 0, 90};
              p.robot_configuration = 13;
            }),
      {1045, 1, 4,
       [](auto& g) {
         g.path[0].joints = {0, 0, 90, 0, 0, 0};
         g.path[1] = pathLine({417.5, -122.3, 400, 90, 0, 90});
       }},
      line(1046, [](auto& p) { p.pose[0] = 2000; }),
      line(1048, [](auto& p) { p.robot_configuration = 13; }),
      point(
          1058, [](auto& p) { p.joints[7] = 1; }, 7),
      point(
          own_error::kJointSpeed,
          [](auto& p) {
            p.joints[0] = 120;
            p.speed = 200;
            p.acceleration = p.deceleration = 2000;
          },
          0),
      {1025, 1, -1,
       [](auto& g) {
         g.path[2].speed = -1;
         g.path[1].profile_type = 9;
       }},
  };
}

class LoadPathRefusals : public LoadPathCell {};

/// Oracle 22.
TEST_F(LoadPathRefusals, nameThePointAndSendNothing) {
  for (const Recipe& recipe : recipes()) {
    LoadPathGoal goal = good<LoadPathGoal>();
    recipe.spoil(goal);
    const Outcome& outcome = cell.endOf(cell.submit(goal));
    const auto& report = outcome.detail.as<PathReport>();
    const std::string said = std::to_string(recipe.error_id) + ": " + outcome.error_description;
    EXPECT_EQ(outcome.ending, Ending::Rejected) << said;
    EXPECT_EQ(outcome.error_id, recipe.error_id) << said;
    EXPECT_EQ(report.error_index, recipe.index) << said;
    EXPECT_EQ(report.error_joint, recipe.joint) << said;
    EXPECT_TRUE(cell.scripts().empty()) << said;
  }
}

}  // namespace
}  // namespace cobot_command::testing
