// PTP, Line, Circle, PLine and their relative ones.

#include <cassert>
#include <utility>

#include "function_row.h"
#include <fmt/format.h>

namespace cobot_command::script {
namespace {

/// The only format that takes pose configuration bits.
constexpr std::string_view kWithPoseBits = "CPP";

Ptp makePtp(CallArguments& arguments) {
  Ptp ptp{arguments.format(), arguments.numbers<6>(), arguments.motionOptions(), {}};
  ptp.options.disable_precise_positioning = arguments.boolean();
  if (arguments.more()) ptp.pose_bits = arguments.integers<3>();
  return ptp;
}

void writePtp(CallText& text, const Ptp& ptp) {
  assert(!ptp.pose_bits || ptp.format.text() == kWithPoseBits);
  text << ptp.format << ptp.target;
  text.addOptions(ptp.options).addFlag(ptp.options.disable_precise_positioning) << ptp.pose_bits;
}

/// Has a PTP more arguments than the form without pose bits, in either way to write its target?
bool hasPoseBits(std::size_t arguments) {
  constexpr std::size_t kApart = 11, kArray = 6;
  return arguments != kApart && arguments != kArray;
}

std::optional<std::string> poseWithoutUse(const KnownArguments& arguments) {
  const auto* format = arguments[0] ? std::get_if<std::string>(&*arguments[0]) : nullptr;
  if (format == nullptr || *format == kWithPoseBits || !hasPoseBits(arguments.size())) return std::nullopt;
  return fmt::format("a pose is for {} only", kWithPoseBits);
}

template <class Motion>
auto& sixOf(Motion& motion) {
  if constexpr (std::is_same_v<std::decay_t<Motion>, Line> || std::is_same_v<std::decay_t<Motion>, PLine>) {
    return motion.target;
  } else {
    return motion.offset;
  }
}

/// PLine and Move_PLine: nothing is said about precise positioning.
template <class Motion>
Motion makeChained(CallArguments& arguments) {
  Motion motion;
  motion.format = arguments.format();
  sixOf(motion) = arguments.numbers<6>();
  motion.options = arguments.motionOptions();
  return motion;
}

template <class Motion>
void writeChained(CallText& text, const Motion& motion) {
  text << motion.format << sixOf(motion);
  text.addOptions(motion.options);
}

/// Line, Move_PTP and Move_Line.
template <class Motion>
Motion makeMotion(CallArguments& arguments) {
  auto motion = makeChained<Motion>(arguments);
  motion.options.disable_precise_positioning = arguments.boolean();
  return motion;
}

template <class Motion>
void writeMotion(CallText& text, const Motion& motion) {
  writeChained(text, motion);
  text.addFlag(motion.options.disable_precise_positioning);
}

Circle makeCircle(CallArguments& arguments) {
  Circle circle;
  circle.format = arguments.format();
  circle.via = arguments.numbers<6>();
  circle.end = arguments.numbers<6>();
  circle.options = arguments.motionOptions();
  circle.arc_angle = arguments.integer();
  circle.options.disable_precise_positioning = arguments.boolean();
  return circle;
}

void writeCircle(CallText& text, const Circle& circle) {
  text << circle.format << circle.via << circle.end;
  text.addOptions(circle.options) << circle.arc_angle;
  text.addFlag(circle.options.disable_precise_positioning);
}

template <class Motion>
FunctionRow motionRow(std::string_view name, Formats formats) {
  return rowOf<Motion, makeMotion<Motion>, writeMotion<Motion>>(
      {"bool",
       name,
       {{"string, p6, int, int, int, bool", {1, 68}}},
       FunctionRow::Way::Queued,
       std::move(formats)});
}

template <class Motion>
FunctionRow chainedRow(std::string_view name, Formats formats) {
  return rowOf<Motion, makeChained<Motion>, writeChained<Motion>>(
      {"bool", name, {{"string, p6, int, int, int", {1, 68}}}, FunctionRow::Way::Queued, std::move(formats)});
}

}  // namespace

std::vector<FunctionRow> motionFunctions() {
  constexpr auto kQueued = FunctionRow::Way::Queued;
  FunctionRow ptp{
      "bool",
      "PTP",
      {{"string, p6, int, int, int, bool", {1, 68}}, {"string, p6, int, int, int, bool, i3", {1, 68}}},
      kQueued,
      {"JPP", "CPP"}};
  ptp.objection = poseWithoutUse;
  return {
      rowOf<Ptp, makePtp, writePtp>(std::move(ptp)),
      motionRow<Line>("Line", {"CPP", "CPR", "CAP", "CAR"}),
      rowOf<Circle, makeCircle, writeCircle>({"bool",
                                              "Circle",
                                              {{"string, p6, p6, int, int, int, int, bool", {1, 68}}},
                                              kQueued,
                                              {"CPP", "CAP"}}),
      motionRow<MovePtp>("Move_PTP", {"CPP", "TPP", "JPP"}),
      motionRow<MoveLine>("Move_Line", {"CPP", "CPR", "CAP", "CAR", "TPP", "TPR", "TAP", "TAR"}),
      chainedRow<PLine>("PLine", {"JAP", "CAP"}),
      chainedRow<MovePLine>("Move_PLine", {"CAP", "TAP", "JAP"}),
  };
}

}  // namespace cobot_command::script
