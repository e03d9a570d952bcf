// tm_arm: the kinematics of the arms at the command line; see doc/kinematics.md.
#include <algorithm>
#include <array>
#include <cmath>
#include <exception>
#include <functional>
#include <iostream>
#include <iterator>
#include <locale>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "../command_line.h"
#include "../written_output.h"
#include "answers.h"
#include <CLI/CLI.hpp>

#include "cobot_command/arm/arm_model.h"
#include "cobot_command/arm/urdf_prefix.h"
#include "cobot_command/common/foreign_text.h"

namespace {

using namespace cobot_command;
using Numbers = std::array<double, 6>;

constexpr int kSuccess = 0;
constexpr int kNegativeAnswer = 1;
using tools::kBadUsage;
/// Of numbers: what is wrong with them, their count too, is told by one place.
constexpr int kAnyCount = -1;

struct Arguments {
  std::string model;
  bool json = false;
  std::vector<std::string> numbers;
  std::string prefix;
};

std::optional<double> parseNumber(const std::string& text) {
  std::istringstream stream(text);
  stream.imbue(std::locale::classic());
  double number = 0;
  const bool whole = (stream >> number) && stream.peek() == std::istringstream::traits_type::eof();
  return whole && std::isfinite(number) ? std::make_optional(number) : std::nullopt;
}

std::optional<Numbers> parseNumbers(const std::vector<std::string>& words) {
  Numbers numbers{};
  if (words.size() != numbers.size()) return std::nullopt;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const auto number = parseNumber(words[i]);
    if (!number) return std::nullopt;
    numbers[i] = *number;
  }
  return numbers;
}

/// The words of the command line. A blank before a negative number keeps it from being taken for an option.
std::vector<std::string> numbersAndWordsOf(int argc, char** argv) {
  std::vector<std::string> words = tools::wordsOf(argc, argv);
  for (std::string& word : words) {
    if (word.rfind('-', 0) == 0 && parseNumber(word)) word.insert(0, " ");
  }
  return words;
}

using Question = std::function<tm_arm::Answer(const Numbers&)>;

int badNumbers(const std::string& found) {
  std::cerr << "tm_arm: found \"" << foreignText(found)
            << "\", but six finite numbers are needed. See tm_arm --help.\n";
  return kBadUsage;
}

/// An answer for each line of standard input; the worst of the exit codes.
int answerLines(const Question& ask) {
  int worst = kSuccess;
  for (std::string line; std::cout && std::getline(std::cin, line);) {
    std::istringstream stream(line);
    const std::vector<std::string> words(std::istream_iterator<std::string>(stream), {});
    const auto numbers = parseNumbers(words);
    if (!numbers) {
      worst = badNumbers(line);
      std::cout << std::endl;  // an answer a line, so that the caller does not lose count
      continue;
    }
    const tm_arm::Answer answer = ask(*numbers);
    std::cout << answer.text << std::endl;
    if (!answer.positive) worst = std::max(worst, kNegativeAnswer);
  }
  return worst;
}

int answerOnce(const std::vector<std::string>& words, const Question& ask) {
  if (words.size() == 1 && words[0] == "-") return answerLines(ask);
  const auto numbers = parseNumbers(words);
  if (!numbers) {
    std::string found;
    for (const std::string& word : words) {
      found += (found.empty() || word.rfind(' ', 0) == 0 ? "" : " ") + word;
    }
    return badNumbers(found);
  }
  const tm_arm::Answer answer = ask(*numbers);
  std::cout << answer.text << '\n';
  return answer.positive ? kSuccess : kNegativeAnswer;
}

int printUrdf(const Arguments& arguments) {
  const std::string& urdf = arm::ArmModel::urdfOf(arguments.model);
  if (arguments.prefix.empty()) {
    std::cout << urdf;
    return kSuccess;
  }
  // A prefix that looks like a number has the blank of numbersAndWordsOf().
  const bool has_blank = arguments.prefix.rfind(" -", 0) == 0;
  const auto renamed = arm::withPrefix(urdf, arguments.prefix.substr(has_blank ? 1 : 0));
  if (!renamed) {
    std::cerr << "tm_arm: --prefix: " << forPeople(renamed.error().message) << '\n';
    return kBadUsage;
  }
  std::cout << *renamed;
  return kSuccess;
}

void describe(CLI::App& app, Arguments& arguments) {
  app.add_option("--model", arguments.model, "Model of the arm")
      ->required()
      ->check(CLI::IsMember(arm::ArmModel::knownNames()));
  app.add_flag("--json", arguments.json, "Answer in JSON, in one line");
  app.footer(
      "With - in place of the six numbers, they are read from standard input: one set and one answer per "
      "line.\nExit code: 0 success, 1 out of reach, 2 bad usage, 3 the answer could not be written.");

  auto* fk = app.add_subcommand("fk", "Pose of the flange [mm, deg] for the joints J1..J6 [deg]");
  auto* ik = app.add_subcommand("ik", "All postures [deg] for a flange pose X Y Z [mm] RX RY RZ [deg]");
  fk->add_option("numbers", arguments.numbers, "J1 J2 J3 J4 J5 J6, or -")->required()->expected(1, kAnyCount);
  ik->add_option("numbers", arguments.numbers, "X Y Z RX RY RZ, or -")->required()->expected(1, kAnyCount);
  auto* urdf = app.add_subcommand("urdf", "The URDF of the model");
  urdf->add_option("--prefix", arguments.prefix, "Prefix of the name of every link and joint");
  for (auto* subcommand : {fk, ik}) subcommand->get_option("numbers")->type_name("FLOAT");
  for (auto* subcommand : {fk, ik, urdf}) subcommand->fallthrough();
  tools::askForSubcommand(app);
}

int run(int argc, char** argv) {
  CLI::App app{"Kinematics of the TM arms."};
  tools::nameProgram(app, "tm_arm");
  Arguments arguments;
  describe(app, arguments);
  if (const auto end = tools::readCommandLine(app, numbersAndWordsOf(argc, argv))) return *end;

  if (app.got_subcommand("urdf")) return printUrdf(arguments);
  const auto model = arm::ArmModel::named(arguments.model);
  if (!model) {
    std::cerr << "tm_arm: " << forPeople(model.error().message) << '\n';
    return kBadUsage;
  }
  const auto& solve = app.got_subcommand("fk") ? tm_arm::forward : tm_arm::inverse;
  return answerOnce(arguments.numbers, [&](const Numbers& n) { return solve(*model, n, arguments.json); });
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return tools::unlessOutputLost("tm_arm", run(argc, argv));
  } catch (const std::exception& error) {
    std::cerr << "tm_arm: " << cobot_command::forPeople(error.what()) << '\n';
    return kBadUsage;
  }
}
