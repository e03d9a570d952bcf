#include "cobot_command/cell/artifact/artifact_rules.h"

#include <utility>

#include <fmt/format.h>

namespace cobot_command::cell {

Result<Rules, std::string> rulesOf(const Artifact& artifact, Policy policy) {
  auto model = modelOf(artifact.program);
  if (!model) return refuse(fmt::format("{}", fmt::join(model.error(), "; ")));
  if (policy == artifact.policy) return Rules(std::move(*model), artifact.supervisors, policy);
  const auto most = static_cast<std::size_t>(artifact.parameters.max_states);
  const auto parts = synthesizeParts(*model, policy, most);
  if (!parts) return refuse(parts.error());
  return Rules(std::move(*model), *parts, policy);
}

}  // namespace cobot_command::cell
