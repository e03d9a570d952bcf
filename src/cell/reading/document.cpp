#include "reading/document.h"

#include <algorithm>
#include <string_view>

#include <fmt/format.h>

#include "cobot_command/common/foreign_text.h"

namespace cobot_command::cell {

void checkText(const std::string& text, FaultList& faults) {
  if (text.size() > kMostBytes) {
    faults.add({faults.file(), 0, 0}, "",
               {"", fmt::format("has {} bytes", text.size()), fmt::format("at most {}", kMostBytes), ""});
    return;
  }
  int line = 1;
  for (std::size_t begin = 0; begin <= text.size(); ++line) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    const std::string_view row = std::string_view(text).substr(begin, end - begin);
    const auto strange =
        std::find_if(row.begin(), row.end(), [](char c) { return isControl(c) && c != '\t' && c != '\r'; });
    if (strange != row.end() || !isUtf8(row)) {
      const int column = strange == row.end() ? 1 : static_cast<int>(strange - row.begin()) + 1;
      faults.add({faults.file(), line, column}, "",
                 {"", strange == row.end() ? "is not UTF-8 in this line" : "has a control character",
                  "UTF-8 without control characters", "write the line again"});
      return;
    }
    begin = end + 1;
  }
}

}  // namespace cobot_command::cell
