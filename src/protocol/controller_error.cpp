#include "cobot_command/protocol/controller_error.h"

#include <algorithm>
#include <iterator>

namespace cobot_command::protocol {
namespace {

struct Meaning {
  int code;
  std::string_view words;
};

constexpr Meaning kMeanings[] = {
    {0x01, "outside the working range"},
    {0x05, "stop command"},
    {0x11, "no posture for a point of the blend"},
    {0x12, "no posture for a point of the path"},
    {0x13, "error in a PTP motion"},
    {0x14, "points of the path too far apart"},
    {0x15, "error in a circle"},
    {0x18, "no inverse of the Jacobian"},
    {0x21, "speed over its range"},
    {0x22, "force or torque over its range"},
    {0x3D, "emergency stop before the initialisation"},
    {0x62, "near a singularity, moved by hand"},
    {0x90, "error in a process line"},
    {0x14058, "no posture for the target"},
    {0x1405A, "a joint outside its range"},
    {0x14064, "singular"},
    {0x14089, "wrist singularity"},
    {0x140B1, "a joint outside +/-180 degrees"},
    {0x4500A, "error of the TCP listener"},
};

}  // namespace

std::string_view meaningOfError(int code) {
  const auto* found = std::find_if(std::begin(kMeanings), std::end(kMeanings),
                                   [&](const Meaning& meaning) { return meaning.code == code; });
  return found == std::end(kMeanings) ? std::string_view() : found->words;
}

}  // namespace cobot_command::protocol
