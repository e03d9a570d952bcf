#include "node_names.h"

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <string_view>
#include <system_error>

#include <fmt/format.h>

#include "cobot_command/common/foreign_text.h"

namespace cobot_command::nodes {
namespace {

using Fault = std::optional<std::string>;

constexpr std::string_view kBetween = ":=";
constexpr std::string_view kProtocol = "http://";

/// Whatever the locale is.
constexpr bool isLetter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}
constexpr bool isOfWord(char c) {
  return isLetter(c) || (c >= '0' && c <= '9') || c == '_';
}

/// One piece of a name, between slashes; roscpp asks for a letter at the beginning of the whole alone.
bool isNodeName(std::string_view name) {
  return !name.empty() && isLetter(name.front()) && std::all_of(name.begin(), name.end(), isOfWord);
}

/// What may stand behind the first character of a name of ROS.
bool isRest(std::string_view rest) {
  return std::all_of(rest.begin(), rest.end(), [](char c) { return isOfWord(c) || c == '/'; });
}

bool isName(std::string_view name) {
  const bool begins = !name.empty() && (isLetter(name.front()) || name.front() == '/' || name.front() == '~');
  // More than the root: a topic or service of no name is nobody's.
  return begins && isRest(name.substr(1)) && std::any_of(name.begin(), name.end(), isOfWord);
}

std::optional<std::uint16_t> portIn(std::string_view text) {
  std::uint16_t port = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), port);
  if (text.empty() || error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return port;
}

/// As roscpp takes it apart: the last colon is that of the port.
bool isMaster(std::string_view uri) {
  if (uri.substr(0, kProtocol.size()) != kProtocol) return false;
  uri.remove_prefix(kProtocol.size());
  const std::size_t colon = uri.rfind(':');
  if (colon == std::string_view::npos || colon == 0) return false;
  const auto port = portIn(uri.substr(colon + 1, uri.find('/', colon) - colon - 1));
  return port && *port != 0;
}

std::string inQuotes(std::string_view text) {
  return fmt::format("'{}'", foreignText(text, kQuoteLimit));
}

Fault faultInNamespace(const char* setting, std::string_view space) {
  if (isRest(space)) return std::nullopt;
  return fmt::format("{} is {}; allowed: letters, digits, _ and /, as in /cell/robot_1", setting,
                     inQuotes(space));
}

Fault faultInMaster(const char* setting, const std::string& uri) {
  if (isMaster(uri)) return std::nullopt;
  return fmt::format("{} is {}; allowed: http://host:port, as in http://localhost:11311", setting,
                     inQuotes(uri));
}

Fault faultInWord(std::string_view left, std::string_view right) {
  if (left == "__name" && !isNodeName(right)) {
    return fmt::format(
        "__name is {}; allowed: letters, digits and _, starting with a letter, as in __name:=robot_1; its "
        "namespace is set by __ns",
        inQuotes(right));
  }
  if (left == "__ns") return faultInNamespace("__ns", right);
  // An empty one is as if it were not there.
  if (left == "__master" && !right.empty()) return faultInMaster("__master", std::string(right));
  if (left == "__tcpros_server_port" && !portIn(right)) {
    return fmt::format("__tcpros_server_port is {}; allowed: a port from 0 to {}", inQuotes(right),
                       std::numeric_limits<std::uint16_t>::max());
  }
  if (left.substr(0, 2) == "__") return std::nullopt;  // no name of something
  if (left.substr(0, 1) == "_") {
    if (left.size() > 1 && isRest(left.substr(1))) return std::nullopt;
    return fmt::format(
        "{} is not a valid name of a parameter; allowed: letters, digits, _ and /, as in _robot_ip:=10.0.0.1",
        inQuotes(left));
  }
  for (const std::string_view name : {left, right}) {
    if (isName(name)) continue;
    return fmt::format(
        "{} in {} is not a valid name of a topic, service or action; allowed: letters, digits, _ and /, "
        "starting with a letter, / or ~",
        inQuotes(name), inQuotes(fmt::format("{}{}{}", left, kBetween, right)));
  }
  return std::nullopt;
}

}  // namespace

std::optional<std::string> faultInNames(int argc, const char* const* argv, const Environment& environment) {
  bool has_master = false;
  bool has_namespace = false;
  for (int i = 1; i < argc; ++i) {
    const std::string_view word = argv[i];
    const std::size_t between = word.find(kBetween);
    if (between == std::string_view::npos) continue;
    const std::string_view left = word.substr(0, between);
    const std::string_view right = word.substr(between + kBetween.size());
    if (auto fault = faultInWord(left, right)) return fault;
    has_master = has_master || (left == "__master" && !right.empty());
    has_namespace = has_namespace || left == "__ns";
  }
  if (const auto space = environment("ROS_NAMESPACE"); space && !has_namespace) {
    if (auto fault = faultInNamespace("ROS_NAMESPACE", *space)) return fault;
  }
  if (has_master) return std::nullopt;
  const auto master = environment("ROS_MASTER_URI");
  if (master) return faultInMaster("ROS_MASTER_URI", *master);
  return "ROS_MASTER_URI is not set; allowed: http://host:port: source devel/setup.bash, or export "
         "ROS_MASTER_URI=http://localhost:11311";
}

std::optional<std::string> ofProcess(const char* name) {
  const char* value = std::getenv(name);
  return value ? std::optional<std::string>(value) : std::nullopt;
}

}  // namespace cobot_command::nodes
