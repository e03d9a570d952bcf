// How names are spelled in the canonical form: as in their declaration.
#pragma once

#include <string_view>
#include <vector>

#include "cobot_command/rapid/source/predefined_names.h"
#include "cobot_command/rapid/source/source.h"

namespace cobot_command::rapid {

struct Spelling {
  TokenIndex token = kNoToken;
  std::string_view text;
};

/// The names that are written differently from their declaration, in the order of their tokens. A name that
/// neither the source nor `predefined` declares stays as it is.
[[nodiscard]] std::vector<Spelling> spellingsOf(const Source& source, const PredefinedNames& predefined);

}  // namespace cobot_command::rapid
