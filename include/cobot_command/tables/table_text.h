// The tables as text: parameters with one text per entry, and a file with one line per entry. doc/tables.md
// has the syntax.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "cobot_command/common/result.h"
#include "cobot_command/tables/data_tables.h"

namespace cobot_command::tables {

/// The place and the reason of an invalid text.
struct TextFault {
  Kind kind{};         ///< of the entry, if known
  std::string place;   ///< "line 3" of a file, "entry 2 of tools" of a list
  std::string text;    ///< the invalid text
  std::string reason;  ///< "at character 7: ..."
};
/// "line 3, "tool 3=1,2": at character ..."
[[nodiscard]] std::string describe(const TextFault& fault);

/// As in parameters: "3=gripper:0,0,150,0,0,0@1" and so on.
struct TableLists {
  std::vector<std::string> tools;
  std::vector<std::string> frames;
  std::vector<std::string> loads;
};

[[nodiscard]] Result<DataTables, TextFault> readLists(const TableLists& lists, const Payload& payload);
[[nodiscard]] TableLists toLists(const DataTables& tables);

/// The content of a file.
struct TableFile {
  DataTables tables;
  bool has_end = false;  ///< the last line has the number of entries; otherwise the file may have been
                         ///< truncated unnoticed
};

/// One line per entry, "tool 3=gripper:0,0,150,0,0,0@1". Empty lines and comments after # are skipped. The
/// line "end N" after N entries is the last one; it is required if there is a line "begin". A file with
/// neither is accepted if it has entries and its last line has a line end, because a missing later part
/// cannot be detected. A file without entries needs "end 0".
[[nodiscard]] Result<TableFile, TextFault> readFile(std::string_view text, const Payload& payload);
/// All entries except the fixed ones, between "begin" and "end N", so that a truncated file is not accepted.
/// Reading it back gives the same values to 1e-9 mm and deg.
[[nodiscard]] std::string toFile(const DataTables& tables);

}  // namespace cobot_command::tables
