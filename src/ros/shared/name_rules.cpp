#include "shared/name_rules.h"

#include <string>

#include <ros/names.h>

namespace cobot_command::ros_adapter {

setting_kinds::TextRule absoluteNamespace() {
  return {"an absolute namespace, for example \"/cell\"", [](const std::string& name) {
            std::string reason;
            return name.size() > 1 && name.front() == '/' && name.back() != '/' &&
                   ros::names::validate(name, reason);
          }};
}

setting_kinds::TextRule absolutePath() {
  return {"an absolute path", [](const std::string& name) { return !name.empty() && name.front() == '/'; }};
}

}  // namespace cobot_command::ros_adapter
