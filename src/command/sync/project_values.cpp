#include "sync/project_values.h"

#include <array>

#include "cobot_command/arm/controller_pose.h"
#include "cobot_command/common/units.h"

namespace cobot_command::command {
namespace {

using script::AttributeRead;
using script::AttributeWrite;
using script::ProjectAttribute;

bool canBeRead(const std::string& name) {
  return !name.empty() && script::isAttributeKey(name);
}

arm::Pose poseOf(const std::vector<double>& six) {
  return arm::toPose({six[0], six[1], six[2], six[3], six[4], six[5]});
}

std::vector<double> numbersOf(const arm::Pose& pose) {
  const arm::ControllerPose six = arm::toControllerPose(pose);
  return {six.begin(), six.end()};
}

}  // namespace

std::vector<AttributeRead> readsOf(const tables::Entries& entries) {
  std::vector<AttributeRead> reads;
  for (const auto& tool : entries.tools) {
    if (!tool || !canBeRead(tool->name)) continue;
    reads.push_back({ProjectAttribute::TcpValue, tool->name});
    if (tool->load == 0) continue;
    for (const auto attribute :
         {ProjectAttribute::TcpMass, ProjectAttribute::TcpMoment, ProjectAttribute::TcpMassCenter}) {
      reads.push_back({attribute, tool->name});
    }
  }
  for (const auto& frame : entries.frames) {
    if (frame && canBeRead(frame->name)) reads.push_back({ProjectAttribute::BaseValue, frame->name});
  }
  return reads;
}

ProjectValues valuesOf(const std::vector<robot::ReadValue>& values) {
  ProjectValues project;
  for (const auto& [read, numbers] : values) {
    switch (read.attribute) {
      case ProjectAttribute::TcpValue:
        project.tcps[read.name] = poseOf(numbers);
        break;
      case ProjectAttribute::BaseValue:
        project.bases[read.name] = poseOf(numbers);
        break;
      case ProjectAttribute::TcpMass:
        project.burdens[read.name].mass = numbers[0];
        break;
      case ProjectAttribute::TcpMoment:
        project.burdens[read.name].inertia = {numbers[0] / kMm2PerM2, numbers[1] / kMm2PerM2,
                                              numbers[2] / kMm2PerM2};
        break;
      case ProjectAttribute::TcpMassCenter:
        project.burdens[read.name].centre = poseOf(numbers);
        break;
    }
  }
  return project;
}

AttributeWrite tcpWrite(const std::string& name, const arm::Pose& in_flange) {
  return {ProjectAttribute::TcpValue, name, numbersOf(in_flange)};
}

AttributeWrite baseWrite(const std::string& name, const arm::Pose& in_robot_base) {
  return {ProjectAttribute::BaseValue, name, numbersOf(in_robot_base)};
}

std::vector<AttributeWrite> burdenWrites(const std::string& name, const tables::Load& load,
                                         const arm::Pose& tcp) {
  const auto& moment = load.inertia;
  return {{ProjectAttribute::TcpMass, name, {load.mass}},
          {ProjectAttribute::TcpMoment,
           name,
           {moment[0] * kMm2PerM2, moment[1] * kMm2PerM2, moment[2] * kMm2PerM2}},
          {ProjectAttribute::TcpMassCenter, name, numbersOf(arm::Pose(tcp.inverse() * load.centre))}};
}

}  // namespace cobot_command::command
