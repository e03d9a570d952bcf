// The shortest text that provokes each finding of checking, and where it is found.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "cobot_command/rapid/checks/check.h"

namespace cobot_command::rapid {

struct CheckProvocation {
  std::string_view id;
  /// A whole file if it begins with MODULE; a part of a module if it begins with another word of a
  /// declaration; else lines of main(). See frame().
  std::string text;
  int line;    ///< in `text`, from 1
  int column;  ///< in this line
  std::string_view message;
  Dialect dialect = Dialect::Irc5;
};

/// All rows in the order of their ids; more than one of an id if it has several forms.
[[nodiscard]] const std::vector<CheckProvocation>& checkProvocations();

/// A program around a text, which declares `a` num, `s` string, `p` pos, `f` FUNC num f(num x) and more, and
/// has the signals di1 and do1.
struct FramedText {
  std::string text;
  int line = 1;  ///< of the first line of the text within it
};
[[nodiscard]] FramedText frame(const std::string& text);
[[nodiscard]] CheckOptions frameOptions();

}  // namespace cobot_command::rapid
