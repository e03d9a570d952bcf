// The decision rules of a supervisor, created from an artifact.
#pragma once

#include <string>

#include "cobot_command/cell/artifact/artifact.h"
#include "cobot_command/cell/model/rules.h"
#include "cobot_command/common/result.h"

namespace cobot_command::cell {

/// With a policy different from that of the artifact, the supervisors are computed again. A fault is a
/// sentence.
[[nodiscard]] Result<Rules, std::string> rulesOf(const Artifact& artifact, Policy policy);

}  // namespace cobot_command::cell
