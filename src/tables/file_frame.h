// The lines of a file of tables that are no entries, "begin" and "end N": they show whether all of it is
// there.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace cobot_command::tables {

inline constexpr std::string_view kFirstLine = "begin";
inline constexpr std::string_view kLastLine = "end";

/// Sees the lines of one file, in their order. Each function says what is wrong and what to do, or nothing.
class FileFrame {
 public:
  [[nodiscard]] static bool isPart(std::string_view line);
  /// Precondition: isPart(line).
  [[nodiscard]] std::optional<std::string> take(std::string_view line);
  [[nodiscard]] std::optional<std::string> takeEntry();
  /// After all lines; `last_has_end`: what the last one ends with is there.
  [[nodiscard]] std::optional<std::string> whatIsMissing(bool last_has_end) const;

  [[nodiscard]] bool hasEnd() const { return has_end_; }

 private:
  [[nodiscard]] std::optional<std::string> takeEnd(std::string_view number);

  std::size_t entries_ = 0;
  bool has_begin_ = false;
  bool has_end_ = false;
};

}  // namespace cobot_command::tables
