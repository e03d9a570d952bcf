#include "cobot_command/ros/shared/given_parameters.h"

#include <algorithm>

#include <fmt/format.h>
#include <ros/param.h>

#include "cobot_command/common/foreign_text.h"

namespace cobot_command::ros_adapter {

namespace {

Given listIn(XmlRpc::XmlRpcValue& value) {
  GivenList list;
  for (int i = 0; i < value.size(); ++i) list.push_back(toGiven(value[i]));
  return {list};
}

void add(GivenValues& values, const std::string& name, XmlRpc::XmlRpcValue& value) {
  values.emplace(name, toGiven(value));
  if (value.getType() != XmlRpc::XmlRpcValue::TypeStruct) return;
  for (auto& entry : value) add(values, name + '/' + entry.first, entry.second);
}

/// The table has rows in it, so that it is no parameter itself.
bool isSpaceOf(const SettingTable& table, const std::string& name) {
  return std::any_of(table.begin(), table.end(),
                     [&](const Setting& row) { return row.name.find(name + '/') == 0; });
}

/// What is below a name that is told of itself, or that others have.
bool isBelowAnother(const SettingTable& table, const std::string& name) {
  const std::size_t end = name.find('/');
  return end != std::string::npos && !isSpaceOf(table, name.substr(0, end));
}

}  // namespace

Given toGiven(const XmlRpc::XmlRpcValue& value) {
  using XmlRpc::XmlRpcValue;
  XmlRpcValue copy = value;  // its conversions are not const
  switch (copy.getType()) {
    case XmlRpcValue::TypeBoolean:
      return {static_cast<bool>(copy)};
    case XmlRpcValue::TypeInt:
      return {static_cast<int>(copy)};
    case XmlRpcValue::TypeDouble:
      return {static_cast<double>(copy)};
    case XmlRpcValue::TypeString:
      return {static_cast<std::string>(copy)};
    case XmlRpcValue::TypeArray:
      return listIn(copy);
    case XmlRpcValue::TypeStruct:
      return {OtherKind{"a namespace with parameters"}};
    case XmlRpcValue::TypeDateTime:
      return {OtherKind{"a date"}};
    case XmlRpcValue::TypeBase64:
      return {OtherKind{"binary data"}};
    default:
      return {OtherKind{"nothing"}};
  }
}

GivenParameters givenParameters(const ros::NodeHandle& node, const ros::NodeHandle& self) {
  GivenParameters given;
  given.space = self.getNamespace();
  XmlRpc::XmlRpcValue value;
  // All at once: what is not asked for by name must be seen as well.
  if (ros::param::get(given.space, value) && value.getType() == XmlRpc::XmlRpcValue::TypeStruct) {
    for (auto& entry : value) add(given.own, entry.first, entry.second);
  }
  if (node.getParam("robot_description", value)) given.robot_description = toGiven(value);
  return given;
}

ParameterError parameterError(const GivenParameters& given, const SettingFault& fault) {
  return {forPeople(fmt::format("parameter {}/{} {}", given.space, fault.setting, describe(fault)))};
}

std::vector<std::string> warningsOfUnknown(const GivenParameters& given, const SettingTable& table,
                                           const std::vector<std::string>& others) {
  std::vector<std::string> warnings;
  for (const UnknownSetting& unknown : unknownSettings(table, given.own)) {
    const bool is_namespace = std::holds_alternative<OtherKind>(given.own.at(unknown.name).value);
    if (is_namespace && isSpaceOf(table, unknown.name)) continue;
    if (isBelowAnother(table, unknown.name)) continue;
    if (std::find(others.begin(), others.end(), unknown.name) != others.end()) continue;
    const std::string hint = unknown.meant.empty() ? "doc/parameters.md lists its parameters"
                                                   : "did you mean " + unknown.meant + "?";
    warnings.push_back(fmt::format("parameter {}/{} is not a parameter of this node and is ignored: {}",
                                   given.space, foreignText(unknown.name), hint));
  }
  return warnings;
}

}  // namespace cobot_command::ros_adapter
