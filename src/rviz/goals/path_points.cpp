#include "goals/path_points.h"

#include <algorithm>
#include <vector>

#include <rospack/rospack.h>
#include <yaml-cpp/yaml.h>

namespace cobot_command::rviz_plugin {
namespace {

/// Empty when there is no such package.
std::string folderOf(const std::string& package) {
  rospack::Rospack packages;
  packages.setQuiet(true);
  std::vector<std::string> places;
  std::string folder;
  if (!packages.getSearchPathFromEnv(places)) return "";
  packages.crawl(places, false);
  return packages.find(package, folder) ? folder : "";
}

std::string toPath(const std::string& location) {
  static const std::string kScheme = "package://";
  if (location.compare(0, kScheme.size(), kScheme) != 0) return location;
  const std::size_t slash = std::min(location.find('/', kScheme.size()), location.size());
  return folderOf(location.substr(kScheme.size(), slash - kScheme.size())) + location.substr(slash);
}

}  // namespace

std::optional<int> countPoints(const std::string& location) {
  try {
    const YAML::Node points = YAML::LoadFile(toPath(location))["points"];
    if (points && points.IsSequence()) return static_cast<int>(points.size());
  } catch (const YAML::Exception&) {
    // The command node says what is wrong with it, by line.
  }
  return std::nullopt;
}

}  // namespace cobot_command::rviz_plugin
