// Which version of this layer it is.
#pragma once

#include <string_view>

namespace cobot_command::capabilities {

/// That of package.xml: "0.1.0".
[[nodiscard]] std::string_view layerVersion();

}  // namespace cobot_command::capabilities
