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
/// Routines of the language that this package knows and refuses (E502): the lines `! == known` of the
/// catalogue.
[[nodiscard]] const std::vector<std::string_view>& refusedNames();

/// All of these.
[[nodiscard]] const PredefinedNames& predefinedNames();

}  // namespace cobot_command::rapid
