// From the system's error codes to ours.
#pragma once

#include <boost/system/error_code.hpp>

#include "cobot_command/transport/network_error.h"

namespace cobot_command::transport {

[[nodiscard]] NetworkError toNetworkError(const boost::system::error_code& code);

}  // namespace cobot_command::transport
