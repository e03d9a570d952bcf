#include "cobot_command/rapid/checks/signal_file.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <tuple>

#include "check_kinds.h"
#include "reporting.h"
#include <fmt/format.h>

#include "cobot_command/common/utf8.h"
#include "cobot_command/files/yaml_map.h"
#include "cobot_command/rapid/source/dialect.h"
#include "cobot_command/rapid/types/predefined.h"

namespace cobot_command::rapid {

namespace {

using files::YamlFault;
using files::YamlMap;

constexpr const char* kWhat = "a signal";
constexpr int kMostBits = 16;
constexpr double kMostVolts = 10;
const files::YamlNames kTypes{{"di", 0}, {"do", 1}, {"gi", 2}, {"go", 3}, {"ai", 4}, {"ao", 5}};
const files::YamlNames kModules{{"ControlBox", 0}, {"EndModule", 1}};

bool isGroup(SignalType type) {
  return type == SignalType::Gi || type == SignalType::Go;
}
bool isAnalog(SignalType type) {
  return type == SignalType::Ai || type == SignalType::Ao;
}

/// Inputs or outputs of a kind that a module has.
int count(SignalType type, IoModule module) {
  const bool is_end = module == IoModule::EndModule;
  switch (type) {
    case SignalType::Ai:
      return is_end ? 1 : 2;
    case SignalType::Ao:
      return is_end ? 0 : 1;
    default:
      return is_end ? 4 : 16;
  }
}

/// The bits of a group are those of di or do.
SignalType wireOf(SignalType type) {
  return type == SignalType::Gi ? SignalType::Di : type == SignalType::Go ? SignalType::Do : type;
}

[[noreturn]] void refuseNode(const YAML::Node& node, const std::string& why) {
  throw YamlFault(node.Mark(), why);
}

class SignalReader {
 public:
  std::vector<Signal> read(const YAML::Node& root) {
    if (root.IsNull()) return {};
    if (!root.IsMap()) refuseNode(root, "it must be a map from names to signals");
    files::requireOwnKeys(root, "the signal file");
    for (const auto& entry : root) signals_.push_back(signal(entry.first, entry.second));
    return std::move(signals_);
  }

 private:
  Signal signal(const YAML::Node& key, const YAML::Node& value) {
    const YamlMap map(value, kWhat, {"type", "module", "index", "bits", "inverted", "initial", "virtual"});
    Signal signal;
    signal.name = nameOf(key);
    signal.folded = folded(signal.name);
    signal.type = static_cast<SignalType>(map.named("type", kTypes));
    signal.is_virtual = map.has("virtual") && map.truth("virtual");
    signal.is_virtual ? readVirtual(map, signal) : readWires(map, signal);
    if (map.has("inverted")) signal.is_inverted = inverted(map, signal.type);
    if (map.has("initial")) signal.initial = initial(map, signal);
    return signal;
  }

  std::string nameOf(const YAML::Node& key) {
    std::string name = key.IsScalar() ? key.Scalar() : "";
    const Source source = readSource(name);
    const bool is_name = source.findings().size() == 1 && source.tokens().size() == 2 &&
                         source.tokens().front().kind == TokenKind::Name;
    const std::string shown = quoted(name);
    if (!is_name) refuseNode(key, fmt::format("'{}' is no name of RAPID", shown));
    if (countCharacters(name) > lettersAllowedBy(Dialect::Irc5)) {
      refuseNode(key, fmt::format("'{}' has more than {} letters", shown, lettersAllowedBy(Dialect::Irc5)));
    }
    const std::string small = folded(name);
    if (!names_.insert(small).second) {
      refuseNode(key, fmt::format("'{}' is there twice; case does not count", shown));
    }
    if (!predefinedNames().find(small).written.empty()) {
      refuseNode(key, fmt::format("'{}' is a predefined name of RAPID", shown));
    }
    return name;
  }

  static void readVirtual(const YamlMap& map, Signal& signal) {
    for (const char* const wire : {"module", "index"}) {
      if (map.has(wire)) refuseNode(map.required(wire), fmt::format("a virtual signal has no {}", wire));
    }
    std::size_t bits = 1;
    if (isGroup(signal.type)) {
      const YAML::Node given = map.required("bits");
      bits = given.IsSequence() ? given.size() : static_cast<std::size_t>(std::max(map.whole("bits"), 0));
      if (bits < 1 || bits > kMostBits) refuseNode(given, fmt::format("a group has 1 to {} bits", kMostBits));
    } else if (map.has("bits")) {
      refuseNode(map.required("bits"), "bits are for gi and go");
    }
    signal.indices.assign(bits, 0);
  }

  void readWires(const YamlMap& map, Signal& signal) {
    signal.module = static_cast<IoModule>(map.named("module", kModules));
    const bool is_group = isGroup(signal.type);
    const char* const wrong = is_group ? "index" : "bits";
    if (map.has(wrong)) {
      refuseNode(map.required(wrong), is_group ? "a group has bits, no index" : "bits are for gi and go");
    }
    if (!is_group) return wire(map.required("index"), signal);
    const YAML::Node bits = map.listOf("bits", kMostBits, "bits");
    if (bits.size() == 0) refuseNode(bits, fmt::format("a group has 1 to {} bits", kMostBits));
    for (const YAML::Node& bit : bits) wire(bit, signal);
  }

  void wire(const YAML::Node& node, Signal& signal) {
    const SignalType type = wireOf(signal.type);
    const int most = count(type, signal.module);
    const char* const module = kModules[static_cast<std::size_t>(signal.module)].first;
    const std::string kind = std::string(toString(type)) + " at " + module;
    const double given = files::toNumber(node, "index", "a whole number");
    const bool is_there = given >= 0 && given < most && given == std::floor(given);
    if (!is_there) {
      refuseNode(node, most == 0 ? fmt::format("there is no {}", kind)
                                 : fmt::format("index of {} is from 0 to {}", kind, most - 1));
    }
    const auto index = static_cast<std::uint32_t>(given);
    if (!wires_.emplace(type, signal.module, index).second) {
      refuseNode(node, fmt::format("{} {} is used twice", kind, index));
    }
    signal.indices.push_back(index);
  }

  static bool inverted(const YamlMap& map, SignalType type) {
    if (isAnalog(type)) refuseNode(map.required("inverted"), "an analog signal is not inverted");
    return map.truth("inverted");
  }

  static double initial(const YamlMap& map, const Signal& signal) {
    const double value = map.number("initial");
    const double most = isAnalog(signal.type) ? kMostVolts : std::exp2(signal.indices.size()) - 1;
    const double least = isAnalog(signal.type) ? -kMostVolts : 0;
    const bool is_allowed =
        value >= least && value <= most && (isAnalog(signal.type) || value == std::floor(value));
    if (!is_allowed) {
      refuseNode(map.required("initial"), fmt::format("initial is from {} to {}{}", least, most,
                                                      isAnalog(signal.type) ? "" : ", a whole number"));
    }
    return value;
  }

  std::vector<Signal> signals_;
  std::set<std::string> names_;
  std::set<std::tuple<SignalType, IoModule, std::uint32_t>> wires_;
};

}  // namespace

Result<std::vector<Signal>, SignalFileFault> readSignalFile(const std::string& text) {
  auto signals = files::tryYaml<std::vector<Signal>>(
      text, "signals", [](const YAML::Node& root) { return SignalReader().read(root); });
  if (signals) return *std::move(signals);
  const files::FileFault& fault = signals.error();
  return refuse(SignalFileFault{std::max(fault.line, 1), std::max(fault.column, 1),
                                fmt::format(fmt::runtime(kinds::kSignalFile.text), foreignText(fault.what))});
}

}  // namespace cobot_command::rapid
