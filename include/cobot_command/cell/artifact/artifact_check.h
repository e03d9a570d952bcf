// Whether an artifact may be run, whoever has written it: all that it has is made anew of the cell that it
// holds, and compared.
#pragma once

#include <string>
#include <vector>

#include "cobot_command/cell/artifact/artifact.h"

namespace cobot_command::cell {

struct ArtifactCheck {
  std::vector<std::string> faults;  ///< each a sentence; none: it may be run
  std::vector<std::string> report;  ///< what was found, a line each
};

/// Reads the cell's file in it, plans, sweeps and cuts it anew, finds its zones and holds, checks that they
/// are enough, and compares all of it with what the artifact has: numbers to 1e-9, as sines differ in their
/// last digits from machine to machine, everything else exactly. Its supervisors are not synthesized anew,
/// but verified. It takes about as long as the build.
///
/// A checksum that fits says nothing of that: whoever changes an artifact can write one.
[[nodiscard]] ArtifactCheck checkArtifact(const Artifact& artifact, unsigned threads);

}  // namespace cobot_command::cell
