// Network errors, sorted by who can fix them.
#pragma once

#include <string>

namespace cobot_command::transport {

struct NetworkError {
  enum class Kind {
    Refused,       ///< the host answers, no program listens on the port
    Unreachable,   ///< no route, network or host down
    UnknownHost,   ///< the name cannot be resolved
    TimedOut,      ///< no answer in time
    AddressInUse,  ///< another socket uses this port
    BadAddress,    ///< not an address of this machine
    Other
  };
  Kind kind = Kind::Other;
  std::string message;  ///< text of the operating system
};

}  // namespace cobot_command::transport
