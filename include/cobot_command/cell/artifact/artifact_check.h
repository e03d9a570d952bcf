// Checks whether an artifact may be used, independent of its author: everything is computed again from the
// cell in it, and compared.
#pragma once

#include <string>
#include <vector>

#include "cobot_command/cell/artifact/artifact.h"

namespace cobot_command::cell {

struct ArtifactCheck {
  std::vector<std::string> faults;  ///< one sentence each; empty: it may be used
  std::vector<std::string> report;  ///< results, one line each
};

/// Reads the cell file in the artifact, plans, sweeps and cuts it again, finds its zones and holds, and
/// checks that these are sufficient. Compares all of it with the artifact: numbers to 1e-9, because sines
/// differ in their last digits between machines, everything else exactly. The supervisors are not synthesized
/// again, but verified. It takes about as long as the build.
///
/// A valid checksum does not replace this check, because anyone who changes an artifact can write a new one.
[[nodiscard]] ArtifactCheck checkArtifact(const Artifact& artifact, unsigned threads);

}  // namespace cobot_command::cell
