#include "ask_command.h"

#include <algorithm>
#include <iostream>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cobot_command/arm/arm_model.h"
#include "cobot_command/arm/controller_pose.h"
#include "cobot_command/arm/urdf_prefix.h"
#include "cobot_command/cell/artifact/start_setting.h"
#include "cobot_command/common/foreign_text.h"
#include "cobot_command/runtime/cell/cell_files.h"

namespace cobot_command::tools {
namespace {

Answer said(const std::string& text) {
  std::cout << text << '\n';
  return {};
}

Answer homeOf(const cell::Artifact& artifact, std::size_t user) {
  const std::size_t home = artifact.program.robots[user].home;
  if (user >= artifact.robots.size()) {
    const auto& mechanism = artifact.mechanisms[user - artifact.robots.size()];
    return said(fmt::format("{}", mechanism.stations[home].value));
  }
  const auto joints = arm::toControllerJoints(artifact.robots[user].stations[home].joints);
  return said(fmt::format("[{:.10g}]", fmt::join(joints, ", ")));
}

Answer tcpOf(const cell::Artifact& artifact, std::size_t robot) {
  const auto tcp = arm::toControllerPose(cell::startTcp(artifact, robot));
  return said(fmt::format("[{:.10g}]", fmt::join(tcp, ", ")));
}

/// Its links and joints have its name in front.
Answer urdfOf(const cell::Artifact& artifact, std::size_t robot) {
  const auto urdf = arm::withPrefix(arm::ArmModel::urdfOf(artifact.robots[robot].model),
                                    artifact.program.robots[robot].name + "_");
  return urdf ? said(*urdf) : wrong("ask", urdf.error().message);
}

Answer placesOf(const cell::Artifact& artifact, std::size_t user) {
  const auto model = cell::modelOf(artifact.program);
  if (!model) return wrong("ask", model.error().front());
  std::vector<std::string> names;
  for (const cell::CellPlace& place : model->places[user]) names.push_back(place.name);
  return said(fmt::format("{}", fmt::join(names, " ")));
}

}  // namespace

Answer askArtifact(const AskOptions& options) {
  const auto artifact = runtime::readArtifact(options.artifact);
  if (!artifact) return wrong("ask", artifact.error().front());
  std::vector<std::string> users;
  for (const cell::RobotProgram& user : artifact->program.robots) users.push_back(user.name);
  const auto first_mechanism = users.begin() + static_cast<std::ptrdiff_t>(artifact->robots.size());
  const bool is_of_all = options.what == "robots" || options.what == "mechanisms" || options.what == "speed";
  if (is_of_all && !options.robot.empty()) {
    return wrong("ask", fmt::format("unexpected argument \"{}\": {} refers to the whole cell",
                                    foreignText(options.robot, kQuoteLimit), options.what));
  }
  if (options.what == "robots") {
    return said(fmt::format("{}", fmt::join(users.begin(), first_mechanism, " ")));
  }
  if (options.what == "mechanisms") {
    return said(fmt::format("{}", fmt::join(first_mechanism, users.end(), " ")));
  }
  if (options.what == "speed") return said(fmt::format("{}", cell::highestProjectSpeed(*artifact)));
  const bool is_of_robots = options.what == "model" || options.what == "tcp" || options.what == "urdf";
  const auto end = is_of_robots ? first_mechanism : users.end();
  const auto found = std::find(users.begin(), end, options.robot);
  if (found == end) {
    return wrong("ask", fmt::format("there is no \"{}\" with a {}: the artifact has {}",
                                    foreignText(options.robot, kQuoteLimit), options.what,
                                    fmt::join(users.begin(), end, ", ")));
  }
  const auto user = static_cast<std::size_t>(found - users.begin());
  if (options.what == "places") return placesOf(*artifact, user);
  if (options.what == "tcp") return tcpOf(*artifact, user);
  if (options.what == "urdf") return urdfOf(*artifact, user);
  return options.what == "model" ? said(artifact->robots[user].model) : homeOf(*artifact, user);
}

}  // namespace cobot_command::tools
