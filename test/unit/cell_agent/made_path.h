// A path of two frames that turns the first joint, made by hand, and a zone in the middle of it.
#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "cobot_command/arm/controller_pose.h"
#include "cobot_command/cell/artifact/artifact.h"
#include "cobot_command/cell/sweep/robot_claim.h"
#include "cobot_command/common/units.h"

namespace cobot_command::cell {

/// The arm is stretched out, so that it goes far when it turns.
inline arm::JointVector turned(double degrees) {
  return arm::toJointVector({degrees, 70, 30, -10, 90, 0});
}

inline motion::JointRange between(double from, double to) {
  return {turned(from), turned(to)};
}

/// From 0 to 45 degrees, and on to 90, in 4 s each. Zone 0 is touched from 22.5 to 67.5 degrees, zone 1 from
/// 45 degrees on.
inline ArtifactPath quarterTurn() {
  using std::chrono::seconds;
  ArtifactPath path;
  path.frames.resize(2);
  path.frames[0].lines = {"PTP(\"JPP\",45,0,0,0,0,0,30,200,0,false)"};
  path.frames[0].start = turned(0);
  path.frames[0].end = seconds(4);
  path.frames[1].lines = {"PTP(\"JPP\",90,0,0,0,0,0,30,200,0,false)"};
  path.frames[1].start = turned(45);
  path.frames[1].begin = seconds(4);
  path.frames[1].end = seconds(8);
  const auto add = [&](Piece::Kind kind, std::size_t frame, int from, motion::JointRange range,
                       std::vector<ZoneIndex> zones) {
    path.pieces.push_back(
        {kind, frame, 0, seconds(from), seconds(from + 2), std::move(range), std::move(zones)});
  };
  add(Piece::Kind::Motion, 0, 0, between(0, 22.5), {});
  add(Piece::Kind::Motion, 0, 2, between(22.5, 45), {0});
  add(Piece::Kind::Rest, 0, 0, between(45, 45), {0});
  add(Piece::Kind::Motion, 1, 0, between(45, 67.5), {0, 1});
  add(Piece::Kind::Motion, 1, 2, between(67.5, 90), {1});
  add(Piece::Kind::Rest, 1, 0, between(90, 90), {1});
  path.places = {{0, 0}, {1, 0}, {0, 3}};
  path.duration = seconds(8);
  return path;
}

/// Zone 0 is booked with the first frame, zone 1 with the second, and zone 0 released behind the fourth
/// piece.
inline PathProgram programOfTurn() {
  return {"TURN", 0, 1, {{true, {0}, false}, {true, {1}, false}, {false, {0}, false}}, false};
}

/// A TM5-900 "R" with that path and the way back.
inline std::shared_ptr<Artifact> artifactOfTurn() {
  auto artifact = std::make_shared<Artifact>();
  artifact->parameters.tracking = degToRad(0.1);
  artifact->program.name = "turn";
  artifact->program.zones = {"Z1", "Z2"};
  RobotProgram program;
  program.name = "R";
  program.stations = {"HOME", "OUT"};
  program.paths = {programOfTurn(), {"BACK", 1, 0, {{false, {1}, false}}, false}};
  artifact->program.robots = {program};
  ArtifactRobot robot;
  robot.model = "tm5-900";
  robot.stations = {{turned(0), {}, {}}, {turned(90), {1}, {}}};
  robot.paths = {quarterTurn(), {}};
  artifact->robots = {robot};
  return artifact;
}

/// What the bodies of that robot take up, as large as the zone watch sees them.
inline VoxelSet claimAt(double degrees, const Artifact& artifact) {
  const auto bodies = RobotBodies::fromUrdf(arm::ArmModel::urdfOf("tm5-900"), arm::Pose::Identity(), {},
                                            artifact.parameters.body_cell);
  VoxelSet claim;
  claimRobot(claim, *bodies, bodies->at(turned(degrees)), arm::JointVector::Zero(), 0.01,
             artifact.parameters.voxel);
  return claim;
}

}  // namespace cobot_command::cell
