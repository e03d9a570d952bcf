// rapid: programs in RAPID, the language of ABB's robots, without ROS and without a robot; see doc/rapid.md.
#include <cstdio>
#include <exception>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "../command_line.h"
#include "../setting_options.h"
#include "../written_output.h"
#include "check_command.h"
#include "exit_status.h"
#include "format_command.h"
#include <CLI/CLI.hpp>

#include "cobot_command/common/foreign_text.h"

namespace {

using namespace cobot_command;

/// The subcommands, each with its options and what it does.
class Commands {
 public:
  explicit Commands(CLI::App& app) : app_(app) {
    addCheck();
    addFormat();
  }

  /// Throws what only the options of the given subcommand together show to be wrong.
  void check() const {
    for (const Command& command : commands_) {
      const std::string wrong = command.app->parsed() ? command.check() : "";
      if (!wrong.empty()) throw CLI::ValidationError(command.app->get_name(), wrong);
    }
  }
  [[nodiscard]] int run() const {
    for (const Command& command : commands_) {
      if (command.app->parsed()) return command.run();
    }
    return tools::kBadUsage;
  }

 private:
  struct Command {
    CLI::App* app;
    std::function<std::string()> check;
    std::function<int()> run;
  };

  void addCheck() {
    CLI::App* command = app_.add_subcommand("check", "Report all findings of the modules of a program");
    command->add_option("FILE", check_.files, "The modules, or - for standard input")
        ->type_name("")
        ->required();
    tools::addOptions(*command, tools::checkTable(check_));
    commands_.push_back({command, [] { return std::string(); }, [this] { return tools::check(check_); }});
  }

  void addFormat() {
    CLI::App* command = app_.add_subcommand("format", "Print a file in canonical form");
    command->add_option("FILE", format_.file, "A module, or - for standard input")->type_name("")->required();
    tools::addOptions(*command, tools::formatTable(format_));
    commands_.push_back(
        {command, [this] { return contradictionIn(format_); }, [this] { return format(format_); }});
  }

  CLI::App& app_;
  std::vector<Command> commands_;
  tools::CheckCommand check_;
  tools::FormatOptions format_;
};

int run(int argc, char** argv) {
  CLI::App app("Programs in RAPID, without ROS and without a robot.");
  tools::nameProgram(app, "rapid");
  app.footer(
      "Exit status: 0 success, 1 errors or a negative answer, 2 bad usage, 3 the answer could not be "
      "written.");
  Commands commands(app);
  tools::askForSubcommand(app);
  const auto end = tools::readCommandLine(app, tools::wordsOf(argc, argv), [&] { commands.check(); });
  return end ? *end : commands.run();
}

}  // namespace

int main(int argc, char** argv) try {
  return tools::unlessOutputLost("rapid", run(argc, argv));
} catch (const std::exception& error) {
  std::fprintf(stderr, "rapid: %s\n", cobot_command::forPeople(error.what()).c_str());
  return tools::kFound;
}
