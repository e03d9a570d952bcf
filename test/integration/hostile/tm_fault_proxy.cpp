// tm_fault_proxy: does to the traffic between any client and any controller on this machine what networks do.
//
// Exit status: 0 at the end of its input, 1 when the ports cannot be had, 2 on bad usage.
#include <cstdio>
#include <exception>
#include <iostream>
#include <limits>
#include <string>

#include "../../../src/tools/command_line.h"
#include "../../../src/tools/setting_options.h"
#include "fault_line.h"
#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "cobot_command/common/setting_kinds.h"

namespace {

using namespace cobot_command::testing;

using namespace cobot_command;

enum ExitStatus { Ended = 0, NoPort = 1 };

SettingTable tableOf(ProxyPorts& controller, ProxyPorts& listen, int& seed) {
  using namespace setting_kinds;
  return {
      {"script", port(controller.script), "script port of the controller"},
      {"status", port(controller.status), "its status port"},
      {"listen_script", port(listen.script), "where clients find it; 0: any free port"},
      {"listen_status", port(listen.status), "and the status port"},
      {"seed", whole(seed, 0, std::numeric_limits<int>::max()), "of what is random"},
  };
}

void tell(const std::string& text) {
  std::cout << text << '\n' << std::flush;
}

std::string carryOut(FaultProxy& proxy, const std::string& line) {
  if (line == "faults") return knownFaultKinds() + "ok";
  if (line == "strikes") return fmt::format("ok: {} frames were struck", proxy.strikes());
  if (line == "heal") {
    proxy.heal();
    return "ok: no faults";
  }
  if (line == "reset") {
    proxy.reset();
    return "ok: all connections are dropped";
  }
  const auto order = parseFaultLine(line);
  if (!order) return "error: " + order.error();
  proxy.add(order->port, order->fault);
  return "ok";
}

int serve(const ProxyPorts& controller, const ProxyPorts& listen, unsigned seed) try {
  FaultProxy proxy(controller, seed, listen);
  tell(fmt::format("listening script={} status={}", proxy.ports().script, proxy.ports().status));
  for (std::string line; std::getline(std::cin, line);) tell(carryOut(proxy, line));
  return Ended;
} catch (const std::exception& error) {
  fmt::print(stderr, "tm_fault_proxy: {}; choose other ports (0: any free one)\n", error.what());
  return NoPort;
}

}  // namespace

int main(int argc, char** argv) try {
  CLI::App app(
      "A proxy in front of a TM controller on this machine that spoils the traffic. Faults are lines on its "
      "standard input: PORT KIND [direction=to_client|to_controller] [which=any|script|tag|node_state] "
      "[first=N] [count=N] [time=S] [jitter=S] [rate=N] [text=T], where PORT is script or status; \"faults\" "
      "lists "
      "the kinds. \"heal\" takes all faults away, \"reset\" drops all connections, \"strikes\" counts.");
  tools::nameProgram(app, "tm_fault_proxy");
  ProxyPorts controller{5890, 5891};
  ProxyPorts listen;
  int seed = 1;
  tools::addOptions(app, tableOf(controller, listen, seed));
  if (const auto end = tools::readCommandLine(app, tools::wordsOf(argc, argv))) return *end;
  return serve(controller, listen, static_cast<unsigned>(seed));
} catch (const std::exception& error) {
  fmt::print(stderr, "tm_fault_proxy: {}\n", error.what());
  return NoPort;
}
