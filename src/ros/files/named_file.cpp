#include "files/named_file.h"

#include <algorithm>
#include <filesystem>
#include <mutex>
#include <vector>

#include "shared/regular_file.h"
#include <fmt/format.h>
#include <rospack/rospack.h>

#include "cobot_command/common/foreign_text.h"

namespace cobot_command::ros_adapter {
namespace {

/// Empty when there is no such package. Not roslib's own way, which tells of it on standard error besides.
/// One at a time, as there: librospack is not made for threads (getpwuid(), for one, has one answer for all),
/// and files are read by several. Only the crawl waits here, for another crawl.
std::string folderOf(const std::string& package) {
  static std::mutex one_at_a_time;
  const std::lock_guard<std::mutex> lock(one_at_a_time);
  rospack::Rospack packages;
  packages.setQuiet(true);
  std::vector<std::string> places;
  if (!packages.getSearchPathFromEnv(places)) return "";
  packages.crawl(places, false);
  std::string folder;
  return packages.find(package, folder) ? folder : "";
}

/// Leads it out of the folder in which it is looked for? Links in there lead where whoever made them wants.
bool leadsOut(const std::filesystem::path& path) {
  return path.is_absolute() || *path.lexically_normal().begin() == "..";
}

/// The path on this machine; its error says what is wrong with the location.
Result<std::filesystem::path, std::string> toPath(const char* field, const std::string& location) {
  static const std::string kScheme = "package://";
  if (location.find('\0') != std::string::npos) {
    return refuse(fmt::format("{} is '{}'; a path must not contain NUL", field, foreignText(location)));
  }
  if (location.compare(0, kScheme.size(), kScheme) != 0) {
    if (std::filesystem::path(location).is_absolute()) return std::filesystem::path(location);
    return refuse(fmt::format("{} is '{}'; it must be an absolute path, or package://NAME/path", field,
                              foreignText(location)));
  }
  const std::size_t slash = std::min(location.find('/', kScheme.size()), location.size());
  const std::string package = location.substr(kScheme.size(), slash - kScheme.size());
  const std::string path = location.substr(std::min(slash + 1, location.size()));
  const std::string folder = folderOf(package);
  if (folder.empty()) {
    return refuse(fmt::format("{}: package '{}' is not found", foreignText(location),
                              foreignText(package, kQuoteLimit)));
  }
  if (path.empty()) return refuse(foreignText(location) + ": the path in the package is missing");
  if (leadsOut(path)) {
    return refuse(
        fmt::format("{}: the path leads out of the package; give an absolute path for a file elsewhere",
                    foreignText(location)));
  }
  return std::filesystem::path(folder) / path;
}

}  // namespace

Result<NamedFile, std::string> readNamedFile(const char* field, const std::string& location,
                                             std::size_t most_bytes) {
  const auto path = toPath(field, location);
  if (!path) return refuse(path.error());
  auto text = readRegularFile(*path, most_bytes);
  std::string name = foreignText(path->string());
  if (!text) return refuse(fmt::format("{}: {}", name, text.error()));
  return NamedFile{std::move(name), std::move(*text)};
}

}  // namespace cobot_command::ros_adapter
