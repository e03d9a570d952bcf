// Script text and commands, tried on random ones. A failure prints the seed: RC_PARAMS="seed=..." repeats it.
#include <algorithm>
#include <cmath>

#include <gmock/gmock.h>
#include <rapidcheck/gtest.h>

#include "cobot_command/script/script_reader.h"

namespace cobot_command::script {
namespace {

using Bytes = std::string;

SixNumbers anySix() {
  SixNumbers six{};
  for (double& value : six) {
    value = *rc::gen::inRange(-2000000000, 2000000000) / 1e6 + *rc::gen::inRange(-9, 9) / 1e7;
  }
  return six;
}

MotionOptions anyOptions() {
  return {*rc::gen::arbitrary<int>(), *rc::gen::arbitrary<int>(), *rc::gen::arbitrary<int>(),
          *rc::gen::arbitrary<bool>()};
}

DataFormat anyFormat(const char* targets, const char* speeds, const char* blendings) {
  const auto letter = [](const Bytes& letters) { return *rc::gen::elementOf(letters); };
  return {static_cast<DataFormat::Target>(letter(targets)), static_cast<DataFormat::Speed>(letter(speeds)),
          static_cast<DataFormat::Blending>(letter(blendings))};
}

Bytes anyName() {
  return *rc::gen::nonEmpty(
      rc::gen::container<Bytes>(rc::gen::element('a', 'Z', '0', '"', ',', ')', '/', ' ', '$')));
}

template <class Value>
std::optional<Value> maybe(Value value) {
  return *rc::gen::arbitrary<bool>() ? std::optional<Value>(value) : std::nullopt;
}

ScriptCommand anyMotion() {
  switch (*rc::gen::inRange(0, 5)) {
    case 0:
      return Ptp{anyFormat("J", "P", "P"), anySix(), anyOptions(), {}};
    case 1:
      return Ptp{anyFormat("C", "P", "P"), anySix(), anyOptions(), maybe(std::array<int, 3>{0, 3, 5})};
    case 2:
      return Line{anyFormat("C", "PA", "PR"), anySix(), anyOptions()};
    case 3:
      return Circle{anyFormat("C", "PA", "P"), anySix(), anySix(), anyOptions(), *rc::gen::arbitrary<int>()};
    default:
      return MoveLine{anyFormat("CT", "PA", "PR"), anySix(), anyOptions()};
  }
}

ScriptCommand anyOutput() {
  if (*rc::gen::arbitrary<bool>()) {
    return WriteAnalogOutput{*rc::gen::inRange(-10000, 10001) / 1e3, *rc::gen::arbitrary<bool>()};
  }
  const auto module = *rc::gen::element(IoModule::ControlBox, IoModule::EndModule);
  return WriteOutput{module, *rc::gen::inRange(0, ioCount(module)), *rc::gen::arbitrary<bool>(),
                     *rc::gen::arbitrary<bool>()};
}

ScriptCommand anyCommand() {
  const double weight = *rc::gen::inRange(0, 20000) / 1e3;
  switch (*rc::gen::inRange(0, 12)) {
    case 0:
      return MovePtp{anyFormat("CTJ", "P", "P"), anySix(), anyOptions()};
    case 1:
      return ChangeBase{anySix()};
    case 2:
      return ChangeBase{anyName()};
    case 3:
      return ChangeTcp{anyName(), {}, {}};
    case 4:
      return ChangeTcp{anySix(), weight, maybe(ToolInertia{{1, 0.5, 0.25}, anySix()})};
    case 5:
      return ChangeLoad{weight};
    case 6:
      return QueueTag{*rc::gen::inRange(1, 16), *rc::gen::arbitrary<bool>()};
    case 7:
      return WaitQueueTag{*rc::gen::arbitrary<int>(), maybe(*rc::gen::arbitrary<int>())};
    case 8:
      return StopAndClearBuffer{maybe(*rc::gen::inRange(0, 3))};
    case 9:
      return ScriptExit{maybe(*rc::gen::inRange(0, 2))};
    case 10:
      return anyOutput();
    default:
      return anyMotion();
  }
}

/// The values of a command, in a row; enough to compare two of a kind.
std::vector<double> numbersOf(const ScriptCommand& command) {
  std::vector<double> numbers;
  const auto add = [&](const SixNumbers& six) { numbers.insert(numbers.end(), six.begin(), six.end()); };
  if (const auto* ptp = std::get_if<Ptp>(&command)) add(ptp->target);
  if (const auto* line = std::get_if<Line>(&command)) add(line->target);
  if (const auto* circle = std::get_if<Circle>(&command)) add(circle->via), add(circle->end);
  if (const auto* move = std::get_if<MovePtp>(&command)) add(move->offset);
  if (const auto* move = std::get_if<MoveLine>(&command)) add(move->offset);
  return numbers;
}

RC_GTEST_PROP(ScriptProperty, isReadAsItWasWritten, ()) {
  const ScriptCommand command = anyCommand();
  const Bytes text = toText(command);
  const auto commands = readScript(text);
  RC_ASSERT(commands.has_value());
  RC_ASSERT(commands->size() == 1U);
  const ScriptCommand& read = commands->front().command;
  RC_ASSERT(read.index() == command.index());
  RC_ASSERT(toText(read) == text);
  RC_ASSERT(text.find_first_of("\r\n") == Bytes::npos);
  const auto before = numbersOf(command);
  const auto after = numbersOf(read);
  for (std::size_t i = 0; i < before.size(); ++i) RC_ASSERT(std::abs(before[i] - after[i]) <= 0.51e-6);
}

RC_GTEST_PROP(ScriptProperty, ofManyLinesHasAsManyCommands, ()) {
  std::vector<ScriptCommand> script(*rc::gen::inRange<std::size_t>(0, 10));
  for (ScriptCommand& command : script) {
    do {
      command = anyCommand();
    } while (std::holds_alternative<ScriptExit>(command));  // nothing behind it is executed
  }
  const auto read = readScript(toText(script));
  RC_ASSERT(read.has_value());
  RC_ASSERT(read->size() == script.size());
  for (std::size_t i = 0; i < script.size(); ++i) {
    RC_ASSERT((*read)[i].line == static_cast<int>(i) + 1);
    RC_ASSERT(toText((*read)[i].command) == toText(script[i]));
  }
}

RC_GTEST_PROP(ScriptProperty, ofAnyTextIsCommandsOrFaultsOfItsLines, ()) {
  const auto token =
      rc::gen::oneOf(rc::gen::element<Bytes>("PTP(", "ChangeBase(", "QueueTag(", ")", "(", "\"", "\"CPP\"",
                                             ",", "{", "}", "1", "-1.5", "0x", "0b1", "true", "\r\n", "\n",
                                             "//", " ", "99999999999999999999", "1.", ".5", "_a"),
                     rc::gen::arbitrary<Bytes>());
  Bytes text;
  for (const Bytes& t : *rc::gen::container<std::vector<Bytes>>(token)) text += t;
  const int lines = 1 + static_cast<int>(std::count(text.begin(), text.end(), '\n'));
  const auto script = readScript(text);
  if (script) {
    for (const auto& [line, command] : *script) RC_ASSERT(readScript(toText(command)).has_value());
  } else {
    int last = 0;
    for (const tm_script::Fault& fault : script.error()) {
      RC_ASSERT(fault.line >= last && fault.line <= lines);
      RC_ASSERT(!fault.reason.empty());
      last = fault.line;
    }
  }
}

}  // namespace
}  // namespace cobot_command::script
