// The functions of SRCI that this layer lists: their counterparts here, and whether they are offered. The
// page doc/srci.md, the topic robot_data and the unsupported list of exchange_configuration are made from
// this table or checked against it.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace cobot_command::capabilities {

/// Error of a call to a function that is not offered. SRCI number.
inline constexpr int kNotOffered = 0x8F11;

/// Why a node without an arm model does not offer a function that needs one.
inline constexpr const char* kNoArm =
    "this node has no model of the arm: set ~robot_model or robot_description";

enum class Offer {
  Whole,
  Partly,    ///< except for the limitation in the reason
  NotBuilt,  ///< not implemented; a TM controller could do it
  NoWay      ///< a TM controller does not have it, or does not offer it to a Listen node
};

struct Function {
  std::string_view srci;  ///< "GroupReset"
  /// Interfaces of this layer, by kind and name: "action stop", "topic messages, service read_messages".
  /// Empty: none.
  std::string_view ours;
  Offer offer = Offer::Whole;
  std::string_view reason{};  ///< of Partly and NoWay
  bool needs_arm = false;     ///< it is offered only if the arm model is known
};

/// In the order of doc/srci.md.
[[nodiscard]] const std::vector<Function>& functions();

/// Whether a node offers a function.
struct Support {
  bool offered = false;
  /// Why the function is not offered, or which part is missing; empty: it is offered completely.
  std::string reason;
};
[[nodiscard]] Support supportOf(const Function& function, bool has_arm);

/// Each NoWay, with its reason: "brake test: ...".
[[nodiscard]] std::vector<std::string> beyondTheController();

}  // namespace cobot_command::capabilities
