#include "robot/tmflow_version.h"

#include <algorithm>

#include "cobot_command/simulator/settings.h"

namespace cobot_command::simulator {

const std::vector<std::string>& knownTmflowVersions() {
  static const std::vector<std::string> kVersions{"1.68", "1.72", "1.76", "1.80", "1.82", "1.84"};
  return kVersions;
}

tm_script::Version tmflowVersion(const std::string& text) {
  const auto& known = knownTmflowVersions();
  if (std::find(known.begin(), known.end(), text) == known.end()) return {1, 80};
  return {1, std::stoi(text.substr(2))};
}

}  // namespace cobot_command::simulator
