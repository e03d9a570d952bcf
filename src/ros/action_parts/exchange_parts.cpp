#include "action_parts/exchange_parts.h"

namespace cobot_command::ros_adapter {
namespace {

blocks::DataSets toSets(const cobot_command::DataSets& message) {
  blocks::DataSets sets;
  sets.tools = message.tools != 0;
  sets.frames = message.frames != 0;
  sets.loads = message.loads != 0;
  sets.work_areas = message.work_areas != 0;
  sets.software_limits = message.software_limits != 0;
  sets.default_dynamics = message.default_dynamics != 0;
  sets.reference_dynamics = message.reference_dynamics != 0;
  return sets;
}

cobot_command::DataSets toMessage(const blocks::DataSets& sets) {
  cobot_command::DataSets message;
  message.tools = sets.tools;
  message.frames = sets.frames;
  message.loads = sets.loads;
  message.work_areas = sets.work_areas;
  message.software_limits = sets.software_limits;
  message.default_dynamics = sets.default_dynamics;
  message.reference_dynamics = sets.reference_dynamics;
  return message;
}

std::uint8_t toIndex(int index) {
  return static_cast<std::uint8_t>(index);
}

}  // namespace

blocks::ExchangeSettings toSettings(const cobot_command::ExchangeParCmd& message) {
  blocks::ExchangeSettings settings;
  settings.log_level = message.log_level;
  settings.wait_at_blending_zone = message.wait_at_blending_zone != 0;
  settings.allow_sec_seq_while_subprogram = message.allow_sec_seq_while_subprogram != 0;
  settings.allow_dynamic_blending = message.allow_dynamic_blending != 0;
  settings.delay_time = message.delay_time;
  settings.wait_for_nr_of_cmd = message.wait_for_nr_of_cmd;
  settings.life_sign_time_out = message.life_sign_time_out;
  settings.sync_delay = message.sync_delay;
  settings.sync_reaction = message.sync_reaction;
  settings.data_in_sync = toSets(message.data_in_sync);
  settings.data_enable_sync = toSets(message.data_enable_sync);
  return settings;
}

cobot_command::ExchangeOutCmd toMessage(const blocks::ExchangeOutCmd& out) {
  cobot_command::ExchangeOutCmd message;
  message.length_acr = static_cast<std::uint16_t>(out.length_acr);
  message.highest_tool_index = toIndex(out.highest_tool_index);
  message.highest_frame_index = toIndex(out.highest_frame_index);
  message.highest_load_index = toIndex(out.highest_load_index);
  message.highest_work_area_index = toIndex(out.highest_work_area_index);
  message.data_in_sync = toMessage(out.data_in_sync);
  message.change_index_tool = toIndex(out.change_index_tool);
  message.change_index_frame = toIndex(out.change_index_frame);
  message.change_index_load = toIndex(out.change_index_load);
  message.change_index_work_area = toIndex(out.change_index_work_area);
  message.accelerating_supported = out.tells_motion_state;
  message.decelerating_supported = out.tells_motion_state;
  message.constant_velocity_supported = out.tells_motion_state;
  return message;
}

}  // namespace cobot_command::ros_adapter
