#include "script_port/script_environment.h"

#include <cmath>
#include <cstring>

#include <fmt/format.h>

#include "cobot_command/common/overloaded.h"
#include "cobot_command/script/robot_functions.h"

namespace cobot_command::simulator {

namespace {

using tm_script::Scalar;
using tm_script::Value;

/// Little endian, as the machine is; a text as it is.
std::string bytesOf(const Scalar& scalar) {
  return std::visit(Overloaded{[](const std::string& text) { return text; },
                               [](const auto& number) {
                                 std::string bytes(sizeof(number), '\0');
                                 std::memcpy(bytes.data(), &number, sizeof(number));
                                 return bytes;
                               }},
                    scalar);
}

/// Elements one behind the other.
std::string bytesOf(const Value& value) {
  if (const auto* scalar = std::get_if<Scalar>(&value)) return bytesOf(*scalar);
  std::string bytes;
  for (const Scalar& item : std::get<tm_script::Array>(value).items) bytes += bytesOf(item);
  return bytes;
}

template <class Map>
std::optional<std::string> unknownName(const Map& map, const std::string& name) {
  if (map.count(name) > 0) return std::nullopt;
  return fmt::format("the project has no {}", name);
}

}  // namespace

std::optional<std::string> ScriptEnvironment::objectionTo(
    const std::string& function, const std::vector<std::optional<Scalar>>& arguments) const {
  const auto* name =
      arguments.size() == 1 && arguments[0] ? std::get_if<std::string>(&*arguments[0]) : nullptr;
  if (name != nullptr && function == "ChangeBase") return unknownName(project_.bases, *name);
  if (name != nullptr && function == "ChangeTCP") return unknownName(project_.tools, *name);
  if (!velocity_licence_ && script::needsLicence(function)) return function + " requires a licence";
  return script::objectionTo(function, arguments);
}

std::optional<std::string> ScriptEnvironment::write(const tm_script::AttributeName& attribute,
                                                    std::optional<std::size_t> index, const Value& value) {
  if (attribute.object != "IO") {
    attributes_.write(attribute, index, value);
    return std::nullopt;
  }
  const auto* array = std::get_if<tm_script::Array>(&value);
  const std::size_t count = array == nullptr ? 1 : array->items.size();
  for (std::size_t i = 0; i < count; ++i) {
    const auto answer = array == nullptr ? writeOutput(attribute, index.value_or(0), std::get<Scalar>(value))
                                         : writeOutput(attribute, i, array->items[i]);
    const auto* failure = std::get_if<tm_script::CallFailure>(&answer);
    if (failure != nullptr) return failure->reason;
  }
  return std::nullopt;
}

tm_script::CallAnswer ScriptEnvironment::writeOutput(const tm_script::AttributeName& attribute,
                                                     std::size_t index, const Scalar& value) {
  if (const auto* volt = std::get_if<float>(&value)) {
    if (!(std::abs(*volt) <= script::kMostVolt)) {
      return tm_script::CallFailure{fmt::format("an analog output is -10 to 10 V, not {}", *volt)};
    }
    return commands_.perform(script::WriteAnalogOutput{*volt, attribute.name == "InstantAO"});
  }
  const auto level = std::get<std::uint8_t>(value);
  if (level > 1) return tm_script::CallFailure{fmt::format("an output is 0 or 1, not {}", level)};
  script::WriteOutput write;
  write.module = *script::ioModule(std::get<std::string>(attribute.keys.front()));
  write.index = static_cast<int>(index);
  write.on = level == 1;
  write.instant = attribute.name == "InstantDO";
  return commands_.perform(write);
}

tm_script::CallAnswer ScriptEnvironment::call(const std::string& function,
                                              const tm_script::Arguments& arguments) {
  if (function == "ListenSend") return listenSend(arguments);
  if (auto objection = objectionTo(function, script::knownArguments(arguments))) {
    return tm_script::CallFailure{std::move(*objection)};
  }
  return commands_.perform(script::commandOf(function, arguments));
}

tm_script::CallAnswer ScriptEnvironment::listenSend(const tm_script::Arguments& arguments) {
  constexpr std::int32_t kFirst = 90, kLast = 99, kSent = 0, kBadChannel = -2;
  const auto channel = std::get<std::int32_t>(std::get<Scalar>(arguments[0]));
  if (channel < kFirst || channel > kLast) return Value(Scalar(kBadChannel));
  clients_.broadcast(protocol::ListenData{channel, bytesOf(arguments[1])});
  return Value(Scalar(kSent));
}

}  // namespace cobot_command::simulator
