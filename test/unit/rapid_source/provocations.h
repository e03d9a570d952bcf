// The shortest text that provokes each finding of reading, and where it is found.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "cobot_command/rapid/source/dialect.h"

namespace cobot_command::rapid {

struct Provocation {
  std::string_view id;
  /// A line in a routine, if it does not begin with MODULE or `%`; see atRoutineLine().
  std::string text;
  int line;
  int column;
  std::string_view message;
  Dialect dialect = Dialect::Irc5;
};

/// All rows; more than one of an id if it has several forms.
[[nodiscard]] const std::vector<Provocation>& provocations();

}  // namespace cobot_command::rapid
