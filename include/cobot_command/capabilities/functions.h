// The functions of SRCI that this layer names: what each is here, and whether it is offered. One table, of
// which the page doc/srci.md, the topic robot_data and the unsupported list of exchange_configuration are
// made or checked.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace cobot_command::capabilities {

/// What a call to a function gets that is not offered. SRCI's number.
inline constexpr int kNotOffered = 0x8F11;

/// Why what needs the model of the arm is not offered by a node without one.
inline constexpr const char* kNoArm =
    "this node knows no model of the arm: set ~robot_model, or give it a robot_description";

enum class Offer {
  Whole,
  Partly,    ///< but for what the reason says
  NotBuilt,  ///< a TM controller could do it
  NoWay      ///< a TM controller does not offer it to a Listen node, or does not have it at all
};

struct Function {
  std::string_view srci;  ///< "GroupReset"
  /// Our interfaces, by kind and name: "action stop", "topic messages, service read_messages". Empty: none.
  std::string_view ours;
  Offer offer = Offer::Whole;
  std::string_view reason{};  ///< of Partly and NoWay
  bool needs_arm = false;     ///< it is offered where the model of the arm is known
};

/// In the order of the page.
[[nodiscard]] const std::vector<Function>& functions();

/// How a node offers a function.
struct Support {
  bool offered = false;
  std::string reason;  ///< why not, or what of it is missing; empty: it is offered whole
};
[[nodiscard]] Support supportOf(const Function& function, bool has_arm);

/// Each NoWay, with its reason: "brake test: ...".
[[nodiscard]] std::vector<std::string> beyondTheController();

}  // namespace cobot_command::capabilities
