// Script text -> commands: which function takes which arguments (I848-E-03 chapter 8).
#include <algorithm>
#include <array>
#include <iterator>
#include <utility>

#include "characters.h"
#include "script_arguments.h"
#include "script_syntax.h"
#include <fmt/format.h>

#include "cobot_command/protocol/script_command.h"
#include "cobot_command/protocol/script_formats.h"

namespace cobot_command::protocol {

namespace {

constexpr const char* kPrecision = "precise positioning off";
constexpr int kLastTag = 15;

ScriptCommand readPtp(Arguments& arguments) {
  Ptp ptp;
  ptp.format = arguments.format(formats::kPtp);
  ptp.target = arguments.numbers<6>("target");
  ptp.options = arguments.motionOptions();
  ptp.options.disable_precise_positioning = arguments.boolean(kPrecision);
  if (arguments.more() && ptp.format.text() == formats::kWithPoseBits) ptp.pose_bits = arguments.poseBits();
  return ptp;
}

/// Line, Move_PTP and Move_Line, PLine and Move_PLine differ in the formats that they take; the last two have
/// no precise positioning.
template <class Motion, std::size_t N>
Motion readMotion(Arguments& arguments, const std::array<std::string_view, N>& allowed) {
  Motion motion;
  motion.format = arguments.format(allowed);
  const SixNumbers six = arguments.numbers<6>("target or offset");
  if constexpr (std::is_same_v<Motion, Line> || std::is_same_v<Motion, PLine>) {
    motion.target = six;
  } else {
    motion.offset = six;
  }
  motion.options = arguments.motionOptions();
  if constexpr (!std::is_same_v<Motion, PLine> && !std::is_same_v<Motion, MovePLine>) {
    motion.options.disable_precise_positioning = arguments.boolean(kPrecision);
  }
  return motion;
}

ScriptCommand readCircle(Arguments& arguments) {
  Circle circle;
  circle.format = arguments.format(formats::kCircle);
  circle.via = arguments.numbers<6>("via point");
  circle.end = arguments.numbers<6>("end point");
  circle.options = arguments.motionOptions();
  circle.arc_angle = arguments.integer("arc angle");
  circle.options.disable_precise_positioning = arguments.boolean(kPrecision);
  return circle;
}

ScriptCommand readChangeBase(Arguments& arguments) {
  if (arguments.nextIsText()) return ChangeBase{arguments.name("base")};
  return ChangeBase{arguments.numbers<6>("base")};
}

ScriptCommand readChangeTcp(Arguments& arguments) {
  if (arguments.nextIsText()) return ChangeTcp{arguments.name("TCP"), {}, {}};
  ChangeTcp change{arguments.numbers<6>("TCP"), {}, {}};
  if (arguments.more()) change.weight = arguments.number("weight");
  if (arguments.more()) {
    const auto nine = arguments.numbers<9>("moment of inertia and mass centre");
    change.inertia.emplace();
    std::copy_n(nine.begin(), 3, change.inertia->moment.begin());
    std::copy_n(nine.begin() + 3, 6, change.inertia->mass_center.begin());
  }
  return change;
}

ScriptCommand readQueueTag(Arguments& arguments) {
  QueueTag queue;
  queue.tag = arguments.integer("tag", 1, kLastTag);
  queue.wait = arguments.more() && arguments.integer("wait", 0, 1) == 1;
  return queue;
}

ScriptCommand readWaitQueueTag(Arguments& arguments) {
  WaitQueueTag wait;
  wait.tag = arguments.integer("tag");
  if (arguments.more()) wait.timeout = arguments.integer("timeout");
  return wait;
}

/// StopAndClearBuffer and ScriptExit.
template <class Command, int kLastMode>
ScriptCommand readWithMode(Arguments& arguments) {
  Command command;
  if (arguments.more()) command.mode = arguments.integer("mode", 0, kLastMode);
  return command;
}

ScriptCommand readWriteOutput(Arguments& arguments) {
  constexpr std::array<std::string_view, 2> kAttributes{"DO", "InstantDO"};
  WriteOutput write;
  write.module = static_cast<IoModule>(arguments.oneOf("module", Literal::Kind::Text, formats::kIoModules));
  write.instant = arguments.oneOf("attribute", Literal::Kind::Name, kAttributes) == 1;
  write.index = arguments.integer("output", 0, ioCount(write.module) - 1);
  write.on = arguments.integer("value", 0, 1) == 1;
  return write;
}

ScriptCommand readPvtEnter(Arguments& arguments) {
  return PvtEnter{arguments.more() && arguments.integer("mode", 0, 1) == 1};
}

ScriptCommand readPvtPoint(Arguments& arguments) {
  PvtPoint point;
  point.position = arguments.numbers<6>("position");
  point.velocity = arguments.numbers<6>("velocity");
  point.duration = arguments.number("duration");
  return point;
}

ScriptCommand readContinueVLine(Arguments& arguments) {
  ContinueVLine mode;
  mode.zero_timeout = arguments.integer("time to rest");
  mode.stop_timeout = arguments.integer("time to the end");
  return mode;
}

/// SetContinueVJog and SetContinueVLine.
template <class Command>
ScriptCommand readVelocity(Arguments& arguments) {
  return Command{arguments.numbers<6>("velocity")};
}

template <class Command>
ScriptCommand readPlain(Arguments&) {
  return Command{};
}

using Reader = ScriptCommand (*)(Arguments&);

constexpr std::array<std::pair<std::string_view, Reader>, 28> kReaders{{
    {"PTP", readPtp},
    {"Line", [](Arguments& a) -> ScriptCommand { return readMotion<Line>(a, formats::kLine); }},
    {"Circle", readCircle},
    {"Move_PTP", [](Arguments& a) -> ScriptCommand { return readMotion<MovePtp>(a, formats::kMovePtp); }},
    {"Move_Line", [](Arguments& a) -> ScriptCommand { return readMotion<MoveLine>(a, formats::kMoveLine); }},
    {"ChangeBase", readChangeBase},
    {"ChangeTCP", readChangeTcp},
    {"ChangeLoad", [](Arguments& a) -> ScriptCommand { return ChangeLoad{a.number("weight")}; }},
    {"QueueTag", readQueueTag},
    {"WaitQueueTag", readWaitQueueTag},
    {"StopAndClearBuffer", readWithMode<StopAndClearBuffer, 2>},
    {"Pause", readPlain<Pause>},
    {"Resume", readPlain<Resume>},
    {"ScriptExit", readWithMode<ScriptExit, 1>},
    {kAssignOutput, readWriteOutput},
    {"PLine", [](Arguments& a) -> ScriptCommand { return readMotion<PLine>(a, formats::kPLine); }},
    {"Move_PLine",
     [](Arguments& a) -> ScriptCommand { return readMotion<MovePLine>(a, formats::kMovePLine); }},
    {"PVTEnter", readPvtEnter},
    {"PVTPoint", readPvtPoint},
    {"PVTExit", readPlain<PvtExit>},
    {"PVTPause", readPlain<PvtPause>},
    {"PVTResume", readPlain<PvtResume>},
    {"ContinueVJog", readPlain<ContinueVJog>},
    {"ContinueVLine", readContinueVLine},
    {"SetContinueVJog", readVelocity<SetContinueVJog>},
    {"SetContinueVLine", readVelocity<SetContinueVLine>},
    {"StopContinueVmode", readPlain<StopContinueVmode>},
    {"SuspendContinueVmode", readPlain<SuspendContinueVmode>},
}};

std::string unknownFunction(std::string_view function) {
  std::string message = fmt::format("unknown function {}, known are", function);
  for (const auto& [name, reader] : kReaders) message.append(" ").append(name);
  return message;
}

Result<ScriptCommand, std::string> toCommand(const Call& call) {
  const auto known = std::find_if(kReaders.begin(), kReaders.end(),
                                  [&](const auto& entry) { return entry.first == call.function; });
  if (known == kReaders.end()) return refuse(unknownFunction(call.function));
  Arguments arguments(call.arguments);
  ScriptCommand command = known->second(arguments);
  if (const std::string fault = arguments.fault(); !fault.empty()) {
    return refuse(call.function + ": " + fault);
  }
  return command;
}

/// Nothing for a line without a command.
Result<std::optional<ScriptCommand>, std::string> readLine(std::string_view line) {
  const auto call = parseLine(line);
  if (!call) return refuse(call.error());
  if (!*call) return std::optional<ScriptCommand>();
  auto command = toCommand(**call);
  if (!command) return refuse(std::move(command.error()));
  return std::optional<ScriptCommand>(std::move(*command));
}

}  // namespace

Result<ScriptCommand, ScriptFault> parseCommand(std::string_view line) {
  auto command = readLine(line);
  if (!command) return refuse(ScriptFault{1, std::move(command.error())});
  if (!*command) return refuse(ScriptFault{1, "expected a command, found an empty line"});
  return std::move(**command);
}

Result<ParsedScript, std::vector<ScriptFault>> parseScript(std::string_view script) {
  ParsedScript parsed;
  std::vector<ScriptFault> faults;
  for (int number = 1; !script.empty(); ++number) {
    std::string_view line = takeUntil('\n', script);
    if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
    auto command = readLine(line);
    if (!command) {
      faults.push_back({number, std::move(command.error())});
    } else if (*command) {
      parsed.lines.push_back({number, std::move(**command)});
    }
  }
  if (!faults.empty()) return refuse(std::move(faults));
  return parsed;
}

}  // namespace cobot_command::protocol
