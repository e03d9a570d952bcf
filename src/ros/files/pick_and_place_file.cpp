#include "files/pick_and_place_file.h"

#include <utility>

#include "files/named_file.h"

#include "cobot_command/files/steps/steps_file.h"

namespace cobot_command::ros_adapter {
namespace {

constexpr std::size_t kMaxFileSize = 1 << 20;  // a thousand times the steps of the thesis

}  // namespace

Result<PickAndPlaceSteps, std::string> parsePickAndPlace(const std::string& text, const std::string& name) {
  auto read = files::readSteps(text, name);
  if (!read) return refuse(describe(read.error()));
  PickAndPlaceSteps steps;
  for (files::FileStep& step : *read) steps.push_back(std::move(step.step));
  return steps;
}

Result<PickAndPlaceSteps, std::string> readPickAndPlaceFile(const std::string& location) {
  const auto file = readNamedFile("steps_file", location, kMaxFileSize);
  if (!file) return refuse(file.error());
  return parsePickAndPlace(file->text, file->name);
}

}  // namespace cobot_command::ros_adapter
