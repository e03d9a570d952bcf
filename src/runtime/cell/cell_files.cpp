#include "cobot_command/runtime/cell/cell_files.h"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>

#include <fmt/format.h>

#include "cobot_command/cell/program/cell_file.h"
#include "cobot_command/common/foreign_text.h"

namespace cobot_command::runtime {

Result<std::string, std::string> readFile(const std::string& name) {
  std::error_code error;
  if (std::filesystem::is_directory(name, error)) {
    return refuse(fmt::format("{} cannot be read: it is a folder", foreignText(name)));
  }
  std::ifstream file(name, std::ios::binary);
  std::string text(std::istreambuf_iterator<char>(file), {});
  if (!file.is_open() || file.bad()) {
    return refuse(fmt::format("{} cannot be read: {}", foreignText(name), std::strerror(errno)));
  }
  return text;
}

std::vector<std::string> writeFile(const std::string& name, const std::string& text) {
  // Beside it first, so that nobody ever finds half of one.
  const std::string part = name + ".part";
  std::ofstream file(part, std::ios::binary | std::ios::trunc);
  file << text;
  file.close();
  std::error_code error;
  if (file) std::filesystem::rename(part, name, error);
  if (file && !error) return {};
  std::filesystem::remove(part, error);
  return {fmt::format("{} cannot be written: {}", foreignText(name), std::strerror(errno))};
}

Result<cell::Cell, std::vector<std::string>> readCellFile(const std::string& name) {
  const auto text = readFile(name);
  if (!text) return refuse(std::vector<std::string>{text.error()});
  const auto folder = std::filesystem::path(name).parent_path();
  auto cell = cell::parseCell(*text, name,
                              [&](const std::string& other) { return readFile((folder / other).string()); });
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

}  // namespace cobot_command::runtime
