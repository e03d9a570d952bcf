#include "cobot_command/runtime/cell/cell_files.h"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cobot_command/cell/program/canonical.h"
#include "cobot_command/cell/program/cell_file.h"
#include "cobot_command/common/foreign_text.h"

namespace cobot_command::runtime {
namespace {

/// Longer ones are refused for their length as cells are read; what has no end is not read that far.
constexpr std::size_t kLongestCellFile = std::size_t{4} << 20;  // [bytes]

/// Where links lead to, whether there is something or not.
std::filesystem::path behindLinks(std::filesystem::path path) {
  constexpr int kMostLinks = 40;  // as of Linux
  std::error_code error;
  for (int link = 0; link < kMostLinks && std::filesystem::is_symlink(path, error); ++link) {
    path = path.parent_path() / std::filesystem::read_symlink(path, error);
  }
  return path;
}

}  // namespace

Result<std::string, std::string> readFile(const std::string& name, std::size_t most) {
  std::error_code error;
  if (std::filesystem::is_directory(name, error)) {
    return refuse(fmt::format("{} cannot be read: it is a folder", foreignText(name)));
  }
  std::ifstream file(name, std::ios::binary);
  std::string text;
  std::string part(std::size_t{1} << 16, char{});
  while (text.size() <= most && file) {
    file.read(part.data(), static_cast<std::streamsize>(part.size()));
    text.append(part, 0, static_cast<std::size_t>(file.gcount()));
  }
  if (!file.is_open() || file.bad()) {
    return refuse(fmt::format("{} cannot be read: {}", foreignText(name), std::strerror(errno)));
  }
  if (text.size() > most) {
    return refuse(fmt::format("{} cannot be read: it is longer than {} bytes", foreignText(name), most));
  }
  return text;
}

std::vector<std::string> writeFile(const std::string& name, const std::string& text,
                                   const std::string& made_of) {
  std::error_code error;
  const std::filesystem::path target = behindLinks(name);
  if (std::filesystem::exists(target, error) && !std::filesystem::is_regular_file(target, error)) {
    return {fmt::format("{} cannot be written: it is not a file", foreignText(name))};
  }
  if (!made_of.empty() && std::filesystem::equivalent(target, made_of, error)) {
    return {fmt::format("{} cannot be written: it is the input file: give the output another name",
                        foreignText(name))};
  }
  // Beside it first, so that nobody ever finds half of one.
  const std::string part = target.string() + ".part";
  std::ofstream file(part, std::ios::binary | std::ios::trunc);
  file << text;
  file.close();
  if (file) std::filesystem::rename(part, target, error);
  if (file && !error) return {};
  const std::string why = error ? error.message() : std::strerror(errno);
  std::filesystem::remove(part, error);
  return {fmt::format("{} cannot be written: {}", foreignText(name), why)};
}

Result<cell::Cell, std::vector<std::string>> readCellFile(const std::string& name) {
  const auto text = readFile(name, kLongestCellFile);
  if (!text) return refuse(std::vector<std::string>{text.error()});
  const auto folder = std::filesystem::path(name).parent_path();
  auto cell = cell::parseCell(*text, name, [&](const std::string& other) {
    return readFile((folder / other).string(), kLongestCellFile);
  });
  if (cell) return std::move(*cell);
  std::vector<std::string> faults;
  for (const cell::Fault& fault : cell.error()) faults.push_back(describe(fault));
  return refuse(faults);
}

Result<cell::Artifact, std::vector<std::string>> readArtifact(const std::string& name) {
  const auto bytes = readFile(name);
  if (!bytes) return refuse(std::vector<std::string>{bytes.error()});
  auto artifact = cell::fromBytes(*bytes);
  if (!artifact) return refuse(std::vector<std::string>{name + ": " + artifact.error()});
  return std::move(*artifact);
}

std::optional<std::string> objectionTo(const cell::Artifact& artifact, const std::string& artifact_file,
                                       const std::string& cell_file) {
  const auto cell = readCellFile(cell_file);
  if (!cell) return fmt::format("{}", fmt::join(cell.error(), "; "));
  const std::string hash = hashOf(*cell);
  if (hash == artifact.hash) return std::nullopt;
  return fmt::format(
      "{} was not made from {}, whose hash is {}, not {}: rebuild it with tm_cell build, for all nodes of "
      "the cell",
      foreignText(artifact_file), foreignText(cell_file), hash.substr(0, 8),
      foreignText(artifact.hash.substr(0, 8)));
}

}  // namespace cobot_command::runtime
