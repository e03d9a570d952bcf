// Base, tool and load.

#include <algorithm>
#include <cassert>
#include <utility>

#include "function_row.h"
#include <fmt/format.h>

#include "cobot_command/common/foreign_text.h"

namespace cobot_command::script {
namespace {

/// Of a base or TCP, when that is known to be one.
std::optional<std::string> badName(const KnownArguments& arguments) {
  const auto* name = arguments[0] ? std::get_if<std::string>(&*arguments[0]) : nullptr;
  if (name == nullptr || isName(*name)) return std::nullopt;
  return fmt::format("\"{}\" is not a name: a name has 1 to {} bytes of UTF-8 without control characters",
                     foreignText(*name, kQuoteLimit), kMaxNameLength);
}

ChangeBase makeChangeBase(CallArguments& arguments) {
  if (arguments.nextIsText()) return {arguments.text()};
  return {arguments.numbers<6>()};
}

void writeChangeBase(CallText& text, const ChangeBase& change) {
  std::visit([&](const auto& base) { text << base; }, change.base);
}

ChangeTcp makeChangeTcp(CallArguments& arguments) {
  if (arguments.nextIsText()) return {arguments.text(), {}, {}};
  ChangeTcp change{arguments.numbers<6>(), {}, {}};
  if (arguments.more()) change.weight = arguments.number();
  if (arguments.more()) {
    const auto nine = arguments.numbers<9>();
    change.inertia.emplace();
    std::copy_n(nine.begin(), 3, change.inertia->moment.begin());
    std::copy_n(nine.begin() + 3, 6, change.inertia->mass_center.begin());
  }
  return change;
}

void writeChangeTcp(CallText& text, const ChangeTcp& change) {
  assert(!change.weight || std::holds_alternative<SixNumbers>(change.tcp));
  assert(!change.inertia || change.weight);
  std::visit([&](const auto& tcp) { text << tcp; }, change.tcp);
  text << change.weight;
  if (change.inertia) text << change.inertia->moment << change.inertia->mass_center;
}

ChangeLoad makeChangeLoad(CallArguments& arguments) {
  return {arguments.number()};
}

void writeChangeLoad(CallText& text, const ChangeLoad& change) {
  text << change.weight;
}

}  // namespace

std::vector<FunctionRow> settingFunctions() {
  constexpr auto kQueued = FunctionRow::Way::Queued;
  FunctionRow base{"bool", "ChangeBase", {{"string", {1, 68}}, {"p6", {1, 68}}}, kQueued};
  base.objection = badName;
  FunctionRow tcp{
      "bool",
      "ChangeTCP",
      {{"string", {1, 68}}, {"p6", {1, 68}}, {"p6, double", {1, 68}}, {"p6, double, p9", {1, 68}}},
      kQueued};
  tcp.objection = badName;
  return {
      rowOf<ChangeBase, makeChangeBase, writeChangeBase>(std::move(base)),
      rowOf<ChangeTcp, makeChangeTcp, writeChangeTcp>(std::move(tcp)),
      rowOf<ChangeLoad, makeChangeLoad, writeChangeLoad>(
          {"bool", "ChangeLoad", {{"double", {1, 68}}}, kQueued}),
  };
}

}  // namespace cobot_command::script
