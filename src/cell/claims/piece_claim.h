// What a piece claims.
#pragma once

#include "cobot_command/cell/claims/claims.h"

namespace cobot_command::cell {

/// All voxels in which a body can be in this piece, or too near to be anybody else's (cell.md, M9). What the
/// piece has claimed already is not looked at.
[[nodiscard]] VoxelSet claimOf(const Piece& piece, const Parameters& parameters);

}  // namespace cobot_command::cell
