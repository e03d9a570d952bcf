#include "cobot_command/simulator/settings.h"

#include <algorithm>
#include <array>
#include <utility>

#include "item_table.h"
#include "project_data.h"
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace cobot_command::simulator {

namespace {

using protocol::ItemFormat;

constexpr std::array<std::pair<std::string_view, ItemFormat>, 3> kFormats{
    {{"binary", ItemFormat::Binary}, {"string", ItemFormat::String}, {"json", ItemFormat::Json}}};

}  // namespace

std::vector<std::string> defaultStreamItems() {
  std::vector<std::string> names = parseNames(
      "Robot_Link,Robot_Error,Project_Run,Project_Pause,Safeguard_A,ESTOP,Camera_Light,Error_Code,"
      "Joint_Angle,Coord_Robot_Flange,Coord_Robot_Tool,TCP_Force,TCP_Force3D,TCP_Speed,TCP_Speed3D,"
      "Joint_Speed,Joint_Torque,Project_Speed,MA_Mode,Robot_Light");
  const auto add = [&](std::string_view more) {
    const auto list = parseNames(more);
    names.insert(names.end(), list.begin(), list.end());
  };
  for (int i = 0; i < 8; ++i) names.push_back(fmt::format("Ctrl_DO{}", i));
  for (int i = 0; i < 8; ++i) names.push_back(fmt::format("Ctrl_DI{}", i));
  add("Ctrl_AO0,Ctrl_AI0,Ctrl_AI1,End_DO0,End_DO1,End_DO2,End_DO3,End_DI0,End_DI1,End_DI2,End_AI0");
  add("TCP_Name,TCP_Value,TCP_Mass,Base_Name,Base_Value,Coord_Base_Flange,Coord_Base_Tool,Error_Content");
  return names;
}

std::optional<std::string> faultIn(const Settings& settings) {
  const auto& versions = knownTmflowVersions();
  if (std::find(versions.begin(), versions.end(), settings.tmflow_version) == versions.end()) {
    return fmt::format("\"{}\" is no version of TMflow that is simulated: allowed are {}",
                       settings.tmflow_version, fmt::join(versions, ", "));
  }
  language::Variables variables;
  for (const std::string& declaration : settings.variables) {
    const auto name = declare(variables, declaration);
    if (!name) return name.error();
    if (isItem(*name)) return fmt::format("{} is a predefined item: give the variable another name", *name);
  }
  for (const std::string& name : settings.stream_items) {
    if (isItem(name) || variables.find(name) != nullptr) continue;
    return fmt::format("there is neither an item nor a variable \"{}\" to stream", name);
  }
  return std::nullopt;
}

Result<ItemFormat, std::string> parseStreamFormat(std::string_view text) {
  for (const auto& [name, format] : kFormats) {
    if (name == text) return format;
  }
  return refuse(fmt::format("\"{}\" is no format: allowed are binary, string and json", text));
}

std::vector<std::string> parseNames(std::string_view text) {
  std::vector<std::string> names;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(','), text.size());
    std::string_view name = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    while (!name.empty() && name.front() == ' ') name.remove_prefix(1);
    while (!name.empty() && name.back() == ' ') name.remove_suffix(1);
    if (!name.empty()) names.emplace_back(name);
  }
  return names;
}

Result<std::pair<std::string, std::array<double, 6>>, std::string> parseNamedNumbers(std::string_view text) {
  const std::size_t sign = std::min(text.find('='), text.size());
  const std::string list = fmt::format("{{{}}}", text.substr(std::min(sign + 1, text.size())));
  const auto value = protocol::parseValue(ItemFormat::String, list, std::vector<double>());
  std::array<double, 6> numbers{};
  if (sign == 0 || !value || protocol::elementCount(*value) != numbers.size())
    return refuse(fmt::format("\"{}\" is not usable: allowed is NAME=1,2,3,4,5,6", text));
  const auto& found = std::get<std::vector<double>>(*value);
  std::copy(found.begin(), found.end(), numbers.begin());
  return std::pair(std::string(text.substr(0, sign)), numbers);
}

Result<std::optional<std::set<std::string, std::less<>>>, std::string> parseWriteClients(
    std::string_view text) {
  using Clients = std::set<std::string, std::less<>>;
  if (text == "all") return std::optional<Clients>();
  const std::vector<std::string> names = parseNames(text == "none" ? std::string_view() : text);
  const auto strange = std::find_if(names.begin(), names.end(), [](const std::string& name) {
    return name.find_first_not_of("0123456789abcdefABCDEF.:") != std::string::npos;
  });
  if (strange != names.end() || (names.empty() && text != "none")) {
    return refuse(
        fmt::format("\"{}\" is no list of addresses: allowed are all, none, and addresses like "
                    "192.168.1.7, separated by commas",
                    text));
  }
  return std::optional<Clients>(Clients(names.begin(), names.end()));
}

}  // namespace cobot_command::simulator
