// The elements and attributes of WATERS modules.
#pragma once

namespace cobot_command::automata::wmod {

inline constexpr const char* kNamespace = "http://waters.sourceforge.net/xsd/module";
inline constexpr const char* kAccepting = ":accepting";

}  // namespace cobot_command::automata::wmod
