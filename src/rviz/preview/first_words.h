// As much of a reason as can be read in a scene.
#pragma once

#include <string>

namespace cobot_command::rviz_plugin {

/// Its first sentence, and of that at most eighty characters.
[[nodiscard]] std::string firstWords(const std::string& reason);

}  // namespace cobot_command::rviz_plugin
