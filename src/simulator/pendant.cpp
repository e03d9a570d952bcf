#include "pendant.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cobot_command/common/given.h"

namespace cobot_command::simulator {

namespace {

using Complaint = std::optional<std::string>;

template <class Map>
Complaint objectionTo(const Map& map, const char* what, const std::string& name) {
  const auto found = map.find(name);
  if (found == map.end()) {
    return fmt::format("the project has no {} {}; it has {}", what, quoted(name), namesOf(map));
  }
  if (!found->second.is_fixed) return std::nullopt;
  return fmt::format("the {} {} is fixed and cannot be changed", what, quoted(name));
}

// The comparisons are written so that NaN is refused as well.
Complaint objectionTo(const arm::ControllerPose& pose) {
  for (const double number : pose) {
    if (std::abs(number) <= arm::kMaxCoordinate) continue;
    return fmt::format("the number {}: allowed are {} to {} [mm, deg]", number, -arm::kMaxCoordinate,
                       arm::kMaxCoordinate);
  }
  return std::nullopt;
}

Complaint objectionTo(const SetLoad& load) {
  if (!(load.mass >= 0 && load.mass <= kMostMass)) {
    return fmt::format("a mass of {} kg: allowed are 0 to {}", load.mass, kMostMass);
  }
  for (const double moment : load.moment.value_or(std::array<double, 3>{})) {
    if (moment >= 0 && moment <= kMostMoment) continue;
    return fmt::format("a moment of inertia of {} kg mm^2: allowed are 0 to {:.0f}", moment, kMostMoment);
  }
  return objectionTo(load.mass_center.value_or(arm::ControllerPose{}));
}

template <std::size_t N>
std::array<float, N> asKept(const std::array<double, N>& numbers) {
  std::array<float, N> floats{};
  std::transform(numbers.begin(), numbers.end(), floats.begin(),
                 [](double number) { return static_cast<float>(number) + 0.0F; });  // no -0
  return floats;
}

/// The pendant does not touch the other values of the tool, which a script may have changed for this run.
template <class T, class Change>
void change(Taught<T>& thing, Change to) {
  to(thing.now);
  to(thing.taught);
}

}  // namespace

OperatorReply teach(ProjectData& project, const SetTcp& action) {
  if (auto objection = objectionTo(project.tools, "TCP", action.name)) return notDone(*objection);
  if (auto objection = objectionTo(action.value)) return notDone(*objection);
  const Frame frame(asKept(action.value));
  change(project.tools.at(action.name), [&](Tool& tool) { tool.frame = frame; });
  return {true, fmt::format("the TCP {} is at {}", quoted(action.name), fmt::join(frame.numbers, ", "))};
}

OperatorReply teach(ProjectData& project, const SetBase& action) {
  if (auto objection = objectionTo(project.bases, "base", action.name)) return notDone(*objection);
  if (auto objection = objectionTo(action.value)) return notDone(*objection);
  const Frame frame(asKept(action.value));
  change(project.bases.at(action.name), [&](Frame& base) { base = frame; });
  return {true, fmt::format("the base {} is at {}", quoted(action.name), fmt::join(frame.numbers, ", "))};
}

OperatorReply teach(ProjectData& project, const SetLoad& action) {
  if (auto objection = objectionTo(project.tools, "TCP", action.name)) return notDone(*objection);
  if (auto objection = objectionTo(action)) return notDone(*objection);
  Taught<Tool>& tool = project.tools.at(action.name);
  change(tool, [&](Tool& changed) {
    changed.mass = static_cast<float>(action.mass);
    if (action.moment) changed.moment = asKept(*action.moment);
    if (action.mass_center) changed.mass_center = asKept(*action.mass_center);
  });
  return {true, fmt::format("the TCP {} weighs {} kg, inertia {} kg mm^2, centre at {}", quoted(action.name),
                            tool.taught.mass, fmt::join(tool.taught.moment, ", "),
                            fmt::join(tool.taught.mass_center, ", "))};
}

}  // namespace cobot_command::simulator
