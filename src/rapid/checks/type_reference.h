// Names of types, and types of declared data.
#pragma once

#include "draft.h"
#include "names.h"

namespace cobot_command::rapid {

/// The type of a TypeName; kNoType and a finding (E310, E502) if it is none.
TypeIndex typeNamed(FileDraft& file, Names& names, NodeIndex type_name);

/// The type of Data, without its dimensions; kNoType and a finding (E313, E314) if data cannot have it.
TypeIndex typeOfData(FileDraft& file, Names& names, NodeIndex data);
/// The type of a Parameter, without its dimensions. Reports E314, and E412 of a parameter without values that
/// is not VAR.
TypeIndex typeOfParameter(FileDraft& file, Names& names, NodeIndex parameter);

/// signaldi, signaldo ...: the signal file has the data of these types.
[[nodiscard]] bool isSignalType(const Type& type);

/// E502 of a symbol that is Refused or NotBuilt.
void reportRefused(FileDraft& file, TokenIndex name, const Symbol& symbol);

}  // namespace cobot_command::rapid
