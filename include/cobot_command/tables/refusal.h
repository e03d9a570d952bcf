// Why an entry of the tables is refused.
#pragma once

#include <string>

#include "cobot_command/tables/entries.h"

namespace cobot_command::tables {

/// Error numbers of SRCI. It numbers frames before tools, also for the in-use errors.
namespace table_error {
inline constexpr int kFrameIndex = 0x8D08;
inline constexpr int kLoadIndex = 0x8D17;
inline constexpr int kToolIndex = 0x8D35;
inline constexpr int kReferenceRefers = 0x8C12;  ///< the reference itself refers to another frame
inline constexpr int kReferenceInvalid = 0x8C13;
inline constexpr int kFrameInUse = 0x8C15;
inline constexpr int kToolInUse = 0x8C16;
inline constexpr int kLoadInUse = 0x8C17;
inline constexpr int kMass = 0x8D49;
// Errors without an SRCI number; the same numbers as own_error of the blocks.
inline constexpr int kNotFinite = 0x200;
inline constexpr int kCoordinateRange = 0x213;
inline constexpr int kInertiaRange = 0x21D;
inline constexpr int kNameInvalid = 0x21F;
inline constexpr int kShutDown = 0x230;
// Only of this layer; no block has it.
inline constexpr int kNotKept = 0x232;  ///< the file of the tables cannot be written
}  // namespace table_error

struct Refusal {
  int error_id = 0;
  Kind kind = Kind::Tool;
  int index = 0;
  std::string found;
  std::string allowed;
  std::string remedy;
};

/// "tool 16: the number is 16; allowed: 1 to 15. Give the number of ..."
[[nodiscard]] std::string describe(const Refusal& refusal);

}  // namespace cobot_command::tables
