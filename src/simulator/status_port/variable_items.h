// Values of variables as those of items, and back.
#pragma once

#include "cobot_command/protocol/item_content.h"
#include "cobot_command/tm_script/value.h"

namespace cobot_command::simulator {

[[nodiscard]] protocol::ItemValue toItem(const tm_script::Value& value);
[[nodiscard]] tm_script::Value toLanguage(const protocol::ItemValue& value);

}  // namespace cobot_command::simulator
