#include "cobot_command/simulator/fault_switches.h"

#include <algorithm>
#include <optional>
#include <sstream>
#include <string_view>
#include <utility>

#include "status_port/item_table.h"
#include <fmt/format.h>

#include "cobot_command/common/given.h"

namespace cobot_command::simulator {

namespace {

using Complaint = std::optional<std::string>;
/// Looks at the order, and may fill in what it leaves open.
using Check = Complaint (*)(SetFault& order);

constexpr double kShortestDelay = 0.001;
constexpr double kLongestDelay = 60.0;

Complaint nothing(SetFault&) {
  return std::nullopt;
}

Complaint checkDelay(SetFault& order) {
  if (order.seconds >= kShortestDelay && order.seconds <= kLongestDelay) return std::nullopt;
  return fmt::format("a delay of {} s: allowed are {} to {}", order.seconds, kShortestDelay, kLongestDelay);
}

Complaint checkLines(SetFault& order) {
  if (order.text.empty()) order.text = "1";
  std::istringstream numbers(order.text);
  for (std::string number; std::getline(numbers, number, ';');) {
    const bool digits =
        !number.empty() && number.size() <= 6 && number.find_first_not_of("0123456789") == std::string::npos;
    if (!digits) return fmt::format("lines {}: give line numbers such as 1;3", quoted(order.text));
  }
  return std::nullopt;
}

Complaint checkCode(SetFault& order) {
  if (order.text.empty()) order.text = "04";
  for (const char* code : {"00", "01", "02", "03", "04", "F1"}) {
    if (order.text == code) return std::nullopt;
  }
  return fmt::format("code {}: allowed are 00, 01, 02, 03, 04, F1", quoted(order.text));
}

Complaint checkUncounted(SetFault& order) {
  if (order.count == 0) return std::nullopt;
  return fmt::format("{} cannot be counted: give count 0, and turn it off", order.name);
}

Complaint checkItems(SetFault& order) {
  std::istringstream names(order.text);
  bool any = false;
  for (std::string name; names >> name; any = true) {
    if (!isItem(name)) {
      return fmt::format("there is no item {}; separate the names with blanks", quoted(name));
    }
  }
  if (!any) return std::string("give the names of the items, separated by blanks");
  return checkUncounted(order);
}

Complaint checkGreeting(SetFault& order) {
  if (order.text.empty()) order.text = "SSH-2.0-OpenSSH_8.9";
  return std::nullopt;
}

struct Row {
  const char* name;
  FaultSwitch FaultSwitches::*fault;
  Check check;
  const char* needs;
  const char* meaning;
};

constexpr Row kRows[] = {
    {"refuse_script", &FaultSwitches::refuse_script, checkLines, "line numbers, such as 1;3 (1)",
     "a script gets ERROR with these lines and is not executed"},
    {"ignore_script", &FaultSwitches::ignore_script, nothing, "",
     "a script is neither executed nor answered"},
    {"cperr_script", &FaultSwitches::cperr_script, checkCode, "code 00, 01, 02, 03, 04 or F1 (04)",
     "a script gets this CPERR and is not executed"},
    {"wrong_id", &FaultSwitches::wrong_id, nothing, "", "the reply to a script has an id that no script has"},
    {"refuse_stop", &FaultSwitches::refuse_stop, nothing, "",
     "a script with StopAndClearBuffer gets ERROR with that line and is not executed"},
    {"ignore_stop", &FaultSwitches::ignore_stop, nothing, "", "StopAndClearBuffer gets OK and stops nothing"},
    {"refuse_listen_send", &FaultSwitches::refuse_listen_send, nothing, "",
     "a script with ListenSend gets ERROR with those lines and is not executed"},
    {"false_tag", &FaultSwitches::false_tag, nothing, "",
     "a tag is reported, and answered, as false although its motions were executed"},
    {"early_tag", &FaultSwitches::early_tag, nothing, "",
     "a tag is reported as true when it is queued, before the OK of its script, and not when it is reached"},
    {"stale_tag", &FaultSwitches::stale_tag, nothing, "",
     "tags that StopAndClearBuffer drops are reported as true with the next motion (tmr_ros2 #15)"},
    {"query_none", &FaultSwitches::query_none, nothing, "", "a query of a tag is answered none"},
    {"query_false", &FaultSwitches::query_false, nothing, "", "a query of a tag is answered false"},
    {"silence", &FaultSwitches::silence, checkUncounted, "",
     "the script port receives nothing and sends nothing; its connections stay open, the arm continues"},
    {"close_on_connect", &FaultSwitches::close_on_connect, nothing, "",
     "a new connection to the script port is closed at once"},
    {"refuse_connections", &FaultSwitches::refuse_connections, checkUncounted, "",
     "the script port is closed although the project runs"},
    {"impostor", &FaultSwitches::impostor, checkGreeting, "the greeting (SSH-2.0-OpenSSH_8.9)",
     "a new connection to the script port gets this line and nothing else"},
    {"hide_items", &FaultSwitches::hide_items, checkItems, "names of items, separated by blanks",
     "the status port does not have these items"},
    {"pvt_linear", &FaultSwitches::pvt_linear, checkUncounted, "",
     "between the points of a PVT that starts while this is on, the arm moves on straight lines at constant "
     "speed, not on cubics"},
};

struct MessageRow {
  const char* name;
  FaultSwitch MessageFaults::*fault;
  Check check;
  const char* needs;
  const char* meaning;
};
constexpr MessageRow kMessageRows[] = {
    {"drop", &MessageFaults::drop, nothing, "", "{} is not sent"},
    {"delay", &MessageFaults::delay, checkDelay, "seconds",
     "{} is sent later by this time; later messages overtake it"},
    {"duplicate", &MessageFaults::duplicate, nothing, "", "{} is sent twice"},
    {"corrupt", &MessageFaults::corrupt, nothing, "", "{} is sent with a wrong checksum"},
};

struct Kind {
  const char* name;
  const char* meaning;
};
/// In the order of MessageKind.
constexpr std::array<Kind, kMessageKinds> kKinds{
    {{"entry", "the message of the Listen node when it is entered"},
     {"reply", "the OK or ERROR of a script"},
     {"tag", "the report of a tag"},
     {"state", "the answer to TMSTA 00"},
     {"tag_answer", "the answer to TMSTA 01"},
     {"cperr", "a CPERR"},
     {"stream", "a frame of the status stream"},
     {"item_answer", "the answer to a request on the status port"}}};

std::string messageFaultName(const MessageRow& row, const Kind& kind) {
  return fmt::format("{}_{}", row.name, kind.name);
}

struct Found {
  FaultSwitch& fault;
  Check check;
};

std::optional<Found> find(FaultSwitches& faults, std::string_view name) {
  for (const Row& row : kRows) {
    if (name == row.name) return Found{faults.*row.fault, row.check};
  }
  for (std::size_t kind = 0; kind < kMessageKinds; ++kind) {
    for (const MessageRow& row : kMessageRows) {
      if (name == messageFaultName(row, kKinds[kind])) {
        return Found{faults.messages[kind].*row.fault, row.check};
      }
    }
  }
  return std::nullopt;
}

std::string unknown(const std::string& name) {
  std::string message = fmt::format("unknown fault {}; known are", quoted(name));
  for (const KnownFault& fault : knownFaults()) message.append(" ").append(fault.name);
  return message;
}

}  // namespace

bool FaultSwitch::take() {
  if (!on) return false;
  if (left > 0 && --left == 0) on = false;
  return true;
}

OperatorReply set(FaultSwitches& faults, const SetFault& order) {
  const auto found = find(faults, order.name);
  if (!found) return {false, unknown(order.name)};
  if (!order.active) {
    found->fault = FaultSwitch{};
    return {true, order.name + " is off"};
  }
  if (order.count < 0) {
    return {false, fmt::format("{} {} times: give 0 for no limit, or a number", order.name, order.count)};
  }
  SetFault filled = order;
  if (const Complaint complaint = found->check(filled)) return {false, *complaint};
  found->fault = {true, filled.count, filled.seconds, std::move(filled.text)};
  if (order.count == 0) return {true, order.name + " is on until it is turned off"};
  return {true, fmt::format("{} is on for the next {}", order.name, order.count)};
}

const std::vector<KnownFault>& knownFaults() {
  static const std::vector<KnownFault> known = [] {
    std::vector<KnownFault> faults;
    for (const Row& row : kRows) faults.push_back({row.name, row.needs, row.meaning});
    for (const Kind& kind : kKinds) {
      for (const MessageRow& row : kMessageRows) {
        faults.push_back({messageFaultName(row, kind), row.needs, fmt::format(row.meaning, kind.meaning)});
      }
    }
    return faults;
  }();
  return known;
}

}  // namespace cobot_command::simulator
