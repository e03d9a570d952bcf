// tm_simulator: a simulated TM controller on two TCP ports, without ROS.
//
// Exit status: 0 after SIGINT, SIGTERM or SIGHUP, 1 when the ports cannot be served, 2 on bad usage. When
// nobody reads its output any more, it serves on.
#include <csignal>
#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "../command_line.h"
#include "../setting_options.h"
#include "line_printer.h"
#include "line_reader.h"
#include <CLI/CLI.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/signal_set.hpp>
#include <fmt/format.h>
#include <unistd.h>

#include "cobot_command/arm/arm_model.h"
#include "cobot_command/common/foreign_text.h"
#include "cobot_command/runtime/shared/end_signals.h"
#include "cobot_command/runtime/simulation/simulator_runtime.h"
#include "cobot_command/runtime/simulation/simulator_setup.h"
#include "cobot_command/simulator/control_line.h"

namespace {

using namespace cobot_command;

constexpr const char* kUsualModel = "tm5-900";

enum ExitStatus { Ended = 0, CannotServe = 1, BadUsage = tools::kBadUsage };

struct Options {
  runtime::SimulatorSetup setup;
  bool control = false;
};

void describe(CLI::App& app, const SettingTable& table, Options& options) {
  tools::nameProgram(app, "tm_simulator");
  app.description(
      "A simulated TM controller: any client of the TM protocol can use it in place of a robot.\nPrints "
      "`listening script=PORT status=PORT` when it is ready; Ctrl-C ends it.");
  app.footer(
      "Commands that --control takes, one per line; each is answered with a line `ok: ...` or `error: "
      "...`:\n" +
      simulator::controlHelp());
  tools::addOptions(app, table);
  app.add_flag("--verbose", options.setup.log_traffic, "the same as --log-traffic");
  app.add_flag("--control", options.control, "read the operator's commands from standard input, see below");
}

void obey(runtime::SimulatorRuntime& simulator, tools::LinePrinter& printer, std::string line) {
  auto reply = std::make_shared<simulator::OperatorReply>();
  simulator.post(
      [line = std::move(line), reply](simulator::SimulatedController& controller, Instant now) {
        *reply = simulator::control(controller, line, now);
      },
      [reply, &printer] {
        if (!reply->text.empty()) {
          printer.print(fmt::format("{}: {}", reply->done ? "ok" : "error", reply->text));
        }
      });
}

int serve(runtime::SimulatorSetup setup, arm::ArmModel arm, bool is_controlled) {
  boost::asio::io_context context;
  boost::asio::signal_set end(context);
  for (const int signal : runtime::endSignals()) end.add(signal);
  end.async_wait([](const boost::system::error_code&, int) {});

  tools::LinePrinter printer("tm_simulator");
  runtime::SimulatorRuntime::Observer observer;
  if (setup.log_traffic) {
    observer.log = [&printer](const simulator::LogLine& line) {
      printer.print(fmt::format("{:10.3f} {}", toSeconds(line.time.time_since_epoch()), line.text));
    };
  }
  runtime::SimulatorRuntime simulator(std::move(arm), std::move(setup.settings), std::move(setup.options),
                                      std::move(observer));
  const auto ports = simulator.start();
  if (!ports) {
    fmt::print(stderr, "tm_simulator: {}\n", forPeople(ports.error().message));
    return ports.error().kind == runtime::SimulatorError::Kind::BadOption ? BadUsage : CannotServe;
  }
  printer.print(fmt::format("listening script={} status={}", ports->script, ports->status));
  std::optional<tools::LineReader> control;
  if (is_controlled) {
    control.emplace(STDIN_FILENO, [&](std::string line) { obey(simulator, printer, std::move(line)); });
  }
  context.run();  // until the signal
  control.reset();
  simulator.stop();
  return Ended;
}

/// The arm of the setup, once all of that fits together.
arm::ArmModel armOf(const SettingTable& table, const runtime::SimulatorSetup& setup) {
  auto arm = arm::ArmModel::named(setup.robot_model.empty() ? kUsualModel : setup.robot_model);
  if (!arm) throw CLI::ValidationError("--model", arm.error().message);
  if (const auto fault = runtime::faultIn(setup, *arm)) throw tools::badUsage(table, *fault);
  return std::move(*arm);
}

}  // namespace

int main(int argc, char** argv) try {
  std::signal(SIGPIPE, SIG_IGN);  // a reader of the output may go; LinePrinter sees it
  CLI::App app;
  Options options;
  const SettingTable table = runtime::settingsTable(options.setup);
  describe(app, table, options);
  std::optional<arm::ArmModel> arm;
  const auto end = tools::readCommandLine(app, tools::wordsOf(argc, argv),
                                          [&] { arm.emplace(armOf(table, options.setup)); });
  return end ? *end : serve(std::move(options.setup), std::move(*arm), options.control);
} catch (const std::exception& error) {
  fmt::print(stderr, "tm_simulator: {}\n", cobot_command::forPeople(error.what()));
  return CannotServe;
}
