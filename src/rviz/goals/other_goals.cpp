#include <array>

#include "goals/goals.h"

#include "cobot_command/ros/shared/conversions.h"

namespace cobot_command::rviz_plugin {

cobot_command::ConnectGoal toConnect(const Form& form) {
  cobot_command::ConnectGoal goal;
  goal.host = form.text("host");
  goal.port = form.whole("port");
  goal.status_port = form.whole("status_port");
  goal.timeout = form.number("timeout");
  return goal;
}

cobot_command::ChangeBaseGoal toChangeBase(const Form& form) {
  cobot_command::ChangeBaseGoal goal;
  goal.transformation = ros_adapter::toTransformation(form.six("base"));
  goal.base_name = form.text("base_name");
  goal.buffer_mode = form.whole("buffer_mode");
  return goal;
}

cobot_command::ChangeTCPGoal toChangeTcp(const Form& form) {
  cobot_command::ChangeTCPGoal goal;
  goal.tcp_offset = ros_adapter::toTransformation(form.six("tcp_offset"));
  goal.weight = form.number("weight");
  goal.moment_of_inertia.ixx = form.number("ixx");
  goal.moment_of_inertia.iyy = form.number("iyy");
  goal.moment_of_inertia.izz = form.number("izz");
  goal.mass_center = ros_adapter::toTransformation(form.six("mass_center"));
  goal.tcp_name = form.text("tcp_name");
  goal.buffer_mode = form.whole("buffer_mode");
  return goal;
}

cobot_command::LoadPathGoal toLoadPath(const Form& form, bool check_only) {
  cobot_command::LoadPathGoal goal;
  goal.path_file = form.text("path_file");
  goal.start_index = form.whole("start_index");
  goal.number_of_moves = form.whole("number_of_moves");
  goal.execution = static_cast<std::uint8_t>(form.whole("execution"));
  goal.allow_approximation = form.isOn("allow_approximation");
  goal.max_deviation = form.number("max_deviation");
  goal.buffer_mode = form.whole("buffer_mode");
  goal.check_only = check_only;
  return goal;
}

cobot_command::PickAndPlaceGoal toPickAndPlace(const Cycle& cycle, bool check_only) {
  constexpr std::array kModules{"", "EndModule", "ControlBox"};
  cobot_command::PickAndPlaceGoal goal;
  for (const Form& move : cycle.moves) {
    cobot_command::PickAndPlaceStep& step = goal.steps.emplace_back();
    step.move = toMoveAbsolute(move);
    step.output.module = kModules.at(static_cast<std::size_t>(move.whole("output_module")));
    step.output.output = move.whole("output");
    step.output.value = move.isOn("output_value");
    step.dwell = move.number("dwell");
  }
  goal.cycles = cycle.general.whole("cycles");
  goal.buffer_mode = cycle.general.whole("buffer_mode");
  goal.check_only = check_only;
  return goal;
}

cobot_command::ExchangeConfigurationGoal toInterface(const Form& form) {
  cobot_command::ExchangeConfigurationGoal goal;
  goal.exec_mode = cobot_command::ExchangeConfigurationGoal::PARALLEL;
  goal.priority = cobot_command::ExchangeConfigurationGoal::NORMAL;
  cobot_command::ExchangeParCmd& settings = goal.par_cmd;
  settings.log_level = static_cast<std::int8_t>(form.whole("log_level"));
  settings.allow_dynamic_blending = form.isOn("allow_dynamic_blending");
  settings.delay_time = static_cast<std::uint16_t>(form.whole("delay_time"));
  settings.wait_for_nr_of_cmd = static_cast<std::uint16_t>(form.whole("wait_for_nr_of_cmd"));
  settings.life_sign_time_out = static_cast<std::uint16_t>(form.whole("life_sign_time_out"));
  settings.sync_delay = static_cast<std::uint16_t>(form.whole("sync_delay"));
  settings.sync_reaction = static_cast<std::uint8_t>(form.whole("sync_reaction"));
  cobot_command::DataSets& compared = settings.data_enable_sync;
  compared.tools = form.isOn("tools");
  compared.frames = form.isOn("frames");
  compared.loads = form.isOn("loads");
  compared.software_limits = form.isOn("software_limits");
  // The panel keeps no tables of its own that could differ.
  settings.data_in_sync = compared;
  return goal;
}

cobot_command::JogGoal toJog(const Form& form, int axis, int direction) {
  cobot_command::JogGoal goal;
  goal.mode = static_cast<std::uint8_t>(form.whole("mode"));
  goal.directions[static_cast<std::size_t>(axis)] = static_cast<std::int8_t>(direction);
  goal.speed = form.number("speed");
  if (form.isOn("stepwise")) {
    const bool shifts = goal.mode != cobot_command::JogGoal::AXES && axis < 3;
    (shifts ? goal.increment_mm : goal.increment_deg) =
        form.number(shifts ? "increment_mm" : "increment_deg");
  }
  goal.frame = cobot_command::JogGoal::ACTIVE;
  goal.tool = cobot_command::JogGoal::ACTIVE;
  return goal;
}

}  // namespace cobot_command::rviz_plugin
