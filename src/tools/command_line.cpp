#include "command_line.h"

#include <algorithm>
#include <iterator>
#include <memory>
#include <string_view>

#include "cobot_command/capabilities/layer_version.h"
#include "cobot_command/common/foreign_text.h"
#include "cobot_command/common/nearest.h"
#include "cobot_command/common/setting_kinds.h"

namespace cobot_command::tools {

namespace {

using Words = std::vector<std::string>;

constexpr std::size_t kLongestFault = 2048;  // [bytes]; one lists all faults of the simulator

std::string inQuotes(const std::string& word) {
  return '"' + foreignText(word, kQuoteLimit) + '"';
}

Words namesOf(const CLI::App& app) {
  Words names;
  for (const CLI::Option* option : app.get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  }
  return names;
}

/// Of the program and of what it can do.
std::vector<const CLI::App*> levelsOf(const CLI::App& app) {
  std::vector<const CLI::App*> levels{&app};
  for (const CLI::App* subcommand : app.get_subcommands({})) levels.push_back(subcommand);
  return levels;
}

const CLI::Option* optionNamed(const CLI::App& app, const std::string& name) {
  for (const CLI::App* level : levelsOf(app)) {
    if (const CLI::Option* option = level->get_option_no_throw(name)) return option;
  }
  return nullptr;
}

bool isFlag(const CLI::Option& option) {
  return option.get_items_expected_max() == 0;
}

/// CLI11 counts with the value of a flag: 2 would be on, and what is no number an exception of the library.
void checkFlag(const std::string& name, const std::string& value) {
  bool is_on = false;
  const SettingKind kind = setting_kinds::flag(is_on);
  if (const auto found = kind.take(givenBy({value}, kind.form))) {
    throw CLI::ValidationError(name, describe(SettingFault{name, *found, allowedBy(kind)}) +
                                         "; give it after =, or the name alone for true");
  }
}

/// With flags that are checked; --name= as the option with an empty text behind it, which CLI11 would take
/// for an option with the next word behind it.
Words prepared(const CLI::App& app, const Words& words) {
  const auto end_of_options = std::find(words.begin(), words.end(), "--");
  Words result;
  for (auto word = words.begin(); word != end_of_options; ++word) {
    const std::size_t sign = word->find('=');
    const std::string name = word->substr(0, sign);
    const bool has_value = sign != std::string::npos && name.size() > 2 && name.compare(0, 2, "--") == 0;
    const CLI::Option* option = has_value ? optionNamed(app, name) : nullptr;
    if (option != nullptr && isFlag(*option)) checkFlag(name, word->substr(sign + 1));
    if (option != nullptr && !isFlag(*option) && sign + 1 == word->size()) {
      result.insert(result.end(), {name, ""});
    } else {
      result.push_back(*word);
    }
  }
  result.insert(result.end(), end_of_options, words.end());
  return result;
}

/// Those that nothing took; what ends the options is no word by itself.
Words leftOf(const CLI::App& app) {
  Words left = app.remaining(true);
  left.erase(std::remove(left.begin(), left.end(), "--"), left.end());
  return left;
}

Words::const_iterator unknownOptionIn(const Words& left) {
  return std::find_if(left.begin(), left.end(),
                      [](const std::string& word) { return word.size() > 1 && word.front() == '-'; });
}

std::string tellLeft(const CLI::App& app, const Words& left) {
  const auto unknown = unknownOptionIn(left);
  if (unknown == left.end()) {
    return "unexpected argument " + inQuotes(left.front()) +
           ": no option before it takes it; a value with blanks needs quotes";
  }
  Words known;
  for (const CLI::App* level : levelsOf(app)) {
    const Words names = namesOf(*level);
    known.insert(known.end(), names.begin(), names.end());
  }
  const std::string meant = nearestOf(unknown->substr(0, unknown->find('=')), known);
  return "there is no option " + inQuotes(*unknown) + (meant.empty() ? "" : "; " + meant + " is near");
}

/// An option without its value, or one too often: CLI11 tells of both in numbers of arguments.
std::string tellMismatch(const CLI::App& app, const std::string& told) {
  const std::string name = told.substr(0, told.find(':'));
  const CLI::Option* option = optionNamed(app, name);
  if (option == nullptr) return told;
  if (option->count() > 1) {
    return name + ": is given " + std::to_string(option->count()) + " times; allowed: once";
  }
  return name + ": has no value; it takes: " + option->get_description();
}

std::string tell(const CLI::App* app, const CLI::Error& error) {
  std::string text = error.what();
  const Words left = leftOf(*app);
  if (dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr && !left.empty()) text = tellLeft(*app, left);
  if (dynamic_cast<const CLI::ArgumentMismatch*>(&error) != nullptr) text = tellMismatch(*app, text);
  // What the library says has the words as they were given.
  const std::string program = app->get_name().empty() ? "" : app->get_name() + ": ";
  return program + foreignText(text, kLongestFault) + "\nRun with --help to see what is allowed.\n";
}

bool hasSubcommands(const CLI::App& app) {
  return levelsOf(app).size() > 1;
}

/// Throws what is wrong with the words, by name.
void checkSubcommand(const CLI::App& app) {
  const Words left = leftOf(app);
  const bool is_given = !app.get_subcommands().empty();
  const bool is_option = !left.empty() && left.front().compare(0, 1, "-") == 0;
  if (!left.empty() && (is_given || is_option)) throw CLI::ExtrasError(left);
  if (is_given) return;
  std::string known;
  for (const CLI::App* subcommand : app.get_subcommands({})) {
    known += (known.empty() ? "" : ", ") + subcommand->get_name();
  }
  const std::string found =
      left.empty() ? "no subcommand is given" : "there is no subcommand " + inQuotes(left.front());
  throw CLI::ParseError(found + "; allowed: " + known, CLI::ExitCodes::RequiredError);
}

/// Something is missing: a word that was misspelt is why, if there is such, and CLI11 comes to it last.
bool isMissing(const CLI::ParseError& error) {
  return dynamic_cast<const CLI::RequiredError*>(&error) != nullptr ||
         dynamic_cast<const CLI::RequiresError*>(&error) != nullptr;
}

int endWith(const CLI::App& app, const CLI::ParseError& error) {
  return app.exit(error) == 0 ? 0 : kBadUsage;
}

/// CLI11 has a subcommand that is asked for behind its parser as one that can be left out.
class Formatter : public CLI::Formatter {
 public:
  std::string make_usage(const CLI::App* app, std::string name) const override {
    constexpr std::string_view kOptional = "[SUBCOMMAND]";
    std::string usage = CLI::Formatter::make_usage(app, std::move(name));
    if (const std::size_t at = usage.find(kOptional); at != std::string::npos) {
      usage.replace(at, kOptional.size(), "SUBCOMMAND");
    }
    return usage;
  }
};

}  // namespace

void nameProgram(CLI::App& app, const std::string& name) {
  app.name(name);
  app.formatter(std::make_shared<Formatter>());
  app.set_version_flag("--version", name + " (cobot_command) " + std::string(capabilities::layerVersion()),
                       "Print the version and exit");
}

void askForSubcommand(CLI::App& app) {
  app.require_subcommand(0, 1);
  app.allow_extras();
}

std::optional<int> readCommandLine(CLI::App& app, std::vector<std::string> words,
                                   const std::function<void()>& behind_all) {
  app.failure_message(tell);
  try {
    words = prepared(app, words);
    std::reverse(words.begin(), words.end());  // as CLI11 wants them
    app.parse(std::move(words));
    if (hasSubcommands(app)) checkSubcommand(app);
    behind_all();
  } catch (const CLI::ParseError& error) {
    const Words left = leftOf(app);
    const bool is_unknown = isMissing(error) && unknownOptionIn(left) != left.end();
    return is_unknown ? endWith(app, CLI::ExtrasError(left)) : endWith(app, error);
  }
  return std::nullopt;
}

std::vector<std::string> wordsOf(int argc, char** argv) {
  return {argv + std::min(argc, 1), argv + argc};
}

}  // namespace cobot_command::tools
