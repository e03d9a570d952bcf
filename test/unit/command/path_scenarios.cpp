// How paths fail: by their points and plans, because of the robot, and on the wire.

#include <cstddef>
#include <functional>
#include <string>

#include "block_goals.h"
#include "catalogue_scenarios.h"
#include "core_rig.h"
#include "status_frames.h"
#include "wire_faults.h"

namespace cobot_command::testing {
namespace {

using namespace blocks;
using namespace command;
using path::PathPoint;
using protocol::TagState;

constexpr arm::ControllerPose kStart{417.5, -122.3, 461.05, 180, 0, 90};  // of the flange, in StatusFrames

Row row(int id) {
  return {kBlock<LoadPathGoal>, id};
}

arm::ControllerPose above(double z) {
  arm::ControllerPose pose = kStart;
  pose[2] += z;
  return pose;
}

/// Connected to a robot that stands at `frame`.
struct Ready : CoreRig {
  explicit Ready(const StatusFrames& frame = StatusFrames(), Planning planning = Planning::AtOnce)
      : CoreRig(*arm::ArmModel::named("tm5-900"), link::LinkSettings{}, planning) {
    connect();
    status(frame);
  }
};

/// On a robot that stands at `frame`.
Outcome planned(const Goal& goal, const StatusFrames& frame = StatusFrames()) {
  Ready rig(frame);
  return endOf(rig, rig.submit(goal));
}

template <class Change>
Scenario withGoal(const Change& change) {
  return [=] { return planned(with<LoadPathGoal>(change)); };
}
/// The second point is a line, changed.
template <class Change>
Scenario withLine(const Change& change) {
  return withGoal([=](auto& g) {
    g.path[0] = pathPoint({0, 0, 90, 0, 90, 0});
    g.path[1] = pathLine(above(20));
    change(g.path[1]);
  });
}
template <class Change>
Scenario withPoint(const Change& change) {
  return withGoal([=](auto& g) { change(g.path[1]); });
}

void inFrame(PathPoint& point, path::Reference type, int id) {
  point.ref_frame_type = static_cast<int>(type);
  point.ref_frame_id = id;
}
void ofTool(PathPoint& point, int id) {
  point.pose_type = static_cast<int>(path::MovedFrame::Tool);
  point.pose_id = id;
}

Scenarios pointScenarios() {
  return {
      {row(1010), withGoal([](auto& g) { g.number_of_moves = 4; })},
      {row(1012), withGoal([](auto& g) {
         g.start_index = 3;
         g.number_of_moves = 1;
       })},
      {row(1013), withPoint([](auto& p) { p.speed = -1; })},
      {row(1014), withPoint([](auto& p) { p.deceleration_jerk = 101; })},
      {row(1015), withLine([](auto& p) { p.orientation_speed = 0; })},
      {row(1017), withPoint([](auto& p) { p.move_type = 2; })},
      {row(1018), withPoint([](auto& p) { p.target_type = 3; })},
      {row(1020), withLine([](auto& p) { p.interpolation = 4; })},
      {row(1022), withLine([](auto& p) {
         p.termination_type = 6;
         p.command_tolerance = -0.1;
       })},
      {row(1023), withPoint([](auto& p) {
         p.termination_type = 6;
         p.command_tolerance = 100.1;
       })},
      {row(1024), withPoint([](auto& p) { p.termination_type = 1; })},
      {row(1025), withPoint([](auto& p) { p.profile_type = 4; })},
      {row(1026), withPoint([](auto& p) { p.robot_configuration = 16; })},
      {row(1027), withLine([](auto& p) { p.pose_type = 0; })},
      {row(1028), withLine([](auto& p) { p.ref_frame_type = 3; })},
      {row(1029), withLine([](auto& p) { ofTool(p, 16); })},
      {row(1030), withLine([](auto& p) { inFrame(p, path::Reference::User, -1); })},
      {row(1031), withLine([](auto& p) { ofTool(p, 7); })},
      {row(1032), withLine([](auto& p) { inFrame(p, path::Reference::User, 7); })},
  };
}

/// With entries in the tables: tool 2 and frame 2 are names of the project's, frame 1 is the robot base.
template <class Change>
Scenario withTables(const Change& change) {
  return [=] {
    Ready rig;
    EXPECT_TRUE(rig.core.writeTable({2, std::optional(tables::Tool{"gripper", std::nullopt, 0})}));
    EXPECT_TRUE(rig.core.writeTable({2, std::optional(tables::Frame{"table", std::nullopt, 0})}));
    EXPECT_TRUE(rig.core.writeTable({1, std::optional(tables::Frame{"", arm::Pose::Identity(), 0})}));
    const auto goal = with<LoadPathGoal>([&](auto& g) {
      g.path.assign(4, pathLine(above(20)));
      g.number_of_moves = 4;
      change(g.path);
    });
    return endOf(rig, rig.submit(goal));
  };
}

Scenarios planScenarios() {
  return {
      {row(1033), withPoint([](auto& p) { p.joints[2] = 170; })},
      {row(1035), withLine([](auto& p) {
         p.move_type = 1;
         inFrame(p, path::Reference::User, 0);
       })},
      {row(1037), withLine([](auto& p) { p.pose[0] = kNan; })},
      {row(1038), withTables([](auto& path) {
         inFrame(path[1], path::Reference::User, 0);
         inFrame(path[2], path::Reference::User, 1);
         inFrame(path[3], path::Reference::World, 0);
       })},
      {row(1041), withTables([](auto& path) { ofTool(path[3], 2); })},
      {row(1042), withTables([](auto& path) { inFrame(path[3], path::Reference::User, 2); })},
      {row(1040), withLine([](auto& p) { inFrame(p, path::Reference::World, 0); })},
      {row(1043),
       [] {
         const auto goal = with<LoadPathGoal>([](auto& g) { g.path[0] = pathLine(above(20)); });
         return planned(goal, StatusFrames().at({0, 0, 160, 0, 90, 0}));
       }},
      {row(1044), withPoint([](auto& p) {
         p.target_type = static_cast<int>(path::TargetType::Cartesian);
         p.pose = {800, -122.3, 100, 180, 0, 90};
         p.robot_configuration = 13;
       })},
      {row(1045),
       [] {
         const auto goal = with<LoadPathGoal>([](auto& g) { g.path[0] = pathLine(above(20)); });
         return planned(goal, StatusFrames().at({0, 0, 90, 0, 0, 0}));
       }},
      {row(1046), withLine([](auto& p) { p.pose[0] = 2000; })},
      {row(1047), withLine([](auto& p) { p.pose = {150, -122.3, 150, 180, 0, 90}; })},
      {row(1048), withLine([](auto& p) { p.robot_configuration = 13; })},
      {row(1058), withPoint([](auto& p) { p.joints[7] = 1; })},
      {row(own_error::kJointSpeed), withPoint([](auto& p) {
         p.joints[0] = 100;
         p.speed = 200;
         p.acceleration = p.deceleration = 2000;
       })},
      {row(own_error::kNotPlannable), withPoint([](auto& p) { p.speed = 1e-4; })},
      {row(own_error::kPvtTooLong), withPoint([](auto& p) {
         p.joints[0] = 140;
         p.speed = 1;
       })},
  };
}

/// Nobody knows the arm.
template <class Change>
Scenario withoutModel(const Change& change) {
  return [=] {
    CoreRig rig(std::nullopt, link::LinkSettings{});
    rig.connect();
    rig.status(StatusFrames());
    return endOf(rig, rig.submit(with<LoadPathGoal>(change)));
  };
}

Scenarios ownScenarios() {
  return {
      {row(1019), withoutModel([](auto& g) {
         g.path[0] = pathLine({0, 0, 10, 0, 0, 0});
         g.path[0].move_type = 1;
       })},
      {row(1021), withoutModel([](auto& g) { g.path[2] = pathLine(kStart); })},
      {row(own_error::kNoModel), withoutModel([](auto& g) { g.check_only = true; })},
      {row(own_error::kPvtUnavailable),
       withoutModel([](auto& g) { g.execution = static_cast<int>(Execution::Pvt); })},
      {row(own_error::kStartUnknown),
       [] {
         CoreRig rig(*arm::ArmModel::named("tm5-900"));
         rig.connect();
         return endOf(rig, rig.submit(with<LoadPathGoal>([](auto& g) { g.check_only = true; })));
       }},
      {row(own_error::kBufferModeUnknown), withGoal([](auto& g) { g.buffer_mode = 3; })},
      {row(own_error::kExecutionUnknown), withGoal([](auto& g) { g.execution = 3; })},
      {row(own_error::kDeviationRange), withGoal([](auto& g) { g.max_deviation = -1; })},
      {row(own_error::kPathUnreadable), withGoal([](auto& g) { g.path_fault = "no such file"; })},
      {row(own_error::kPoseTemplate), withGoal([](auto& g) {
         placeAtPoses(g, 3, [](std::size_t) { return FramedPose(); });  // with three points as well
       })},
      {row(own_error::kTrackingOffset), withGoal([](auto& g) {
         g.enable_tracking[0] = true;
         g.path[1].tracking_axis_position = 3;
       })},
      {row(own_error::kNotInAScript), withGoal([](auto& g) {
         g.execution = static_cast<int>(Execution::Script);
         g.path[1].profile_type = static_cast<int>(path::ProfileType::SineSquared);
         g.path[1].acceleration_jerk = 100;
       })},
  };
}

/// A path that was sent; `fault` gets the rig and the script id.
Outcome until(const std::function<void(CoreRig&, const std::string&)>& fault) {
  Ready rig;
  const GoalId id = rig.submit(with<LoadPathGoal>([](auto& g) { g.number_of_moves = 1; }));
  fault(rig, rig.takeScript().id);
  return endOf(rig, id);
}

Scenario overdue(const std::function<void(CoreRig&)>& answer) {
  return [=] {
    return until([=](CoreRig& rig, const std::string& id) {
      rig.reply(id);
      while (rig.nothingSent()) {
        rig.pass(500ms);
        rig.status(StatusFrames().moving());
      }
      rig.takeTagQuery();
      answer(rig);
    });
  };
}

Scenarios wireScenarios() {
  return {
      {row(motion_error::kReceiveReply), [] { return until([](auto& rig, const auto&) { rig.pass(1s); }); }},
      {row(motion_error::kRejected),
       [] { return until([](auto& rig, const auto& id) { rig.reply(id, false, {1}); }); }},
      {row(1002), [] { return until(lose); }},
      {row(own_error::kCommunication),
       [] {
         return until([](auto& rig, const auto&) {
           rig.say(protocol::CommunicationError{protocol::CommunicationErrorCode::Checksum});
         });
       }},
      {row(motion_error::kReceiveTag), overdue([](CoreRig& rig) { rig.pass(1s); })},
      {row(motion_error::kMotionFailed), overdue([](CoreRig& rig) {
         rig.streamFor(600ms, StatusFrames());
         rig.tag(1, TagState::Incomplete);
       })},
      {row(own_error::kTagLost), overdue([](CoreRig& rig) { rig.tag(1, TagState::Unknown); })},
      {row(own_error::kNotAtTarget), [] { return until(tellTheEndTooEarly); }},
      {row(own_error::kStoppedElsewhere),
       [] {
         return until([](CoreRig& rig, const std::string& id) { standAt({3, 0, 90, 0, 90, 0}, rig, id); });
       }},
      {row(1007),
       [] {
         Ready rig;
         const GoalId id = rig.submit(with<LoadPathGoal>([](auto& g) {
           while (g.path.size() < 9) g.path.push_back(g.path[g.path.size() - 3]);
           g.number_of_moves = 9;
         }));
         rig.reply(rig.takeScript().id);
         rig.reply(rig.takeScript().id);
         rig.submit(StopGoal{});
         rig.reply(rig.takeScript().id);
         rig.stream(StatusFrames());
         return endOf(rig, id);
       }},
      {row(own_error::kRestNotPlanned),
       [] {
         Ready rig;
         const GoalId id = rig.submit(with<LoadPathGoal>([](auto& g) {
           g.execution = static_cast<int>(Execution::Script);
           for (PathPoint& point : g.path) {
             point.speed = 36;
             point.acceleration = point.deceleration = 180;
           }
         }));
         rig.reply(rig.takeScript().id);
         rig.reply(rig.takeScript().id);
         rig.reply(rig.takeScript().id);
         rig.stream(StatusFrames().at({1, 0, 90, 0, 90, 0}).moving());
         rig.core.setFeedrate(
             {51, true}, [](const FeedrateAnswer&) {}, rig.now);
         rig.pass(0ms);
         rig.reply(rig.takeScript().id);
         rig.stream(StatusFrames().at({1, 0, 90, 0, 90, 0}));
         return endOf(rig, id);
       }},
      {row(own_error::kPathDeviates),
       [] {
         Ready rig;
         const GoalId id = rig.submit(with<LoadPathGoal>([](auto& g) {
           g.number_of_moves = 1;
           g.max_deviation = 1;
         }));
         rig.reply(rig.takeScript().id);
         rig.stream(StatusFrames().at({5, 10, 90, 0, 90, 0}).moving());
         rig.reply(rig.takeScript().id);
         rig.stream(StatusFrames());
         return endOf(rig, id);
       }},
      {row(1006),
       [] {
         return planned(good<LoadPathGoal>(), StatusFrames().with(protocol::item::ofInt("MA_Mode", 2)));
       }},
      {row(own_error::kPlanningBudget),
       [] {
         Ready rig(StatusFrames(), Planning::Beside);
         const GoalId id = rig.submit(good<LoadPathGoal>());
         rig.pass(10s);
         return endOf(rig, id);
       }},
  };
}

}  // namespace

Scenarios pathScenarios() {
  Scenarios all = pointScenarios();
  all.merge(planScenarios());
  all.merge(ownScenarios());
  all.merge(wireScenarios());
  return all;
}

}  // namespace cobot_command::testing
