// Commands -> script text.
#include <algorithm>
#include <cassert>
#include <cmath>
#include <type_traits>

#include "characters.h"
#include <fmt/format.h>

#include "cobot_command/common/foreign_text.h"
#include "cobot_command/protocol/script_command.h"
#include "cobot_command/protocol/script_formats.h"

namespace cobot_command::protocol {

namespace {

/// As a whole number of millionths where that fits, which is much faster than to format a double.
void appendNumber(std::string& text, double value) {
  assert(std::isfinite(value));
  constexpr double kLimit = 9e15;
  constexpr unsigned long long kMillion = 1000000;
  const double millionths = std::round(value * kMillion);
  if (!(std::abs(millionths) < kLimit)) {
    text += fmt::format("{:.0f}", value);
    return;
  }
  const auto magnitude = static_cast<unsigned long long>(std::abs(millionths));
  if (millionths < 0) text += '-';
  text += std::string_view(fmt::format_int(magnitude / kMillion).c_str());
  if (magnitude % kMillion == 0) return;
  // The million in front keeps the zeros behind the point.
  text += std::string_view(fmt::format_int(kMillion + magnitude % kMillion).c_str());
  text[text.size() - 7] = '.';
  text.erase(text.find_last_not_of('0') + 1);
}

/// Name(argument,argument)
class CallText {
 public:
  explicit CallText(std::string_view function) {
    text_.reserve(128);
    text_.append(function) += '(';
  }

  template <class Integer, class = std::enable_if_t<std::is_same_v<Integer, int>>>
  CallText& operator<<(Integer value) {
    next() += std::string_view(fmt::format_int(value).c_str());
    return *this;
  }
  CallText& operator<<(double value) {
    appendNumber(next(), value);
    return *this;
  }
  CallText& operator<<(const DataFormat& format) { return *this << format.text(); }
  CallText& operator<<(const std::string& name) {
    appendQuoted(next(), name);
    return *this;
  }
  template <class Number, std::size_t N>
  CallText& operator<<(const std::array<Number, N>& numbers) {
    for (const Number value : numbers) *this << value;
    return *this;
  }
  template <class Value>
  CallText& operator<<(const std::optional<Value>& value) {
    return value ? *this << *value : *this;
  }
  CallText& addFlag(bool flag) {
    next() += flag ? "true" : "false";
    return *this;
  }
  CallText& addOptions(const MotionOptions& options) {
    return *this << options.speed << options.accel_time << options.blending;
  }

  [[nodiscard]] std::string str() && {
    text_ += ')';
    return std::move(text_);
  }

 private:
  /// The text, ready for the next argument.
  std::string& next() {
    if (text_.back() != '(') text_ += ',';
    return text_;
  }

  static void appendQuoted(std::string& text, std::string_view name) {
    assert(isName(name));
    text += '"';
    for (const char c : name) {
      if (isControl(c)) continue;  // a line end in a name must never begin another command
      if (c == '"') text += '"';
      text += c;
    }
    text += '"';
  }

  std::string text_;
};

template <std::size_t N>
CallText motion(std::string_view function, const DataFormat& format,
                const std::array<std::string_view, N>& allowed) {
  assert(formats::has(allowed, format.text()));
  static_cast<void>(allowed);
  CallText call(function);
  call << format;
  return call;
}

std::string text(const Ptp& ptp) {
  assert(!ptp.pose_bits || ptp.format.text() == formats::kWithPoseBits);
  CallText call = motion("PTP", ptp.format, formats::kPtp);
  call << ptp.target;
  call.addOptions(ptp.options).addFlag(ptp.options.disable_precise_positioning) << ptp.pose_bits;
  return std::move(call).str();
}
template <class Motion, std::size_t N>
std::string text(std::string_view function, const Motion& command, const SixNumbers& six,
                 const std::array<std::string_view, N>& allowed) {
  CallText call = motion(function, command.format, allowed);
  call << six;
  call.addOptions(command.options).addFlag(command.options.disable_precise_positioning);
  return std::move(call).str();
}
std::string text(const Line& line) {
  return text("Line", line, line.target, formats::kLine);
}
std::string text(const MovePtp& move) {
  return text("Move_PTP", move, move.offset, formats::kMovePtp);
}
std::string text(const MoveLine& move) {
  return text("Move_Line", move, move.offset, formats::kMoveLine);
}
template <class Motion, std::size_t N>
std::string chained(std::string_view function, const Motion& command, const SixNumbers& six,
                    const std::array<std::string_view, N>& allowed) {
  CallText call = motion(function, command.format, allowed);
  call << six;
  call.addOptions(command.options);
  return std::move(call).str();
}
std::string text(const PLine& line) {
  return chained("PLine", line, line.target, formats::kPLine);
}
std::string text(const MovePLine& move) {
  return chained("Move_PLine", move, move.offset, formats::kMovePLine);
}
std::string text(const PvtEnter& enter) {
  return std::move(CallText("PVTEnter") << (enter.cartesian ? 1 : 0)).str();
}
std::string text(const PvtPoint& point) {
  return std::move(CallText("PVTPoint") << point.position << point.velocity << point.duration).str();
}
std::string text(const PvtExit&) {
  return "PVTExit()";
}
std::string text(const PvtPause&) {
  return "PVTPause()";
}
std::string text(const PvtResume&) {
  return "PVTResume()";
}
std::string text(const ContinueVJog&) {
  return "ContinueVJog()";
}
std::string text(const ContinueVLine& mode) {
  return std::move(CallText("ContinueVLine") << mode.zero_timeout << mode.stop_timeout).str();
}
std::string text(const SetContinueVJog& set) {
  return std::move(CallText("SetContinueVJog") << set.velocity).str();
}
std::string text(const SetContinueVLine& set) {
  return std::move(CallText("SetContinueVLine") << set.velocity).str();
}
std::string text(const StopContinueVmode&) {
  return "StopContinueVmode()";
}
std::string text(const SuspendContinueVmode&) {
  return "SuspendContinueVmode()";
}
std::string text(const Circle& circle) {
  CallText call = motion("Circle", circle.format, formats::kCircle);
  call << circle.via << circle.end;
  call.addOptions(circle.options) << circle.arc_angle;
  call.addFlag(circle.options.disable_precise_positioning);
  return std::move(call).str();
}
std::string text(const ChangeBase& change) {
  CallText call("ChangeBase");
  std::visit([&](const auto& base) { call << base; }, change.base);
  return std::move(call).str();
}
std::string text(const ChangeTcp& change) {
  assert(!change.weight || std::holds_alternative<SixNumbers>(change.tcp));
  assert(!change.inertia || change.weight);
  CallText call("ChangeTCP");
  std::visit([&](const auto& tcp) { call << tcp; }, change.tcp);
  call << change.weight;
  if (change.inertia) call << change.inertia->moment << change.inertia->mass_center;
  return std::move(call).str();
}
std::string text(const ChangeLoad& change) {
  return std::move(CallText("ChangeLoad") << change.weight).str();
}
std::string text(const QueueTag& queue) {
  return std::move(CallText("QueueTag") << queue.tag << (queue.wait ? 1 : 0)).str();
}
std::string text(const WaitQueueTag& wait) {
  return std::move(CallText("WaitQueueTag") << wait.tag << wait.timeout).str();
}
std::string text(const StopAndClearBuffer& stop) {
  return std::move(CallText("StopAndClearBuffer") << stop.mode).str();
}
std::string text(const Pause&) {
  return "Pause()";
}
std::string text(const Resume&) {
  return "Resume()";
}
std::string text(const ScriptExit& exit) {
  return std::move(CallText("ScriptExit") << exit.mode).str();
}
std::string text(const WriteOutput& write) {
  assert(write.index >= 0 && write.index < ioCount(write.module));
  return fmt::format("IO[\"{}\"].{}[{}]={}", formats::kIoModules[static_cast<std::size_t>(write.module)],
                     write.instant ? "InstantDO" : "DO", write.index, write.on ? 1 : 0);
}

}  // namespace

std::string DataFormat::text() const {
  return {static_cast<char>(target), static_cast<char>(speed), static_cast<char>(blending)};
}

bool isName(std::string_view name) {
  return !name.empty() && name.size() <= kMaxNameLength && isUtf8(name) &&
         std::none_of(name.begin(), name.end(), isControl);
}

bool isScriptLine(std::string_view line) {
  return isUtf8(line) &&
         std::none_of(line.begin(), line.end(), [](char c) { return isControl(c) && c != '\t'; });
}

std::string toText(const ScriptCommand& command) {
  return std::visit([](const auto& value) { return text(value); }, command);
}

std::string toText(const std::vector<ScriptCommand>& script) {
  std::string lines;
  for (const ScriptCommand& command : script) {
    if (!lines.empty()) lines += "\r\n";
    lines += toText(command);
  }
  return lines;
}

}  // namespace cobot_command::protocol
