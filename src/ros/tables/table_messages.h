// Entries of the tables <-> messages, in mm, degrees, kg and kg mm^2.
#pragma once

#include <optional>

#include <ros/time.h>

#include "cobot_command/DataTables.h"
#include "cobot_command/FrameData.h"
#include "cobot_command/LoadData.h"
#include "cobot_command/ToolData.h"
#include "cobot_command/command/table_write.h"
#include "cobot_command/tables/data_tables.h"

namespace cobot_command::ros_adapter {

[[nodiscard]] cobot_command::ToolData toMessage(int index, const std::optional<tables::Tool>& tool);
[[nodiscard]] cobot_command::FrameData toMessage(int index, const std::optional<tables::Frame>& frame);
[[nodiscard]] cobot_command::LoadData toMessage(int index, const std::optional<tables::Load>& load);
/// What is configured, without number 0.
[[nodiscard]] cobot_command::DataTables toMessage(const tables::DataTables& tables, const ros::Time& stamp);

/// Refused when a pose in it is none; all else is the tables' to judge.
[[nodiscard]] Result<command::TableWrite, tables::Refusal> toWrite(const cobot_command::ToolData& tool);
[[nodiscard]] Result<command::TableWrite, tables::Refusal> toWrite(const cobot_command::FrameData& frame);
[[nodiscard]] Result<command::TableWrite, tables::Refusal> toWrite(const cobot_command::LoadData& load);

}  // namespace cobot_command::ros_adapter
