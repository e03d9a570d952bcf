// The command line of a program: read whole, or refused in the words of a person.
#pragma once

#include <optional>

#include <CLI/CLI.hpp>

namespace cobot_command::tools {

/// The exit status of all programs for a command line that they cannot use.
inline constexpr int kBadUsage = 2;

/// The name in help and errors, and --version, which tells that of the package.
void nameProgram(CLI::App& app, const std::string& name);

/// Behind the last add_subcommand(), in place of require_subcommand(): that says that one is required even
/// when one was given that does not exist.
void askForSubcommand(CLI::App& app);

/// Reads the words behind the program's name. Nothing: go on. Else the exit status to end with: 0 when help
/// or version was printed, kBadUsage when standard error tells what was found, what is allowed, and what to
/// do. `behind_all` checks what only the options together show, and throws a CLI::ParseError.
[[nodiscard]] std::optional<int> readCommandLine(
    CLI::App& app, std::vector<std::string> words, const std::function<void()>& behind_all = [] {});

/// What follows the program's name in the arguments of main().
[[nodiscard]] std::vector<std::string> wordsOf(int argc, char** argv);

}  // namespace cobot_command::tools
