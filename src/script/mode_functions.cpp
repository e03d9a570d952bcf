// Modes of motion: PVT, and continuous velocities, which need a licence.

#include <utility>

#include "function_row.h"

namespace cobot_command::script {
namespace {

PvtEnter makePvtEnter(CallArguments& arguments) {
  return {arguments.more() && arguments.integer() == 1};
}

void writePvtEnter(CallText& text, const PvtEnter& enter) {
  text << (enter.cartesian ? 1 : 0);
}

PvtPoint makePvtPoint(CallArguments& arguments) {
  return {arguments.numbers<6>(), arguments.numbers<6>(), arguments.number()};
}

void writePvtPoint(CallText& text, const PvtPoint& point) {
  text << point.position << point.velocity << point.duration;
}

ContinueVLine makeContinueVLine(CallArguments& arguments) {
  return {arguments.integer(), arguments.integer()};
}

void writeContinueVLine(CallText& text, const ContinueVLine& mode) {
  text << mode.zero_timeout << mode.stop_timeout;
}

/// SetContinueVJog and SetContinueVLine.
template <class Command>
Command makeVelocity(CallArguments& arguments) {
  return {arguments.numbers<6>()};
}

template <class Command>
void writeVelocity(CallText& text, const Command& command) {
  text << command.velocity;
}

template <class Command>
FunctionRow velocityRow(std::string_view name) {
  FunctionRow row{"bool", name, {{"p6", {1, 68}}}, FunctionRow::Way::Immediate};
  row.licence = FunctionRow::Licence::Needed;
  return rowOf<Command, makeVelocity<Command>, writeVelocity<Command>>(std::move(row));
}

}  // namespace

std::vector<FunctionRow> modeFunctions() {
  using Way = FunctionRow::Way;
  constexpr auto kLicensed = FunctionRow::Licence::Needed;
  FunctionRow enter{"bool", "PVTEnter", {{"int?", {1, 72}}}, Way::Queued};
  enter.ranges = {{0, "the mode", 0, 1}};
  FunctionRow line{"bool", "ContinueVLine", {{"int, int", {1, 68}}}, Way::Queued};
  line.licence = kLicensed;
  return {
      rowOf<PvtEnter, makePvtEnter, writePvtEnter>(std::move(enter)),
      rowOf<PvtPoint, makePvtPoint, writePvtPoint>(
          {"bool", "PVTPoint", {{"p6, p6, double", {1, 72}}}, Way::Queued}),
      plainRow<PvtExit>("PVTExit", {1, 72}, Way::Queued),
      plainRow<PvtPause>("PVTPause", {1, 72}, Way::Immediate),
      plainRow<PvtResume>("PVTResume", {1, 72}, Way::Immediate),
      plainRow<ContinueVJog>("ContinueVJog", {1, 68}, Way::Queued, kLicensed),
      rowOf<ContinueVLine, makeContinueVLine, writeContinueVLine>(std::move(line)),
      velocityRow<SetContinueVJog>("SetContinueVJog"),
      velocityRow<SetContinueVLine>("SetContinueVLine"),
      plainRow<StopContinueVmode>("StopContinueVmode", {1, 68}, Way::Immediate, kLicensed),
      plainRow<SuspendContinueVmode>("SuspendContinueVmode", {1, 68}, Way::Immediate, kLicensed),
  };
}

}  // namespace cobot_command::script
