// One thing that an operator enters on a page: its name, unit and range, and what it is now.
#pragma once

#include <string>
#include <vector>

namespace cobot_command::rviz_plugin {

/// One of the values of an enumeration, under a name for people.
struct Option {
  int value = 0;
  std::string label;
};

struct Field {
  enum class Kind {
    Number,  ///< `number`, in lowest..highest
    Choice,  ///< `number`, one of `options`
    Switch,  ///< `number`, 0 or 1
    Text     ///< `text`, at most `longest` bytes
  };

  std::string key;    ///< in saved configurations, and in the names of widgets
  std::string group;  ///< fields that stand together have it in common; empty: it stands alone
  std::string label;
  Kind kind = Kind::Number;
  std::string unit;  ///< behind the number
  double lowest = 0;
  double highest = 0;
  int decimals = 0;
  std::vector<Option> options;
  std::size_t longest = 255;
  std::string hint;  ///< what it is for, in a sentence

  bool shown = true;  ///< false: it means nothing beside what the others are now
  double number = 0;
  std::string text;
};

/// With a whole number of `decimals` 0.
[[nodiscard]] Field numberField(std::string key, std::string label, std::string unit, double lowest,
                                double highest, double number, int decimals = 0);
[[nodiscard]] Field choiceField(std::string key, std::string label, std::vector<Option> options, int value);
[[nodiscard]] Field switchField(std::string key, std::string label, bool on);
[[nodiscard]] Field textField(std::string key, std::string label, std::string text, std::string hint = "");

}  // namespace cobot_command::rviz_plugin
