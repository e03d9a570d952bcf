// What each program has without declaring it: the types, data and routines of the RAPID runtime.
//
// They are declarations in RAPID itself (src/rapid/types/*.rapid), built into the programs.
#pragma once

#include <string_view>
#include <vector>

#include "cobot_command/rapid/source/predefined_names.h"
#include "cobot_command/rapid/source/source.h"

namespace cobot_command::rapid {

/// Types and data; read once, on the first call.
[[nodiscard]] const Source& predefinedData();
/// Routines, declared without bodies; read once, on the first call.
[[nodiscard]] const Source& catalogue();

/// A name of the language that this package knows and refuses (E502).
struct Refusal {
  std::string_view name;
  std::string_view reason;
  std::string_view way_around;
};
/// Routines and types, of the lines `! == known (reason; way around): NAME NAME` of both modules.
[[nodiscard]] const std::vector<Refusal>& refusals();
/// True for a routine of the catalogue that is declared in a tier after the first one: it does not run yet.
[[nodiscard]] bool isNotBuilt(NodeIndex routine);
/// True for a predefined name, in small letters, that dialect s4c does not have.
[[nodiscard]] bool isOfIrc5Alone(std::string_view folded);

/// All of these.
[[nodiscard]] const PredefinedNames& predefinedNames();

}  // namespace cobot_command::rapid
