// Reals that a script gives as literals, where a double is wanted: no float stands between the text and the
// double. So 417.123 is a target at 417.123 mm, and not at the float next to it.
#pragma once

#include <string>

#include "cobot_command/common/result.h"
#include "cobot_command/tm_script/script.h"
#include "cobot_command/tm_script/value.h"

namespace cobot_command::tm_script {

/// convert() of the value of an expression.
[[nodiscard]] Result<Value, std::string> convertAsWritten(const Expression& source, const Value& value,
                                                          Type to);

}  // namespace cobot_command::tm_script
