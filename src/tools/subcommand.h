// Programs that do one of several things: what is said when none, or another one, is asked for.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

namespace cobot_command::tools {

/// Behind the last add_subcommand(), in place of require_subcommand(): that says that one is required even
/// when one was given that does not exist.
inline void askForSubcommand(CLI::App& app) {
  app.require_subcommand(0, 1);
  app.allow_extras();
}

/// After the parsing: throws what is wrong with the words, by name.
inline void checkSubcommand(const CLI::App& app) {
  std::vector<std::string> left = app.remaining(true);
  // What ends the options is no word by itself.
  left.erase(std::remove(left.begin(), left.end(), "--"), left.end());
  const bool is_given = !app.get_subcommands().empty();
  const bool is_option = !left.empty() && left.front().compare(0, 1, "-") == 0;
  if (!left.empty() && (is_given || is_option)) throw CLI::ExtrasError(left);
  if (is_given) return;
  std::string known;
  for (const CLI::App* subcommand : app.get_subcommands({})) {
    known += (known.empty() ? "" : ", ") + subcommand->get_name();
  }
  const std::string found =
      left.empty() ? "no subcommand is given" : "there is no subcommand \"" + left.front() + '"';
  throw CLI::RequiredError(found + "; allowed: " + known, CLI::ExitCodes::RequiredError);
}

}  // namespace cobot_command::tools
