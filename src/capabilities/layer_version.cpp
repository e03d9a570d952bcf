#include "cobot_command/capabilities/layer_version.h"

namespace cobot_command::capabilities {

std::string_view layerVersion() {
  return COBOT_LAYER_VERSION;
}

}  // namespace cobot_command::capabilities
