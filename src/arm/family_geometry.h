// Is this chain an arm of the TM family, and with which lengths?
#pragma once

#include <kdl/chain.hpp>

#include "cobot_command/arm/arm_model.h"

namespace cobot_command::arm {

/// The DH lengths of a chain of six turning joints. Refused when one of its axes, or its flange, is not where
/// the family has it (tolerance 1e-6 m and 1e-6 rad), with the joint and the deviation in the message.
[[nodiscard]] Result<DhLengths, ModelError> lengthsOfFamilyMember(const KDL::Chain& chain);

}  // namespace cobot_command::arm
