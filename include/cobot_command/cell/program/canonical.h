// The meaning of a cell as bytes. Stages compare its hash to ensure that their input belongs to this cell
// (doc/cell.md).
#pragma once

#include <string>

#include "cobot_command/cell/program/cell.h"

namespace cobot_command::cell {

/// Every value of the cell, the hashes of the URDFs of its models, and the version of this format.
/// Independent of the notation of the file: comments, order of keys, notation of numbers and poses, aliases,
/// lines. The same in every locale. Display names are included, because artifacts and reports show them.
///
/// Numbers are exact, except those of rotations and directions, which are rounded to 1e-12, because sines
/// differ in their last digits between machines.
[[nodiscard]] std::string canonicalText(const Cell& cell);

/// SHA-256 of the canonical text, 64 hexadecimal digits.
[[nodiscard]] std::string hashOf(const Cell& cell);

}  // namespace cobot_command::cell
