#include "tables/table_messages.h"

#include <cmath>
#include <utility>

#include "cobot_command/arm/controller_pose.h"
#include "cobot_command/common/units.h"
#include "cobot_command/ros/shared/conversions.h"

namespace cobot_command::ros_adapter {
namespace {

/// As files have them: what the way into SI and back rounds away is not shown.
constexpr double kShownPerUnit = 1e9;

cobot_command::Transformation shown(const arm::Pose& pose) {
  arm::ControllerPose six = arm::toControllerPose(pose);
  for (double& number : six) number = std::round(number * kShownPerUnit) / kShownPerUnit + 0.0;
  return toTransformation(six);
}

/// Tools and frames, whose fields have other names.
template <class Message, class Entry>
Message named(int index, const std::optional<Entry>& entry, cobot_command::Transformation Message::*pose) {
  Message message;
  message.index = index;
  message.empty = !entry;
  if (!entry) return message;
  message.name = entry->name;
  message.name_only = !entry->pose;
  if (entry->pose) message.*pose = shown(*entry->pose);
  return message;
}

template <class Message, class Entry>
void addConfigured(const tables::Table<Entry>& table, std::vector<Message>& messages) {
  for (int index = 1; index < tables::kEntryCount; ++index) {
    const auto& entry = table[static_cast<std::size_t>(index)];
    if (entry) messages.push_back(toMessage(index, entry));
  }
}

Result<arm::Pose, tables::Refusal> poseOf(tables::Kind kind, int index,
                                          const cobot_command::Transformation& message) {
  const auto pose = tables::poseIn(toSix(message));
  if (pose) return *pose;
  return refuse(tables::Refusal{pose.error().error_id, kind, index, pose.error().found, pose.error().allowed,
                                "Set parameter in acceptable range"});
}

/// No number that can be written: whatever else is in it, that is what is told.
bool isNoNumber(int index) {
  return !tables::isIndex(index) || index == 0;
}

template <class Entry, class Message>
Result<command::TableWrite, tables::Refusal> toNamedWrite(tables::Kind kind, const Message& message,
                                                          const cobot_command::Transformation& pose,
                                                          Entry entry) {
  if (message.empty || isNoNumber(message.index)) {
    return command::TableWrite{message.index, std::optional<Entry>()};
  }
  entry.name = message.name;
  if (!message.name_only) {
    const auto read = poseOf(kind, message.index, pose);
    if (!read) return refuse(read.error());
    entry.pose = *read;
  }
  return command::TableWrite{message.index, std::optional(std::move(entry))};
}

}  // namespace

cobot_command::ToolData toMessage(int index, const std::optional<tables::Tool>& tool) {
  auto message = named(index, tool, &cobot_command::ToolData::tcp);
  if (tool) message.load = tool->load;
  return message;
}

cobot_command::FrameData toMessage(int index, const std::optional<tables::Frame>& frame) {
  auto message = named(index, frame, &cobot_command::FrameData::pose);
  if (frame) message.reference = frame->reference;
  return message;
}

cobot_command::LoadData toMessage(int index, const std::optional<tables::Load>& load) {
  cobot_command::LoadData message;
  message.index = index;
  message.empty = !load;
  if (!load) return message;
  const auto moment = [&load](std::size_t i) {
    return std::round(load->inertia[i] * kMm2PerM2 * kShownPerUnit) / kShownPerUnit;
  };
  message.mass = load->mass;
  message.moment_of_inertia.ixx = moment(0);
  message.moment_of_inertia.iyy = moment(1);
  message.moment_of_inertia.izz = moment(2);
  message.mass_center = shown(load->centre);
  return message;
}

cobot_command::DataTables toMessage(const tables::DataTables& tables, const ros::Time& stamp) {
  cobot_command::DataTables message;
  message.stamp = stamp;
  addConfigured(tables.entries().tools, message.tools);
  addConfigured(tables.entries().frames, message.frames);
  addConfigured(tables.entries().loads, message.loads);
  return message;
}

Result<command::TableWrite, tables::Refusal> toWrite(const cobot_command::ToolData& message) {
  tables::Tool tool;
  tool.load = message.load;
  return toNamedWrite(tables::Kind::Tool, message, message.tcp, std::move(tool));
}

Result<command::TableWrite, tables::Refusal> toWrite(const cobot_command::FrameData& message) {
  tables::Frame frame;
  frame.reference = message.reference;
  return toNamedWrite(tables::Kind::Frame, message, message.pose, std::move(frame));
}

Result<command::TableWrite, tables::Refusal> toWrite(const cobot_command::LoadData& message) {
  if (message.empty || isNoNumber(message.index)) {
    return command::TableWrite{message.index, std::optional<tables::Load>()};
  }
  const auto centre = poseOf(tables::Kind::Load, message.index, message.mass_center);
  if (!centre) return refuse(centre.error());
  const auto& moment = message.moment_of_inertia;
  return command::TableWrite{
      message.index,
      std::optional(tables::Load{
          message.mass, {moment.ixx / kMm2PerM2, moment.iyy / kMm2PerM2, moment.izz / kMm2PerM2}, *centre})};
}

}  // namespace cobot_command::ros_adapter
