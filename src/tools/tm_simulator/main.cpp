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
#include <vector>

#include "line_printer.h"
#include "line_reader.h"
#include "project_options.h"
#include <CLI/CLI.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/signal_set.hpp>
#include <fmt/format.h>
#include <unistd.h>

#include "cobot_command/arm/arm_model.h"
#include "cobot_command/runtime/end_signals.h"
#include "cobot_command/runtime/simulator_runtime.h"
#include "cobot_command/simulator/control_line.h"

namespace {

using namespace cobot_command;

enum ExitStatus { Ended = 0, CannotServe = 1, BadUsage = 2 };

struct Options {
  std::string model = "tm5-900";
  runtime::SimulatorOptions simulator;
  simulator::Settings settings;
  bool log_traffic = false;
  bool control = false;
};

/// Takes a Result, or ends with its complaint.
template <class Value>
Value valueOf(const std::string& option, Result<Value, std::string> result) {
  if (!result) throw CLI::ValidationError(option, result.error());
  return std::move(*result);
}

/// An option in milliseconds.
template <class Use>
void addDuration(CLI::App& app, const std::string& option, const std::string& meaning, Use use) {
  constexpr double kLongest = 86.4e6;  // a day
  app.add_option_function<double>(
         option, [use](double milliseconds) { use(fromSeconds(milliseconds / 1000)); }, meaning)
      ->check(CLI::Range(-1.0, kLongest));
}

void describeListenNode(CLI::App& app, simulator::Settings& settings) {
  app.add_option("--listen-node", settings.listen_node_message, "message of the Listen node")
      ->capture_default_str();
  addDuration(app, "--connection-timeout",
              "the Listen node is left when nobody connects for so long [ms]; 0: never",
              [&](Duration limit) { settings.connection_timeout = limit; });
  addDuration(app, "--data-timeout",
              "the Listen node is left when clients send nothing for so long [ms]; 0: never",
              [&](Duration limit) { settings.data_timeout = limit; });
  addDuration(app, "--reentry-delay",
              "from leaving the Listen node until it is entered again [ms]; -1: it is not",
              [&](Duration delay) {
                settings.reentry_delay = delay < Duration::zero() ? std::nullopt : std::optional(delay);
              });
}

void describeStatusPort(CLI::App& app, simulator::Settings& settings) {
  app.add_option_function<double>(
         "--status-period",
         [&](double milliseconds) { settings.status_period = fromSeconds(milliseconds / 1000); },
         "of the status stream [ms], 1 to 1000")
      ->check(CLI::Range(1.0, 1000.0))
      ->default_str("15");
  app.add_option_function<std::string>(
         "--stream-format",
         [&](const std::string& text) {
           settings.stream_format = valueOf("--stream-format", simulator::parseStreamFormat(text));
         },
         "of the status stream: binary, string or json")
      ->default_str("binary");
  app.add_option_function<std::string>(
      "--stream-items", [&](const std::string& text) { settings.stream_items = simulator::parseNames(text); },
      "items of the status stream, separated by commas; without it, those of the vendor's ROS driver and a "
      "few more");
  app.add_option_function<std::string>(
         "--write-clients",
         [&](const std::string& text) {
           settings.write_clients = valueOf("--write-clients", simulator::parseWriteClients(text));
         },
         "who may write items: all, none, or addresses, separated by commas")
      ->default_str("all");
}

void describe(CLI::App& app, Options& options) {
  app.description(
      "A simulated TM controller: any client of the TM protocol can use it in place of a robot.\n"
      "Prints `listening script=PORT status=PORT` once it serves; Ctrl-C ends it.");
  app.footer(
      "Commands that --control takes, one a line, each answered with a line `ok: ...` or `error: ...`:\n" +
      simulator::controlHelp());
  app.add_option("--model", options.model, "arm to simulate")
      ->check(CLI::IsMember(arm::ArmModel::knownNames()))
      ->capture_default_str();
  app.add_option("--script-port", options.simulator.script_port, "port of the Listen node; 0: any free one")
      ->capture_default_str();
  app.add_option("--status-port", options.simulator.status_port, "port of the status stream; 0: any free one")
      ->capture_default_str();
  app.add_option("--bind", options.simulator.bind_address,
                 "address to serve; 127.0.0.1: programs on this machine alone, 0.0.0.0: every network")
      ->capture_default_str();
  app.add_option(
         "--time-scale", options.simulator.time_scale,
         fmt::format("simulated seconds in a real one, {} to {}; 0 or max: motions as fast as possible",
                     runtime::kSlowestTimeScale, runtime::kFastestTimeScale))
      ->transform([](std::string text) { return text == "max" ? std::string("0") : text; })
      ->capture_default_str();
  describeListenNode(app, options.settings);
  app.add_option("--tmflow-version", options.settings.tmflow_version,
                 "decides which functions scripts have, and which items there are")
      ->check(CLI::IsMember(simulator::knownTmflowVersions()))
      ->capture_default_str();
  app.add_flag("!--any-payload", options.settings.checks_payload,
               "move with more tool and load than the model carries, too");
  app.add_flag("--velocity-licence", options.settings.velocity_licence,
               "have the functions of continuous velocities (ContinueVJog, ContinueVLine)");
  app.add_flag("--accept-empty-length", options.settings.accept_empty_length, "take frames without a length");
  tools::describeProject(app, options.settings);
  describeStatusPort(app, options.settings);
  app.add_flag("--log-traffic,--verbose", options.log_traffic,
               "print what is sent and received, in words; but the status stream");
  app.add_flag("--control", options.control, "take the operator's commands from standard input, see below");
}

void obey(runtime::SimulatorRuntime& simulator, tools::LinePrinter& printer, std::string line) {
  auto reply = std::make_shared<simulator::OperatorReply>();
  simulator.post(
      [line = std::move(line), reply](simulator::SimulatedController& controller, Instant now) {
        *reply = simulator::control(controller, line, now);
      },
      [reply, &printer] {
        if (!reply->text.empty())
          printer.print(fmt::format("{}: {}", reply->done ? "ok" : "error", reply->text));
      });
}

int serve(Options options) {
  auto arm = arm::ArmModel::named(options.model);
  if (!arm) {
    fmt::print(stderr, "tm_simulator: {}\n", arm.error().message);
    return BadUsage;
  }
  if (const auto fault = simulator::faultIn(options.settings)) {
    fmt::print(stderr, "tm_simulator: {}\n", *fault);
    return BadUsage;
  }
  boost::asio::io_context context;
  boost::asio::signal_set end(context);
  for (const int signal : runtime::endSignals()) end.add(signal);
  end.async_wait([](const boost::system::error_code&, int) {});

  tools::LinePrinter printer("tm_simulator");
  runtime::SimulatorRuntime::Observer observer;
  if (options.log_traffic) {
    observer.log = [&printer](const simulator::LogLine& line) {
      printer.print(fmt::format("{:10.3f} {}", toSeconds(line.time.time_since_epoch()), line.text));
    };
  }
  runtime::SimulatorRuntime simulator(std::move(*arm), std::move(options.settings),
                                      std::move(options.simulator), std::move(observer));
  const auto ports = simulator.start();
  if (!ports) {
    fmt::print(stderr, "tm_simulator: {}\n", ports.error().message);
    return ports.error().kind == runtime::SimulatorError::Kind::BadOption ? BadUsage : CannotServe;
  }
  printer.print(fmt::format("listening script={} status={}", ports->script, ports->status));
  std::optional<tools::LineReader> control;
  if (options.control)
    control.emplace(STDIN_FILENO, [&](std::string line) { obey(simulator, printer, std::move(line)); });
  context.run();  // until the signal
  control.reset();
  simulator.stop();
  return Ended;
}

}  // namespace

int main(int argc, char** argv) {
  std::signal(SIGPIPE, SIG_IGN);  // a reader of the output may go; LinePrinter sees it
  CLI::App app;
  Options options;
  describe(app, options);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? Ended : BadUsage;
  }
  return serve(std::move(options));
}
