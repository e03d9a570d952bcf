// The settings of exchange_configuration, and what it reports, as messages.
#pragma once

#include "cobot_command/DataSets.h"
#include "cobot_command/ExchangeOutCmd.h"
#include "cobot_command/ExchangeParCmd.h"
#include "cobot_command/blocks/exchange_configuration.h"

namespace cobot_command::ros_adapter {

[[nodiscard]] blocks::ExchangeSettings toSettings(const cobot_command::ExchangeParCmd& message);
[[nodiscard]] cobot_command::ExchangeOutCmd toMessage(const blocks::ExchangeOutCmd& out);

/// What result and feedback have in common.
template <class Message>
void fillReport(Message& message, const blocks::ExchangeReport& report) {
  message.enabled = report.enabled;
  message.busy = report.busy;
  message.command_buffered = report.command_buffered;
  message.parameter_accepted = report.parameter_accepted;
  message.error_add_txt = report.error_add_txt;
  message.warning_id = report.warning_id;
  message.warning_id_enum = blocks::srciNameOf(report.warning_id);
  message.info_id = report.info_id;
  message.info_id_enum = blocks::srciNameOf(report.info_id);
  message.out_cmd = toMessage(report.out_cmd);
  message.par_seq = static_cast<std::uint32_t>(report.par_seq);
  message.ri_state = static_cast<std::uint8_t>(report.ri_state);
  message.unsupported = report.unsupported;
  message.without_effect = report.without_effect;
  message.local_sets = report.local_sets;
  message.life_sign_worst_gap = report.life_sign_worst_gap;
}

}  // namespace cobot_command::ros_adapter
