// The tables as text: of parameters, one text an entry, and of a file, one line an entry. doc/tables.md has
// the forms.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "cobot_command/common/result.h"
#include "cobot_command/tables/data_tables.h"

namespace cobot_command::tables {

/// Where a text is wrong, and why.
struct TextFault {
  Kind kind{};         ///< of the entry, where that is known
  std::string place;   ///< "line 3" of a file, "entry 2 of tools" of a list
  std::string text;    ///< what stands there
  std::string reason;  ///< "at character 7: ..."
};
/// "line 3, "tool 3=1,2": at character ..."
[[nodiscard]] std::string describe(const TextFault& fault);

/// As parameters have them: "3=gripper:0,0,150,0,0,0@1" and so on.
struct TableLists {
  std::vector<std::string> tools;
  std::vector<std::string> frames;
  std::vector<std::string> loads;
};

[[nodiscard]] Result<DataTables, TextFault> readLists(const TableLists& lists, const Payload& payload);
[[nodiscard]] TableLists toLists(const DataTables& tables);

/// What a file says.
struct TableFile {
  DataTables tables;
  bool has_end = false;  ///< its last line has the number of its entries; else it may have been cut unnoticed
};

/// One line an entry, "tool 3=gripper:0,0,150,0,0,0@1"; empty lines and comments after # are passed over. The
/// line "end N" after N entries is the last one, and must be there where a line "begin" is. A file with
/// neither is taken if it has entries and its last line has an end, as no later part of it can be proved to
/// be missing; a file without entries only with "end 0".
[[nodiscard]] Result<TableFile, TextFault> readFile(std::string_view text, const Payload& payload);
/// All entries but the fixed ones between "begin" and "end N", so that no shorter piece of it is taken. What
/// is read of it is the same to 1e-9 mm and deg.
[[nodiscard]] std::string toFile(const DataTables& tables);

}  // namespace cobot_command::tables
