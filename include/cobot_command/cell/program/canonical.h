// What a cell means, as bytes: by their hash a stage knows that its input is what it was made of (M5).
#pragma once

#include <string>

#include "cobot_command/cell/program/cell.h"

namespace cobot_command::cell {

/// Every value of the cell, the URDFs of its models by their hashes, and the version of this format; nothing
/// of how its file is written: comments, order of keys, notation of numbers and poses, aliases, lines. The
/// same on every locale. Names for people are in it, as artifacts and reports show them.
///
/// Numbers are exact, but those of rotations and directions, which are rounded to 1e-12: sines differ in
/// their last digits from machine to machine.
[[nodiscard]] std::string canonicalText(const Cell& cell);

/// SHA-256 of the canonical text, 64 hexadecimal digits.
[[nodiscard]] std::string hashOf(const Cell& cell);

}  // namespace cobot_command::cell
