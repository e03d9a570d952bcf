// What may stand in a script, and the text of what is no call.

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

#include "call_text.h"
#include <fmt/format.h>

#include "cobot_command/common/foreign_text.h"
#include "cobot_command/common/project_name.h"
#include "cobot_command/script/script_command.h"

namespace cobot_command::script {

std::string_view toString(IoModule module) {
  return module == IoModule::ControlBox ? "ControlBox" : "EndModule";
}

std::optional<IoModule> ioModule(std::string_view name) {
  for (const IoModule module : {IoModule::ControlBox, IoModule::EndModule}) {
    if (name == toString(module)) return module;
  }
  return std::nullopt;
}

std::string DataFormat::text() const {
  return {static_cast<char>(target), static_cast<char>(speed), static_cast<char>(blending)};
}

bool isName(std::string_view name) {
  return isProjectName(name);
}

bool isScriptLine(std::string_view line) {
  return isUtf8(line) &&
         std::none_of(line.begin(), line.end(), [](char c) { return isControl(c) && c != '\t'; });
}

std::string toText(const WriteOutput& write) {
  assert(write.index >= 0 && write.index < ioCount(write.module));
  return fmt::format("IO[\"{}\"].{}[{}]={}", toString(write.module), write.instant ? "InstantDO" : "DO",
                     write.index, write.on ? 1 : 0);
}

std::string toText(const WriteAnalogOutput& write) {
  assert(std::abs(write.volt) <= kMostVolt);
  std::string text =
      fmt::format("IO[\"{}\"].{}[0]=", toString(IoModule::ControlBox), write.instant ? "InstantAO" : "AO");
  appendNumber(text, write.volt);
  return text;
}

std::string toText(const std::vector<ScriptCommand>& script) {
  std::string lines;
  for (const ScriptCommand& command : script) {
    if (!lines.empty()) lines += "\r\n";
    lines += toText(command);
  }
  return lines;
}

}  // namespace cobot_command::script
