#include "cobot_command/simulator/control_line.h"

#include <algorithm>
#include <charconv>
#include <iterator>
#include <locale>
#include <optional>
#include <sstream>
#include <utility>

#include "settings_text.h"
#include <fmt/format.h>

#include "cobot_command/common/given.h"

namespace cobot_command::simulator {

namespace {

using Read = Result<OperatorAction, std::string>;

/// The words of a line behind the command.
class Words {
 public:
  explicit Words(const std::string& line) : stream_(line) { stream_.imbue(std::locale::classic()); }

  /// Empty at the end.
  std::string next() {
    std::string word;
    stream_ >> word;
    return word;
  }
  /// All that is left, without the blanks around it.
  std::string rest() {
    std::string text;
    std::getline(stream_ >> std::ws, text);
    text.erase(text.find_last_not_of(" \t\r") + 1);
    return text;
  }

 private:
  std::istringstream stream_;
};

/// 12, or 0x0C.
std::optional<int> toInt(std::string word) {
  int base = 10;
  if (word.size() > 2 && (word.compare(0, 2, "0x") == 0 || word.compare(0, 2, "0X") == 0)) {
    word.erase(0, 2);
    base = 16;
  }
  int value = 0;
  const auto* const end = word.data() + word.size();
  const auto parsed = std::from_chars(word.data(), end, value, base);
  if (word.empty() || parsed.ec != std::errc() || parsed.ptr != end) return std::nullopt;
  return value;
}

std::optional<double> toDouble(const std::string& word) {
  std::istringstream stream(word);
  stream.imbue(std::locale::classic());
  double value = 0;
  if (!(stream >> value) || stream.peek() != std::istringstream::traits_type::eof()) return std::nullopt;
  return value;
}

template <class Action>
Read plain(Words&) {
  return Action{};
}

/// An action with one flag, chosen by one of two words.
template <class Action>
Read eitherOr(Words& words, const char* yes, const char* no) {
  const std::string word = words.next();
  if (word == yes) return Action{true};
  if (word == no) return Action{false};
  return refuse(fmt::format("{}: give {} or {}", quoted(word), yes, no));
}

Read readSpeed(Words& words) {
  const std::string word = words.next();
  const auto percent = toInt(word);
  if (!percent) return refuse(fmt::format("{}: give the speed in %, 5 to 100", quoted(word)));
  return SetProjectSpeed{*percent};
}

Read readError(Words& words) {
  const std::string word = words.next();
  const auto code = toInt(word);
  if (!code) return refuse(fmt::format("{}: give a code such as 0x14058, and a text", quoted(word)));
  return RaiseError{*code, words.rest()};
}

Read readInput(Words& words) {
  const std::string name = words.next();
  const auto module = script::ioModule(name);
  if (!module) return refuse(fmt::format("{}: the modules are ControlBox and EndModule", quoted(name)));
  const auto index = toInt(words.next());
  const auto value = toInt(words.next());
  if (!index || !value || (*value != 0 && *value != 1)) {
    return refuse(std::string("give the number of the input, and 0 or 1"));
  }
  return SetInput{*module, *index, *value == 1};
}

/// SetTcp, SetBase.
template <class Action>
Read readFrame(Words& words) {
  const std::string text = words.rest();
  auto named = parseNamedList(text);
  Action action;
  if (!named || named->second.size() != action.value.size()) {
    return refuse(fmt::format("{}: give NAME=x,y,z,rx,ry,rz [mm, deg]", quoted(text)));
  }
  action.name = std::move(named->first);
  std::copy(named->second.begin(), named->second.end(), action.value.begin());
  return action;
}

Read readLoad(Words& words) {
  const std::string text = words.rest();
  auto named = parseNamedList(text);
  const std::size_t count = named ? named->second.size() : 0;
  if (count != 1 && count != 4 && count != 10) {
    return refuse(
        fmt::format("{}: give NAME=kg, or NAME=kg,ixx,iyy,izz [kg mm^2], or these and "
                    "x,y,z,rx,ry,rz [mm, deg] of the mass centre in the TCP",
                    quoted(text)));
  }
  const auto& numbers = named->second;
  SetLoad load{std::move(named->first), numbers[0], {}, {}};
  if (count > 1) std::copy_n(numbers.begin() + 1, 3, load.moment.emplace().begin());
  if (count > 4) std::copy_n(numbers.begin() + 4, 6, load.mass_center.emplace().begin());
  return load;
}

bool isDelay(const std::string& fault) {
  return fault.compare(0, 6, "delay_") == 0;
}

Result<SetFault, std::string> faultIn(Words& words) {
  SetFault order;
  order.name = words.next();
  const std::string count = words.next();
  if (count == "off") {
    order.active = false;
    return order;
  }
  if (count.empty()) return order;
  const auto number = toInt(count);
  if (!number) {
    return refuse(fmt::format("{}: give a count, or 0 for no limit; or off", quoted(count)));
  }
  order.count = *number;
  const std::string value = words.rest();
  if (!isDelay(order.name)) {
    order.text = value;
    return order;
  }
  const auto seconds = toDouble(value);
  if (!seconds) return refuse(fmt::format("{}: give the delay in seconds", quoted(value)));
  order.seconds = *seconds;
  return order;
}

Read readFault(Words& words) {
  auto order = faultIn(words);
  if (!order) return refuse(std::move(order.error()));
  return *order;
}

struct Command {
  const char* name;
  const char* arguments;
  const char* meaning;
  Read (*read)(Words&);
};

constexpr Command kCommands[] = {
    {"run", "", "run the project", plain<RunProject>},
    {"stop", "", "stop the project", plain<StopProject>},
    {"pause", "", "pause the project", plain<PauseProject>},
    {"resume", "", "resume the project", plain<ResumeProject>},
    {"leave", "", "make the flow leave the Listen node", plain<LeaveListenNode>},
    {"enter", "", "make the flow enter the Listen node again", plain<EnterListenNode>},
    {"estop", "press|release", "press or release the emergency stop",
     [](Words& words) { return eitherOr<SetEmergencyStop>(words, "press", "release"); }},
    {"safeguard", "open|close", "open or close the safeguard",
     [](Words& words) { return eitherOr<SetSafeguard>(words, "open", "close"); }},
    {"manual", "", "switch to manual mode",
     [](Words&) -> Read { return SetOperatingMode{OperatingMode::Manual}; }},
    {"auto", "", "switch to automatic mode",
     [](Words&) -> Read { return SetOperatingMode{OperatingMode::Automatic}; }},
    {"speed", "PERCENT", "set the project speed, 5 to 100 in steps of 5", readSpeed},
    {"error", "CODE [TEXT]", "raise a robot error", readError},
    {"clear", "", "clear the robot error", plain<ClearError>},
    {"input", "MODULE N 0|1", "set an input of ControlBox or EndModule", readInput},
    {"set_tcp", "NAME=x,y,z,rx,ry,rz", "change a TCP of the project, as the pendant does", readFrame<SetTcp>},
    {"set_base", "NAME=x,y,z,rx,ry,rz", "change a base of the project", readFrame<SetBase>},
    {"set_load", "NAME=kg[,ixx,iyy,izz[,x,y,z,rx,ry,rz]]", "change the payload of a TCP", readLoad},
    {"drop_connections", "", "disconnect all clients", plain<DropConnections>},
    {"fault", "NAME [COUNT [VALUE]]", "turn a fault on: until it is turned off, or COUNT times", readFault},
    {"fault", "NAME off", "turn this fault off", readFault},
    {"no_faults", "", "turn all faults off", plain<ClearFaults>},
};

std::string faultList() {
  std::string list;
  for (const KnownFault& fault : knownFaults()) {
    const std::string value = fault.needs.empty() ? std::string() : " VALUE: " + fault.needs + ".";
    list += fmt::format("{}{:<22} {}.{}", list.empty() ? "" : "\n", fault.name, fault.meaning, value);
  }
  return list;
}

Read read(const std::string& name, Words& words) {
  const auto* const command = std::find_if(std::begin(kCommands), std::end(kCommands),
                                           [&](const Command& known) { return name == known.name; });
  if (command == std::end(kCommands)) {
    return refuse(fmt::format("unknown command {}: help lists them", quoted(name)));
  }
  Read action = command->read(words);
  if (!action) return action;
  const std::string left = words.rest();
  if (!left.empty()) {
    return refuse(fmt::format("{} does not accept {}: help lists the arguments", name, quoted(left)));
  }
  return action;
}

}  // namespace

Result<SetFault, std::string> parseFault(const std::string& text) {
  Words words(text);
  auto order = faultIn(words);
  const std::string left = words.rest();
  if (order && !left.empty()) return refuse(fmt::format("{} is an unexpected argument", quoted(left)));
  return order;
}

std::string controlHelp() {
  std::string help;
  const auto add = [&](const char* name, const char* arguments, const char* meaning) {
    help += fmt::format("{:<32} {}\n", fmt::format("{} {}", name, arguments), meaning);
  };
  for (const Command& command : kCommands) add(command.name, command.arguments, command.meaning);
  add("faults", "", "list the faults");
  help += fmt::format("{:<32} {}", "help", "list the commands");
  return help;
}

OperatorReply control(SimulatedController& controller, std::string_view line, Instant now) {
  Words words{std::string(line)};
  const std::string name = words.next();
  if (name.empty()) return {};
  if (name == "help") return {true, controlHelp()};
  if (name == "faults") return {true, faultList()};
  Read action = read(name, words);
  if (!action) return {false, std::move(action.error())};
  return controller.operate(*action, now);
}

}  // namespace cobot_command::simulator
