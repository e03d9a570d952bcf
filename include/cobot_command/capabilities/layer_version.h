// The version of this layer.
#pragma once

#include <string_view>

namespace cobot_command::capabilities {

/// From package.xml: "0.1.0".
[[nodiscard]] std::string_view layerVersion();

}  // namespace cobot_command::capabilities
