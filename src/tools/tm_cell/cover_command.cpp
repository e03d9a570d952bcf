#include "cover_command.h"

#include <chrono>
#include <filesystem>
#include <iostream>

#include <fmt/format.h>

#include "cobot_command/cell/covering/box_cover.h"
#include "cobot_command/common/foreign_text.h"
#include "cobot_command/runtime/cell/cell_files.h"

namespace cobot_command::tools {

using runtime::readFile;
using runtime::writeFile;

Answer coverMesh(const CoverOptions& options) {
  const auto begin = std::chrono::steady_clock::now();
  const auto bytes = readFile(options.mesh);
  if (!bytes) return wrong("cover", bytes.error());
  auto triangles = cell::trianglesOfStl(*bytes);
  if (!triangles) return wrong("cover", foreignText(options.mesh) + ": " + triangles.error());
  for (cell::Triangle& triangle : *triangles) {
    for (Eigen::Vector3d& corner : triangle) corner *= options.scale;
  }
  const auto boxes = cell::boxesOver(*triangles, options.cell);
  if (!boxes) return wrong("cover", foreignText(options.mesh) + ": " + boxes.error());
  const std::string found =
      fmt::format("{} boxes of cells of {:g} mm cover the {} triangles of {}", boxes->size(), options.cell,
                  triangles->size(), foreignText(std::filesystem::path(options.mesh).filename().string()));
  if (boxes->size() > cell::kMostShapes) {
    return wrong("cover",
                 fmt::format("{}; a part or obstacle of a cell has at most {} shapes: choose a larger --cell",
                             found, cell::kMostShapes));
  }
  const std::string text = "# " + found + "\n" + shapesText(*boxes);
  if (options.output.empty()) {
    std::cout << text;
    return {};
  }
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return {{{"cover", seconds, {found, options.output}, writeFile(options.output, text, options.mesh)}}};
}

}  // namespace cobot_command::tools
