// The parts of an artifact as JSON, and back. What is not as it was written throws a
// nlohmann::json::exception, to be caught by who reads the whole.
#pragma once

#include <nlohmann/json.hpp>

#include "cobot_command/cell/artifact/artifact.h"

namespace cobot_command::cell {

/// All but its source, and what is said of it as a whole.
[[nodiscard]] nlohmann::json toJson(const Artifact& artifact);

[[nodiscard]] nlohmann::json toJson(const arm::JointVector& joints);
[[nodiscard]] arm::JointVector jointsFrom(const nlohmann::json& json);
[[nodiscard]] nlohmann::json toJson(const arm::Pose& pose);
[[nodiscard]] arm::Pose poseFrom(const nlohmann::json& json);

[[nodiscard]] nlohmann::json toJson(const Capsules& capsules);
[[nodiscard]] Capsules capsulesFrom(const nlohmann::json& json);

/// On whichever path: holds and the places of zone steps.
[[nodiscard]] nlohmann::json toJson(const std::vector<Hold>& holds);
[[nodiscard]] std::vector<Hold> holdsFrom(const nlohmann::json& json);
[[nodiscard]] nlohmann::json toJson(const std::vector<ZonePlace>& places);
[[nodiscard]] std::vector<ZonePlace> placesFrom(const nlohmann::json& json);

[[nodiscard]] nlohmann::json toJson(const CellProgram& program);
[[nodiscard]] CellProgram programFrom(const nlohmann::json& json);
[[nodiscard]] nlohmann::json toJson(const ArtifactRobot& robot);
[[nodiscard]] ArtifactRobot robotFrom(const nlohmann::json& json);
[[nodiscard]] nlohmann::json toJson(const ArtifactMechanism& mechanism);
[[nodiscard]] ArtifactMechanism mechanismFrom(const nlohmann::json& json);
[[nodiscard]] nlohmann::json toJson(const Zone& zone);
[[nodiscard]] Zone zoneFrom(const nlohmann::json& json);
[[nodiscard]] nlohmann::json toJson(const PartSupervisor& supervisor);
[[nodiscard]] PartSupervisor supervisorFrom(const nlohmann::json& json);

[[nodiscard]] double finiteFrom(const nlohmann::json& json);

/// For what the types of JSON do not tell.
[[noreturn]] void wrongInArtifact(const std::string& what);

}  // namespace cobot_command::cell
