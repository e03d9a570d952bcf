#include "robot_functions.h"

#include <algorithm>
#include <array>
#include <variant>

#include "call_arguments.h"
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cobot_command/common/overloaded.h"
#include "cobot_command/protocol/script_formats.h"

namespace cobot_command::simulator {

namespace {

using protocol::ScriptCommand;
using tm_script::Scalar;
namespace formats = protocol::formats;

ScriptCommand makePtp(CallArguments& arguments) {
  protocol::Ptp ptp{arguments.format(), arguments.numbers<6>(), arguments.motionOptions(), {}};
  ptp.options.disable_precise_positioning = arguments.boolean();
  if (arguments.more()) ptp.pose_bits = arguments.integers<3>();
  return ptp;
}

/// Line, Move_PTP and Move_Line.
template <class Motion>
ScriptCommand makeMotion(CallArguments& arguments) {
  Motion motion{arguments.format(), arguments.numbers<6>(), arguments.motionOptions()};
  motion.options.disable_precise_positioning = arguments.boolean();
  return motion;
}

ScriptCommand makeCircle(CallArguments& arguments) {
  protocol::Circle circle;
  circle.format = arguments.format();
  circle.via = arguments.numbers<6>();
  circle.end = arguments.numbers<6>();
  circle.options = arguments.motionOptions();
  circle.arc_angle = arguments.integer();
  circle.options.disable_precise_positioning = arguments.boolean();
  return circle;
}

ScriptCommand makeChangeBase(CallArguments& arguments) {
  if (arguments.nextIsText()) return protocol::ChangeBase{arguments.text()};
  return protocol::ChangeBase{arguments.numbers<6>()};
}

ScriptCommand makeChangeTcp(CallArguments& arguments) {
  if (arguments.nextIsText()) return protocol::ChangeTcp{arguments.text(), {}, {}};
  protocol::ChangeTcp change{arguments.numbers<6>(), {}, {}};
  if (arguments.more()) change.weight = arguments.number();
  if (arguments.more()) {
    const auto nine = arguments.numbers<9>();
    change.inertia.emplace();
    std::copy_n(nine.begin(), 3, change.inertia->moment.begin());
    std::copy_n(nine.begin() + 3, 6, change.inertia->mass_center.begin());
  }
  return change;
}

ScriptCommand makeChangeLoad(CallArguments& arguments) {
  return protocol::ChangeLoad{arguments.number()};
}

ScriptCommand makeQueueTag(CallArguments& arguments) {
  const int tag = arguments.integer();
  return protocol::QueueTag{tag, arguments.more() && arguments.integer() == 1};
}

ScriptCommand makeWaitQueueTag(CallArguments& arguments) {
  protocol::WaitQueueTag wait{arguments.integer(), {}};
  if (arguments.more()) wait.timeout = arguments.integer();
  return wait;
}

/// StopAndClearBuffer and ScriptExit.
template <class Command>
ScriptCommand makeWithMode(CallArguments& arguments) {
  Command command;
  if (arguments.more()) command.mode = arguments.integer();
  return command;
}

/// PLine and Move_PLine.
template <class Motion>
ScriptCommand makeChained(CallArguments& arguments) {
  return Motion{arguments.format(), arguments.numbers<6>(), arguments.motionOptions()};
}

ScriptCommand makePvtEnter(CallArguments& arguments) {
  return protocol::PvtEnter{arguments.more() && arguments.integer() == 1};
}

ScriptCommand makePvtPoint(CallArguments& arguments) {
  return protocol::PvtPoint{arguments.numbers<6>(), arguments.numbers<6>(), arguments.number()};
}

ScriptCommand makeContinueVLine(CallArguments& arguments) {
  return protocol::ContinueVLine{arguments.integer(), arguments.integer()};
}

/// SetContinueVJog and SetContinueVLine.
template <class Command>
ScriptCommand makeVelocity(CallArguments& arguments) {
  return Command{arguments.numbers<6>()};
}

template <class Command>
ScriptCommand makePlain(CallArguments&) {
  return Command{};
}

struct Formats {
  const std::string_view* first = nullptr;
  std::size_t count = 0;

  Formats() = default;
  template <std::size_t N>
  Formats(const std::array<std::string_view, N>& all) : first(all.data()), count(N) {}  // NOLINT: a view
  [[nodiscard]] const std::string_view* begin() const { return first; }
  [[nodiscard]] const std::string_view* end() const { return first + count; }
};

struct RobotFunction {
  /// p6 stands for six numbers or an array of six; so do p9, and i3 for integers.
  std::string_view declaration;
  tm_script::Version since;
  Formats formats;
  ScriptCommand (*make)(CallArguments&);

  [[nodiscard]] std::string_view name() const {
    const std::size_t blank = declaration.find(' ');
    return declaration.substr(blank + 1, declaration.find('(') - blank - 1);
  }
};

const std::vector<RobotFunction>& robotFunctions() {
  using namespace protocol;
  static const std::vector<RobotFunction> kFunctions{
      {"bool PTP(string, p6, int, int, int, bool)", {1, 68}, formats::kPtp, makePtp},
      {"bool PTP(string, p6, int, int, int, bool, i3)", {1, 68}, formats::kPtp, makePtp},
      {"bool Line(string, p6, int, int, int, bool)", {1, 68}, formats::kLine, makeMotion<Line>},
      {"bool Circle(string, p6, p6, int, int, int, int, bool)", {1, 68}, formats::kCircle, makeCircle},
      {"bool Move_PTP(string, p6, int, int, int, bool)", {1, 68}, formats::kMovePtp, makeMotion<MovePtp>},
      {"bool Move_Line(string, p6, int, int, int, bool)", {1, 68}, formats::kMoveLine, makeMotion<MoveLine>},
      {"bool ChangeBase(string)", {1, 68}, {}, makeChangeBase},
      {"bool ChangeBase(p6)", {1, 68}, {}, makeChangeBase},
      {"bool ChangeTCP(string)", {1, 68}, {}, makeChangeTcp},
      {"bool ChangeTCP(p6)", {1, 68}, {}, makeChangeTcp},
      {"bool ChangeTCP(p6, double)", {1, 68}, {}, makeChangeTcp},
      {"bool ChangeTCP(p6, double, p9)", {1, 68}, {}, makeChangeTcp},
      {"bool ChangeLoad(double)", {1, 68}, {}, makeChangeLoad},
      {"bool ScriptExit()", {1, 68}, {}, makeWithMode<ScriptExit>},
      {"bool ScriptExit(literal int)", {1, 82}, {}, makeWithMode<ScriptExit>},
      {"bool StopAndClearBuffer()", {1, 72}, {}, makeWithMode<StopAndClearBuffer>},
      {"bool StopAndClearBuffer(literal int)", {1, 82}, {}, makeWithMode<StopAndClearBuffer>},
      {"bool Pause()", {1, 72}, {}, makePlain<Pause>},
      {"bool Resume()", {1, 72}, {}, makePlain<Resume>},
      {"bool QueueTag(int, int?)", {1, 76}, {}, makeQueueTag},
      {"int WaitQueueTag(int, int?)", {1, 76}, {}, makeWaitQueueTag},
      {"bool PLine(string, p6, int, int, int)", {1, 68}, formats::kPLine, makeChained<PLine>},
      {"bool Move_PLine(string, p6, int, int, int)", {1, 68}, formats::kMovePLine, makeChained<MovePLine>},
      {"bool PVTEnter(int?)", {1, 72}, {}, makePvtEnter},
      {"bool PVTPoint(p6, p6, double)", {1, 72}, {}, makePvtPoint},
      {"bool PVTExit()", {1, 72}, {}, makePlain<PvtExit>},
      {"bool PVTPause()", {1, 72}, {}, makePlain<PvtPause>},
      {"bool PVTResume()", {1, 72}, {}, makePlain<PvtResume>},
      {"bool ContinueVJog()", {1, 68}, {}, makePlain<ContinueVJog>},
      {"bool ContinueVLine(int, int)", {1, 68}, {}, makeContinueVLine},
      {"bool SetContinueVJog(p6)", {1, 68}, {}, makeVelocity<SetContinueVJog>},
      {"bool SetContinueVLine(p6)", {1, 68}, {}, makeVelocity<SetContinueVLine>},
      {"bool StopContinueVmode()", {1, 68}, {}, makePlain<StopContinueVmode>},
      {"bool SuspendContinueVmode()", {1, 68}, {}, makePlain<SuspendContinueVmode>},
  };
  return kFunctions;
}

const RobotFunction* find(std::string_view name) {
  const auto& all = robotFunctions();
  const auto found = std::find_if(all.begin(), all.end(), [&](const auto& f) { return f.name() == name; });
  return found == all.end() ? nullptr : &*found;
}

void declareForms(tm_script::FunctionTable& functions, const std::string& declaration,
                  tm_script::Version since) {
  static const std::array<std::array<std::string_view, 3>, 3> kShort{
      {{"p6", "6 double", "double[6]"}, {"p9", "9 double", "double[9]"}, {"i3", "3 int", "int[3]"}}};
  for (const auto& [mark, apart, array] : kShort) {
    const std::size_t at = declaration.find(mark);
    if (at == std::string::npos) continue;
    for (const std::string_view form : {apart, array}) {
      declareForms(functions, std::string(declaration).replace(at, mark.size(), form), since);
    }
    return;
  }
  functions.declare(declaration, since);
}

std::optional<std::string> wrongFormat(const RobotFunction& function, const std::string& format) {
  const Formats& allowed = function.formats;
  if (std::find(allowed.begin(), allowed.end(), format) != allowed.end()) return std::nullopt;
  return fmt::format("{} takes the formats {}", function.name(),
                     fmt::join(allowed.begin(), allowed.end(), ", "));
}

/// Has a PTP more arguments than the form without pose bits, in either way to write its target?
bool hasPoseBits(std::size_t arguments) {
  constexpr std::size_t kApart = 11, kArray = 6;
  return arguments != kApart && arguments != kArray;
}

std::optional<std::string> outside(std::string_view what, const std::optional<Scalar>& argument, int least,
                                   int most) {
  if (!argument) return std::nullopt;
  const auto number = std::visit(Overloaded{[](std::uint8_t byte) { return std::optional<int>(byte); },
                                            [](std::int32_t integer) { return std::optional<int>(integer); },
                                            [](const auto&) { return std::optional<int>(); }},
                                 *argument);
  if (!number || (*number >= least && *number <= most)) return std::nullopt;
  return fmt::format("{} is {} to {}, not {}", what, least, most, *number);
}

}  // namespace

void declareRobotFunctions(tm_script::FunctionTable& functions) {
  for (const RobotFunction& function : robotFunctions()) {
    declareForms(functions, std::string(function.declaration), function.since);
  }
  functions.declare("int ListenSend(int, any)", {1, 76});
  functions.declare("int ListenSend(int, any[])", {1, 76});
}

std::optional<std::string> objectionTo(const std::string& function,
                                       const std::vector<std::optional<Scalar>>& arguments) {
  constexpr int kLastTag = 15;
  const RobotFunction* known = find(function);
  if (known == nullptr) return std::nullopt;
  const auto* format =
      known->formats.count > 0 && arguments[0] ? std::get_if<std::string>(&*arguments[0]) : nullptr;
  if (format != nullptr) {
    if (auto wrong = wrongFormat(*known, *format)) return wrong;
    if (function == "PTP" && hasPoseBits(arguments.size()) && *format != formats::kWithPoseBits) {
      return fmt::format("a pose is for {} only", formats::kWithPoseBits);
    }
  }
  if (function == "QueueTag") {
    if (auto wrong = outside("the tag", arguments[0], 1, kLastTag)) return wrong;
    if (arguments.size() > 1) return outside("whether to wait", arguments[1], 0, 1);
  }
  if (function == "PVTEnter" && !arguments.empty()) return outside("the mode", arguments[0], 0, 1);
  if (function == "StopAndClearBuffer" && !arguments.empty()) return outside("the mode", arguments[0], 0, 2);
  if (function == "ScriptExit" && !arguments.empty()) return outside("the mode", arguments[0], 0, 1);
  return std::nullopt;
}

ScriptCommand commandOf(const std::string& function, const tm_script::Arguments& arguments) {
  CallArguments reader(arguments);
  return find(function)->make(reader);
}

bool isQueued(std::string_view function) {
  constexpr std::array<std::string_view, 11> kImmediate{"WaitQueueTag",
                                                        "StopAndClearBuffer",
                                                        "Pause",
                                                        "Resume",
                                                        "ScriptExit",
                                                        "PVTPause",
                                                        "PVTResume",
                                                        "SetContinueVJog",
                                                        "SetContinueVLine",
                                                        "StopContinueVmode",
                                                        "SuspendContinueVmode"};
  return find(function) != nullptr &&
         std::find(kImmediate.begin(), kImmediate.end(), function) == kImmediate.end();
}

bool isQueued(const ScriptCommand& command) {
  using namespace protocol;
  return std::visit(
      Overloaded{[](const WriteOutput& write) { return !write.instant; },
                 [](const WaitQueueTag&) { return false; }, [](const StopAndClearBuffer&) { return false; },
                 [](const Pause&) { return false; }, [](const Resume&) { return false; },
                 [](const ScriptExit&) { return false; }, [](const PvtPause&) { return false; },
                 [](const PvtResume&) { return false; }, [](const SetContinueVJog&) { return false; },
                 [](const SetContinueVLine&) { return false; },
                 [](const StopContinueVmode&) { return false; },
                 [](const SuspendContinueVmode&) { return false; }, [](const auto&) { return true; }},
      command);
}

bool needsLicence(std::string_view function) {
  return function.find("ContinueV") != std::string_view::npos && find(function) != nullptr;
}

}  // namespace cobot_command::simulator
