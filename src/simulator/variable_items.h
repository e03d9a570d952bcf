// Values of variables as those of items, and back.
#pragma once

#include "cobot_command/language/value.h"
#include "cobot_command/protocol/item_content.h"

namespace cobot_command::simulator {

[[nodiscard]] protocol::ItemValue toItem(const language::Value& value);
[[nodiscard]] language::Value toLanguage(const protocol::ItemValue& value);

}  // namespace cobot_command::simulator
