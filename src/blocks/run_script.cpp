// What a raw script must not hold, so that the layer still knows its queue tags and its Listen node.

#include "cobot_command/blocks/run_script.h"

#include <algorithm>
#include <cstddef>
#include <string_view>

#include "shared/parameter_checks.h"
#include <fmt/format.h>

#include "cobot_command/blocks/shared/error_ids.h"
#include "cobot_command/script/script_reader.h"
#include "cobot_command/tm_script/open_end.h"
#include "cobot_command/tm_script/parser.h"

namespace cobot_command::blocks {
namespace {

constexpr std::size_t kMaxScript = 4096;
constexpr double kMinReplyTimeout = 0.05;
constexpr double kMaxReplyTimeout = 3600;

constexpr const char* kBlanks = " \t";

struct Line {
  int number = 1;  ///< from 1, empty lines count
  std::string_view text;
};

/// Those that are not blank. Separators: CR LF or LF.
std::vector<Line> split(std::string_view script) {
  std::vector<Line> lines;
  for (int number = 1; !script.empty(); ++number) {
    const std::size_t end = std::min(script.find('\n'), script.size());
    std::string_view text = script.substr(0, end);
    script.remove_prefix(std::min(end + 1, script.size()));
    if (!text.empty() && text.back() == '\r') text.remove_suffix(1);
    if (text.find_first_not_of(kBlanks) != std::string_view::npos) lines.push_back({number, text});
  }
  return lines;
}

bool isWordCharacter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
}

/// StopAndClearBuffer or ScriptExit with a number: from TMflow 1.82 on handled at once, and nothing else of
/// its frame is executed.
bool isPriority(std::string_view line) {
  for (const std::string_view name : {"StopAndClearBuffer", "ScriptExit"}) {
    for (auto at = line.find(name); at != std::string_view::npos; at = line.find(name, at + 1)) {
      const auto open = line.find_first_not_of(kBlanks, at + name.size());
      if (open == std::string_view::npos || line[open] != '(') continue;
      const auto inside = line.find_first_not_of(kBlanks, open + 1);
      if (inside != std::string_view::npos && line[inside] != ')') return true;
    }
  }
  return false;
}

/// The word in any case, anywhere: whether it stands in a text, a comment or a call is not told apart, as it
/// is not known which of them the controller's version has.
bool hasWord(std::string_view line, std::string_view word) {
  const auto same = [](char a, char b) { return (a | 0x20) == (b | 0x20); };
  for (auto at = line.begin();; ++at) {
    at = std::search(at, line.end(), word.begin(), word.end(), same);
    if (at == line.end()) return false;
    const auto behind = at + static_cast<std::ptrdiff_t>(word.size());
    const bool begins = at == line.begin() || !isWordCharacter(*(at - 1));
    if (begins && (behind == line.end() || !isWordCharacter(*behind))) return true;
  }
}

bool isScriptExit(const Line& line) {
  const auto parsed = tm_script::parse(line.text);
  if (!parsed.faults.empty() || parsed.statements.size() != 1) return false;
  const auto* expression = std::get_if<tm_script::Expression>(&parsed.statements.front().content);
  const auto* call = expression == nullptr ? nullptr : std::get_if<tm_script::Call>(&expression->node);
  return call != nullptr && call->function == "ScriptExit" && call->arguments.empty();
}

bool endsWithScriptExit(const std::vector<Line>& lines) {
  return !lines.empty() && isScriptExit(lines.back());
}

/// The lines as they stood in the script, empty ones too; without what the layer sends behind them.
std::string withoutExit(std::vector<Line> lines) {
  if (endsWithScriptExit(lines)) lines.pop_back();
  std::string text;
  int number = 1;
  for (const Line& line : lines) {
    text.append(static_cast<std::size_t>(line.number - number), '\n').append(line.text);
    number = line.number;
  }
  return text;
}

/// What is wrong with the script, at its first faulty line; empty: nothing.
std::string faultOf(const std::string& script, bool await_motion) {
  if (script.size() > kMaxScript) return fmt::format("it has {} bytes", script.size());
  const std::vector<Line> lines = split(script);
  if (lines.empty()) return "it is empty";
  for (const Line& line : lines) {
    if (!script::isScriptLine(line.text)) {
      return fmt::format("line {} has control characters, or is not UTF-8", line.number);
    }
    for (const char* word : {"QueueTag", "WaitQueueTag"}) {
      if (hasWord(line.text, word)) {
        return fmt::format("line {} has {}: only the command layer sets queue tags, see await_motion",
                           line.number, word);
      }
    }
    if (isScriptExit(line) && line.number != lines.back().number) {
      return fmt::format("the lines after line {}, ScriptExit(), would never run", line.number);
    }
    if (isPriority(line.text) && (lines.size() > 1 || await_motion)) {
      return fmt::format(
          "line {} is a priority command, which the controller executes alone, without the other lines and "
          "without the queue tag of await_motion",
          line.number);
    }
  }
  // Else the controller would read the queue tag, or the exit, as part of it, and never report it.
  return tm_script::openEndOf(withoutExit(lines)).value_or("");
}

/// Without line ends, without empty ones, and without what the layer sends behind them.
std::vector<std::string> linesOf(const RunScriptGoal& goal) {
  std::vector<Line> lines = split(goal.script);
  if (endsWithScriptExit(lines)) lines.pop_back();
  std::vector<std::string> texts;
  texts.reserve(lines.size());
  for (const Line& line : lines) texts.emplace_back(line.text);
  return texts;
}

/// ContinueVJog(), SetContinueVLine() and the like move the arm for as long as nothing else comes, also
/// behind a queue tag. Looked for in the text, as not every script can be read.
bool setsVelocities(const std::vector<std::string>& lines) {
  return std::any_of(lines.begin(), lines.end(),
                     [](const std::string& line) { return line.find("ContinueV") != std::string::npos; });
}

/// Resume(), PVTResume(): looked for in the text, too.
bool letsGo(const std::vector<std::string>& lines) {
  return std::any_of(lines.begin(), lines.end(), [](const std::string& line) {
    return hasWord(line, "Resume") || hasWord(line, "PVTResume");
  });
}

/// Pause(), and not PVTPause(), which holds a PVT alone and is not shown as a pause.
bool pauses(const std::string& line) {
  for (std::size_t at = line.find("Pause("); at != std::string::npos; at = line.find("Pause(", at + 1)) {
    if (at == 0 || line.compare(at - 1, 1, "T") != 0) return true;
  }
  return false;
}

}  // namespace

ErrorTable RunScriptGoal::errors() {
  return ErrorTable()
      .anyCommand()
      .remedy(motion_error::kRejected,
              "Correct the lines that the description names; unchanged they fail again")
      .turn()
      .underInterface()
      .inCell()
      .motion()
      .row(own_error::kScriptInvalid, "Script invalid",
           "Give lines of printable text, together at most 4096 bytes, without queue tags; close each text, "
           "comment and bracket; send a StopAndClearBuffer or ScriptExit with a number alone, without "
           "await_motion",
           "script is empty, too long, or not UTF-8; or a line has control characters or the word QueueTag "
           "or WaitQueueTag; or lines follow a ScriptExit(); or a StopAndClearBuffer or ScriptExit with a "
           "number, which the controller executes alone, has lines or await_motion with it; or a text is not "
           "closed in its line, a comment or bracket not in the script: the layer's own lines after it would "
           "be read as part of it")
      .row(own_error::kReplyTimeoutRange, "ReplyTimeout range: 0.05~3600 s, or 0", kSetInRange,
           "reply_timeout is neither 0 (that of the link) nor 0.05..3600");
}

GoalTraits traitsOf(const RunScriptGoal& goal) {
  GoalTraits traits;
  traits.buffer_mode = bufferModeOf(goal.buffer_mode);
  traits.may_move = true;
  traits.ends_blend = true;
  traits.awaits_motion = goal.await_motion;
  // A longer one is refused, and not read.
  traits.exits_node = goal.script.size() <= kMaxScript && endsWithScriptExit(split(goal.script));
  if (goal.reply_timeout > 0) traits.reply_timeout = fromSeconds(goal.reply_timeout);
  return traits;
}

std::vector<Failure> check(const RunScriptGoal& goal) {
  ParameterChecks checks;
  checks.bufferMode(goal.buffer_mode);
  const std::string fault = faultOf(goal.script, goal.await_motion);
  checks.require(fault.empty(), own_error::kScriptInvalid, fault);
  checks.require(goal.reply_timeout == 0 || isWithin(goal.reply_timeout, kMinReplyTimeout, kMaxReplyTimeout),
                 own_error::kReplyTimeoutRange, fmt::format("reply_timeout is {} s", goal.reply_timeout));
  return std::move(checks).violations();
}

Order orderOf(const RunScriptGoal& goal, const arm::Pose& /*base*/) {
  Order order;
  order.moves = true;
  order.lines = linesOf(goal);
  order.stands_at_end = !setsVelocities(order.lines);
  order.lets_go = letsGo(order.lines);
  order.pauses = std::any_of(order.lines.begin(), order.lines.end(), pauses);
  if (const auto read = script::readScript(fmt::format("{}", fmt::join(order.lines, "\r\n")))) {
    order.commands.emplace();
    for (const auto& [line, command] : *read) order.commands->push_back(command);
    order.has_exit =
        !order.commands->empty() && std::holds_alternative<script::ScriptExit>(order.commands->back());
  }
  return order;
}

}  // namespace cobot_command::blocks
