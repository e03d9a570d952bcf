// Why the network refused something, sorted by who can help.
#pragma once

#include <string>

namespace cobot_command::transport {

struct NetworkError {
  enum class Kind {
    Refused,       ///< the host answers, nobody listens on the port
    Unreachable,   ///< no route, network or host down
    UnknownHost,   ///< the name cannot be resolved
    TimedOut,      ///< no answer in time
    AddressInUse,  ///< another socket listens on this port
    BadAddress,    ///< not an address of this machine
    Other
  };
  Kind kind = Kind::Other;
  std::string message;  ///< the system's own words
};

}  // namespace cobot_command::transport
