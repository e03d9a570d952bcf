// What a supervisor decides by, and where it knows robots to be, out of an artifact.
#pragma once

#include <string>

#include "cobot_command/cell/artifact/artifact.h"
#include "cobot_command/cell/model/rules.h"
#include "cobot_command/common/result.h"

namespace cobot_command::cell {

/// With another policy than that of the artifact its supervisors are found anew. A fault is a sentence.
[[nodiscard]] Result<Rules, std::string> rulesOf(const Artifact& artifact, Policy policy);

}  // namespace cobot_command::cell
