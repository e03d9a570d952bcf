// The parts of an artifact as JSON, and back. What is not as it was written throws a
// nlohmann::json::exception, to be caught by who reads the whole.
#pragma once

#include <nlohmann/json.hpp>

#include "cobot_command/cell/artifact/artifact.h"

namespace cobot_command::cell {

[[nodiscard]] nlohmann::json toJson(const arm::JointVector& joints);
[[nodiscard]] arm::JointVector jointsFrom(const nlohmann::json& json);
[[nodiscard]] nlohmann::json toJson(const arm::Pose& pose);
[[nodiscard]] arm::Pose poseFrom(const nlohmann::json& json);

[[nodiscard]] nlohmann::json toJson(const CellProgram& program);
[[nodiscard]] CellProgram programFrom(const nlohmann::json& json);
[[nodiscard]] nlohmann::json toJson(const ArtifactRobot& robot);
[[nodiscard]] ArtifactRobot robotFrom(const nlohmann::json& json);
[[nodiscard]] nlohmann::json toJson(const Zone& zone);
[[nodiscard]] Zone zoneFrom(const nlohmann::json& json);
[[nodiscard]] nlohmann::json toJson(const PartSupervisor& supervisor);
[[nodiscard]] PartSupervisor supervisorFrom(const nlohmann::json& json);

/// For what the types of JSON do not tell.
[[noreturn]] void wrongInArtifact(const std::string& what);

}  // namespace cobot_command::cell
