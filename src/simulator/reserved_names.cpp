#include "reserved_names.h"

#include "script_port/controller_functions.h"
#include "script_port/robot_attributes.h"
#include "status_port/item_table.h"

#include "cobot_command/script/robot_functions.h"
#include "cobot_command/tm_script/parser.h"

namespace cobot_command::simulator {

namespace {

tm_script::FunctionTable allFunctions() {
  tm_script::FunctionTable functions;
  script::declareRobotFunctions(functions);
  defineControllerFunctions(functions, [] { return RobotState(); });
  return functions;
}

}  // namespace

std::optional<std::string> whatIsNamed(const std::string& name) {
  static const tm_script::FunctionTable functions = allFunctions();
  if (tm_script::isReservedWord(name)) return "a word of the language";
  if (functions.has(name)) return "a function";
  if (isObject(name)) return "an object with attributes, as in " + name + "[...]";
  if (isItem(name)) return "a predefined item";
  return std::nullopt;
}

}  // namespace cobot_command::simulator
