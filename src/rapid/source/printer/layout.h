// Where the lines of the canonical form begin, and how far they are indented.
#pragma once

#include <cstdint>
#include <vector>

#include "cobot_command/rapid/source/source.h"

namespace cobot_command::rapid {

struct LineStart {
  enum class Kind : std::uint8_t {
    Plain,
    Closing,  ///< ends what is before it, or is indented less: comments before it are one level deeper
    Routine,  ///< one blank line before it, and before the comments directly above it
  };

  TokenIndex token = kNoToken;  ///< the first one of the line
  int level = 0;                ///< of indentation
  Kind kind = Kind::Plain;
};

/// A token whose blanks depend on its place in the tree.
struct MarkedToken {
  enum class Mark : std::uint8_t {
    Procedure,       ///< the name in a call: what follows is an argument, not an operand
    OpeningPercent,  ///< of `%"name"%`
    ClosingPercent,
  };

  TokenIndex token = kNoToken;
  Mark mark = Mark::Procedure;
};

struct Layout {
  std::vector<LineStart> lines;     ///< in the order of their tokens; the last one is End
  std::vector<MarkedToken> marked;  ///< in the order of their tokens
};

/// Precondition: the source is not broken.
[[nodiscard]] Layout layoutOf(const Source& source);

}  // namespace cobot_command::rapid
