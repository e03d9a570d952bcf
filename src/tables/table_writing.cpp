#include "file_frame.h"
#include "table_scanner.h"
#include <fmt/format.h>

#include "cobot_command/arm/controller_pose.h"
#include "cobot_command/common/units.h"
#include "cobot_command/tables/table_text.h"

namespace cobot_command::tables {
namespace {

/// To 1e-9, which is far above what the way into SI and back rounds away, and without zeros at its end.
std::string toText(double number) {
  std::string text = fmt::format("{:.9f}", number);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text == "-0" ? "0" : text;
}

std::string toText(const arm::Pose& pose) {
  const arm::ControllerPose six = arm::toControllerPose(pose);
  std::string text;
  for (std::size_t i = 0; i < six.size(); ++i) {
    const std::string number = toText(six[i]);
    text += i == 0 ? "" : ",";
    text += i >= 3 && number == "-180" ? "180" : number;  // the same angle, and of the range
  }
  return text;
}

std::string toText(const std::string& name) {
  if (isBareName(name)) return name;
  std::string text = "\"";
  for (const char c : name) text += c == '"' ? std::string("\"\"") : std::string(1, c);
  return text + '"';
}

std::string placedText(int index, const std::string& name, const std::optional<arm::Pose>& pose,
                       int refers_to) {
  return fmt::format("{}={}{}{}{}", index, name.empty() ? "" : toText(name), !name.empty() && pose ? ":" : "",
                     pose ? toText(*pose) : "", refers_to == 0 ? "" : fmt::format("@{}", refers_to));
}

std::string toText(int index, const Tool& tool) {
  return placedText(index, tool.name, tool.pose, tool.load);
}

std::string toText(int index, const Frame& frame) {
  return placedText(index, frame.name, frame.pose, frame.reference);
}

std::string toText(int index, const Load& load) {
  Load only_mass;
  only_mass.mass = load.mass;
  if (load == only_mass) return fmt::format("{}={}", index, load.mass);
  std::string text = fmt::format("{}={}", index, load.mass);
  // Fourteen digits are what is the same again after the way into SI and back.
  for (const double moment : load.inertia) text += fmt::format(",{:.14g}", moment * kMm2PerM2);
  return text + ',' + toText(load.centre);
}

template <class Entry>
std::vector<std::string> listOf(const Table<Entry>& table) {
  std::vector<std::string> list;
  for (int index = 1; index < kEntryCount; ++index) {
    const auto& entry = table[static_cast<std::size_t>(index)];
    if (entry) list.push_back(toText(index, *entry));
  }
  return list;
}

}  // namespace

TableLists toLists(const DataTables& tables) {
  const Entries& entries = tables.entries();
  return {listOf(entries.tools), listOf(entries.frames), listOf(entries.loads)};
}

std::string toFile(const DataTables& tables) {
  const TableLists lists = toLists(tables);
  std::string text =
      "# Tools, frames and loads of cobot_command, see doc/tables.md. Rewritten when one of them changes:\n# "
      "comments other than these are not kept. The last line has the number of the entries.\n";
  std::size_t count = 0;
  const auto add = [&](Kind kind, const std::vector<std::string>& list) {
    for (const std::string& entry : list) text += fmt::format("{} {}\n", toString(kind), entry);
    count += list.size();
  };
  text += fmt::format("{}\n", kFirstLine);
  add(Kind::Tool, lists.tools);
  add(Kind::Frame, lists.frames);
  add(Kind::Load, lists.loads);
  return text + fmt::format("{} {}\n", kLastLine, count);
}

}  // namespace cobot_command::tables
