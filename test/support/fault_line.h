// A fault as people write it, for tm_fault_proxy.
#pragma once

#include <string>
#include <string_view>

#include "fault_proxy.h"

#include "cobot_command/common/result.h"

namespace cobot_command::testing {

struct FaultOrder {
  FaultProxy::Port port = FaultProxy::Port::Script;
  Fault fault;
};

/// "PORT KIND [NAME=VALUE]...": `script reset direction=to_controller which=tag first=2 count=1`. Names are
/// direction, which, first, count, time [s], jitter [s], rate [1/s] and text. Refused with a sentence: found,
/// allowed.
[[nodiscard]] Result<FaultOrder, std::string> parseFaultLine(std::string_view line);

/// One line each: the kind and what it does.
[[nodiscard]] std::string knownFaultKinds();

}  // namespace cobot_command::testing
