// Our tables beside what the controller's project has: entry by entry, for those that it knows by name.
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "sync/project_values.h"

#include "cobot_command/tables/data_tables.h"

namespace cobot_command::command {

/// A tool in the flange, a frame in the robot base; or a load.
using EntryValue = std::variant<arm::Pose, tables::Load>;

/// Equal as far as the controller's floats can tell: to 0.001 mm and deg, 0.001 kg, 0.1 kg mm^2.
[[nodiscard]] bool isSame(const EntryValue& a, const EntryValue& b);
/// "0,0,150,0,0,0", "2 kg".
[[nodiscard]] std::string describe(const EntryValue& value);

struct NamedValue {
  std::string name;                 ///< in the project
  std::optional<EntryValue> value;  ///< nothing: it has not been read
};

struct ComparedEntry {
  tables::Kind kind = tables::Kind::Tool;
  int index = 0;
  std::optional<EntryValue> ours;  ///< nothing: what the controller has counts
  std::vector<NamedValue> theirs;  ///< one; of a load, those of all tools that have it
  std::string also_named = {};     ///< another entry with that name and another value; empty: there is none
  std::optional<EntryValue> own = {};  ///< ours as it stands in the table: of a frame, in its reference

  /// All that was read, and has to be, is the same.
  [[nodiscard]] bool isInSync() const;
  /// All of theirs is known.
  [[nodiscard]] bool isRead() const;
  /// What they agree on; nothing: they do not, or it was not read.
  [[nodiscard]] std::optional<EntryValue> theirValue() const;
  /// "tool 3 "gripper" is ... on the controller, ... here".
  [[nodiscard]] std::string difference() const;
};

/// Those that the project knows by name, and the loads of such tools. Tools first, then frames that stand in
/// the robot base, those that refer to them, and loads.
[[nodiscard]] std::vector<ComparedEntry> compare(const tables::DataTables& ours, const ProjectValues& theirs);

/// Where that tool is, by our tables, or else by the project: what a centre of mass in its TCP is seen from.
[[nodiscard]] std::optional<arm::Pose> tcpOf(const tables::Tool& tool, const ProjectValues& theirs);

}  // namespace cobot_command::command
