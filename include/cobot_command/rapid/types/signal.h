// The inputs and outputs of a program, as a signal file configures them.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "cobot_command/rapid/types/type_table.h"

namespace cobot_command::rapid {

enum class SignalType : std::uint8_t { Di, Do, Gi, Go, Ai, Ao };
enum class IoModule : std::uint8_t { ControlBox, EndModule };

struct Signal {
  std::string name;    ///< as in the file
  std::string folded;  ///< in small letters
  SignalType type = SignalType::Di;
  /// It has no wire: topics and tests set it.
  bool is_virtual = false;
  IoModule module = IoModule::ControlBox;
  /// Of a di, do, ai, ao: its number at the module. Of a gi, go: those of its bits, the least one first. Of a
  /// virtual one: a group has as many entries as bits; all others have one.
  std::vector<std::uint32_t> indices;
  bool is_inverted = false;
  double initial = 0;  ///< of a di, do: 0 or 1; of a group: 0..2^bits-1; of an ai, ao [V]
};

/// "di", "do", "gi", "go", "ai", "ao".
[[nodiscard]] std::string_view toString(SignalType type);
/// signaldi, signaldo ...
[[nodiscard]] TypeIndex typeOf(SignalType type);

}  // namespace cobot_command::rapid
