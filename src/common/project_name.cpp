#include "cobot_command/common/project_name.h"

#include <algorithm>

#include "cobot_command/common/foreign_text.h"

namespace cobot_command {

bool isProjectName(std::string_view name) {
  return !name.empty() && name.size() <= kLongestProjectName && isUtf8(name) &&
         std::none_of(name.begin(), name.end(), isControl);
}

}  // namespace cobot_command
