#include "cobot_command/ros/tables/table_parameters.h"

#include <algorithm>
#include <utility>

#include "tables/tables_file.h"
#include <fmt/format.h>

#include "cobot_command/common/foreign_text.h"
#include "cobot_command/common/setting_kinds.h"

namespace cobot_command::ros_adapter {
namespace {

using namespace setting_kinds;

constexpr const char* kPlacedEntry = "N=NAME, N=X,Y,Z,RX,RY,RZ [mm, deg] or N=NAME:X,Y,Z,RX,RY,RZ";
constexpr const char* kFileRule = "an absolute path without control characters";

TextRule absolutePath() {
  return {kFileRule, [](const std::string& path) {
            return !path.empty() && path.front() == '/' && path.back() != '/' &&
                   std::none_of(path.begin(), path.end(), isControl);
          }};
}

const Setting& rowOf(const SettingTable& rows, tables::Kind kind) {
  return rows[static_cast<std::size_t>(kind)];
}

SettingFault faultOfList(const SettingTable& rows, const tables::TextFault& fault) {
  const Setting& row = rowOf(rows, fault.kind);
  return {row.name, fmt::format("holds {}: {}", quoted(fault.text), fault.reason), allowedBy(row.kind)};
}

SettingFault faultOfFile(const std::string& path, const std::string& why) {
  return {"tables_file", fmt::format("is {}: {}", foreignText(path), why),
          "a tables file that can be read and written (doc/tables.md), a file that does not exist yet, or no "
          "path"};
}

std::string writtenAnew(const std::string& path) {
  return fmt::format(
      "the last line of {}, with the number of entries, was missing, so missing entries cannot be detected: "
      "the file was accepted and rewritten with that line. Check that all tools, frames and loads are in it",
      foreignText(path));
}

}  // namespace

SettingTable tableRows(TableParameters& p) {
  const std::string placed = std::string("a list of texts ") + kPlacedEntry;
  return {
      {"tools", texts(p.lists.tools, placed + ", each with @LOAD or without"),
       "tools 1 to 15, used while ~tables_file does not exist; see doc/tables.md"},
      {"frames", texts(p.lists.frames, placed + ", each with @REFERENCE or without"), "the same for frames"},
      {"loads",
       texts(p.lists.loads,
             "a list of texts N=KG or N=KG,IXX,IYY,IZZ,X,Y,Z,RX,RY,RZ [kg mm^2; centre in mm, deg]"),
       "the same for loads"},
      {"tables_file", text(p.file, orEmpty(absolutePath())),
       "stores written tools, frames and loads for the next start; created by the first write. If the file "
       "exists, the lists above are not used. Each robot needs its own file"},
  };
}

std::optional<SettingFault> readTables(TableParameters& parameters, const arm::ArmModel* arm,
                                       std::vector<std::string>& warnings) {
  const tables::Payload payload = arm != nullptr ? tables::payloadOf(*arm) : tables::Payload();
  auto of_lists = tables::readLists(parameters.lists, payload);
  if (!of_lists) return faultOfList(tableRows(parameters), of_lists.error());
  parameters.tables = *std::move(of_lists);
  if (parameters.file.empty()) return std::nullopt;
  const auto kept = readTablesFile(parameters.file);
  if (!kept) return faultOfFile(parameters.file, kept.error());
  if (const auto why_not = whyNotWritable(parameters.file)) return faultOfFile(parameters.file, *why_not);
  if (!*kept) return std::nullopt;
  auto of_file = tables::readFile(**kept, payload);
  if (!of_file) return faultOfFile(parameters.file, describe(of_file.error()));
  if (!of_file->has_end) {
    if (const auto why_not = writeTablesFile(parameters.file, toFile(of_file->tables))) {
      return faultOfFile(parameters.file, *why_not);
    }
    warnings.push_back(writtenAnew(parameters.file));
  }
  const tables::TableLists& lists = parameters.lists;
  const bool has_lists = !lists.tools.empty() || !lists.frames.empty() || !lists.loads.empty();
  if (has_lists && toFile(of_file->tables) != toFile(parameters.tables)) {
    warnings.push_back(
        fmt::format("tools, frames and loads are taken from {}, and the parameters ~tools, ~frames and "
                    "~loads differ: remove the file to use the parameters",
                    foreignText(parameters.file)));
  }
  parameters.tables = std::move(of_file->tables);
  return std::nullopt;
}

}  // namespace cobot_command::ros_adapter
