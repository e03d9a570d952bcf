#include "cobot_command/runtime/simulation/simulator_setup.h"

#include <utility>

#include <boost/asio/ip/address.hpp>
#include <fmt/format.h>

#include "cobot_command/common/setting_kinds.h"

namespace cobot_command::runtime {

namespace {

using namespace setting_kinds;

TextRule address() {
  return {"a numeric address of this machine", [](const std::string& text) {
            boost::system::error_code fault;
            boost::asio::ip::make_address(text, fault);
            return !fault;
          }};
}

SettingKind timeScale(double& scale) {
  SettingKind kind = real(scale, kSlowestTimeScale, kFastestTimeScale);
  kind.range += ", or max: motions as fast as possible";
  kind.take = [&scale, take = std::move(kind.take)](const Given& given) {
    const auto* word = std::get_if<std::string>(&given.value);
    if (word == nullptr || *word != "max") return take(given);
    scale = kAsFastAsPossible;
    return std::optional<std::string>();
  };
  return kind;
}

SettingTable optionsTable(SimulatorOptions& o) {
  return {
      {"bind_address", text(o.bind_address, address()),
       "who can connect; 127.0.0.1: only programs on this machine, 0.0.0.0: every network", "bind"},
      {"script_port", port(o.script_port), "port of the Listen node; 0: any free one"},
      {"status_port", port(o.status_port), "port of the status stream; 0: any free one"},
      {"time_scale", timeScale(o.time_scale), "simulated seconds per real second"},
  };
}

}  // namespace

SettingTable settingsTable(SimulatorSetup& setup) {
  const SettingTable model{
      {"robot_model", text(setup.robot_model, orEmpty(oneOf(arm::ArmModel::knownNames()))),
       "arm model to simulate; empty: the model of the parameter robot_description, in tm_simulator tm5-900",
       "model"}};
  const SettingTable log{{"log_traffic", flag(setup.log_traffic),
                          "logs sent and received messages in words, except the status stream"}};
  return joined({model, optionsTable(setup.options), simulator::settingsTable(setup.settings), log});
}

std::optional<SettingFault> faultIn(const SimulatorSetup& setup, const arm::ArmModel& arm) {
  const int port = setup.options.status_port;
  if (port != 0 && port == setup.options.script_port) {
    return SettingFault{"status_port", fmt::format("is {}, the same as script_port", port),
                        "another port, or 0 for any free one"};
  }
  return simulator::faultIn(setup.settings, arm);
}

}  // namespace cobot_command::runtime
