#include "fault_line.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <optional>
#include <sstream>
#include <utility>

#include <fmt/format.h>

namespace cobot_command::testing {
namespace {

struct KindRow {
  const char* name;
  FaultKind kind;
  const char* meaning;
};
constexpr std::array<KindRow, 23> kKinds{{
    {"drop", FaultKind::Drop, "frames are lost"},
    {"duplicate", FaultKind::Duplicate, "twice in a row"},
    {"echo", FaultKind::Echo, "once more, time later"},
    {"delay", FaultKind::Delay, "time later, +- jitter"},
    {"overtaken", FaultKind::Overtaken, "time later, others do not wait"},
    {"swap", FaultKind::Swap, "behind the next one"},
    {"byte_by_byte", FaultKind::ByteByByte, "one byte a segment, or rate bytes a second"},
    {"merge", FaultKind::Merge, "with all that comes within time"},
    {"cut", FaultKind::Cut, "in two parts, time between them"},
    {"wrong_checksum", FaultKind::WrongChecksum, "with a wrong checksum"},
    {"wrong_checksum_then_good", FaultKind::WrongChecksumThenGood, "with a wrong checksum, then as it was"},
    {"garbage", FaultKind::Garbage, "behind text, or some bytes"},
    {"bad_length", FaultKind::BadLength, "text for LENGTH"},
    {"other_id", FaultKind::OtherId, "the id of no script"},
    {"cperr", FaultKind::Cperr, "CPERR text in place of it"},
    {"answer_first", FaultKind::AnswerFirst, "OK before the controller has the script"},
    {"answer_ahead", FaultKind::AnswerAhead, "OK for the next script, too"},
    {"reset", FaultKind::Reset, "RST in place of the frame"},
    {"close", FaultKind::Close, "FIN in place of the frame"},
    {"refuse", FaultKind::Refuse, "new connections are refused"},
    {"silence", FaultKind::Silence, "new connections lead nowhere"},
    {"close_at_once", FaultKind::CloseAtOnce, "new connections are closed"},
    {"never_read", FaultKind::NeverRead, "what is sent is left unread"},
}};

std::optional<FaultKind> kindNamed(std::string_view name) {
  const auto* const row =
      std::find_if(kKinds.begin(), kKinds.end(), [&](const KindRow& known) { return known.name == name; });
  return row == kKinds.end() ? std::nullopt : std::optional(row->kind);
}

/// A number from 0 on.
std::optional<double> numberIn(const std::string& text) {
  std::istringstream stream(text);
  stream.imbue(std::locale::classic());
  double number = 0;
  stream >> number;
  const bool whole = !stream.fail() && stream.peek() == std::istringstream::traits_type::eof();
  return whole && std::isfinite(number) && number >= 0 && number <= 1e9 ? std::optional(number)
                                                                        : std::nullopt;
}

using Complaint = std::optional<std::string>;

Complaint setNumber(Fault& fault, const std::string& name, const std::string& value) {
  const auto number = numberIn(value);
  if (!number) return fmt::format("{}={}: give a number from 0 to 1000000000", name, value);
  if (name == "first") {
    fault.first = static_cast<std::size_t>(*number);
  } else if (name == "count") {
    fault.count = static_cast<std::size_t>(*number);
  } else if (name == "rate") {
    fault.rate = *number;
  } else {
    (name == "time" ? fault.time : fault.jitter) = fromSeconds(std::min(*number, 1e6));
  }
  return std::nullopt;
}

Complaint setField(Fault& fault, const std::string& name, const std::string& value) {
  if (name == "text") {
    fault.text = value;
  } else if (name == "direction" && (value == "to_client" || value == "to_controller")) {
    fault.direction = value == "to_client" ? Direction::ToClient : Direction::ToController;
  } else if (name == "direction") {
    return fmt::format("direction={}: allowed are to_client and to_controller", value);
  } else if (name == "which") {
    const char* const names[] = {"any", "script", "tag", "node_state"};  // in the order of Which
    const auto* const found = std::find(std::begin(names), std::end(names), value);
    if (found == std::end(names)) {
      return fmt::format("which={}: allowed are any, script, tag, node_state", value);
    }
    fault.which = static_cast<Which>(found - std::begin(names));
  } else if (name == "first" || name == "count" || name == "rate" || name == "time" || name == "jitter") {
    return setNumber(fault, name, value);
  } else {
    return fmt::format("{}: allowed are direction, which, first, count, time, jitter, rate and text", name);
  }
  return std::nullopt;
}

}  // namespace

Result<FaultOrder, std::string> parseFaultLine(std::string_view line) {
  std::istringstream words{std::string(line)};
  std::string port;
  std::string kind_name;
  words >> port >> kind_name;
  FaultOrder order;
  if (port != "script" && port != "status") {
    return refuse(fmt::format("port \"{}\": allowed are script and status", port));
  }
  order.port = port == "script" ? FaultProxy::Port::Script : FaultProxy::Port::Status;
  const auto kind = kindNamed(kind_name);
  if (!kind) return refuse(fmt::format("unknown fault \"{}\"; \"faults\" lists them", kind_name));
  order.fault.kind = *kind;
  for (std::string word; words >> word;) {
    const std::size_t equals = std::min(word.find('='), word.size());
    const std::string value = equals < word.size() ? word.substr(equals + 1) : "";
    if (const Complaint complaint = setField(order.fault, word.substr(0, equals), value)) {
      return refuse(*complaint);
    }
  }
  return order;
}

std::string knownFaultKinds() {
  std::string text;
  for (const KindRow& row : kKinds) text += fmt::format("{:26}{}\n", row.name, row.meaning);
  return text;
}

}  // namespace cobot_command::testing
