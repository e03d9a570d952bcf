#include "reserved_names.h"

#include "controller_functions.h"
#include "item_table.h"
#include "robot_functions.h"
#include "robot_items.h"

#include "cobot_command/language/parser.h"

namespace cobot_command::simulator {

namespace {

language::FunctionTable allFunctions() {
  language::FunctionTable functions;
  declareRobotFunctions(functions);
  defineControllerFunctions(functions, [] { return RobotState(); });
  return functions;
}

}  // namespace

std::optional<std::string> whatIsNamed(const std::string& name) {
  static const language::FunctionTable functions = allFunctions();
  if (language::isReservedWord(name)) return "a word of the language";
  if (functions.has(name)) return "a function";
  if (isItemObject(name)) return "an object with items, as in " + name + "[...]";
  if (isItem(name)) return "a predefined item";
  return std::nullopt;
}

}  // namespace cobot_command::simulator
