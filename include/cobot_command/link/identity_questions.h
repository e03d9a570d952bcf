// What is asked on the status port, once a connection: of the identity of the controller what its stream does
// not tell. Items of a TM controller can be read also when nobody has ticked them for the stream (TM 3).
#pragma once

#include <vector>

#include "cobot_command/link/controller_identity.h"
#include "cobot_command/protocol/status_items.h"

namespace cobot_command::link {

class IdentityQuestions {
 public:
  /// The requests for what `told` lacks, an item each: one that a controller does not have makes no other
  /// fail.
  [[nodiscard]] static std::vector<protocol::StatusFrame> missingIn(const ControllerIdentity& told);

  /// True: it is the answer to such a request, or says why there is none, and is taken.
  bool take(const protocol::StatusFrame& frame);
  /// Fills in what was answered and `told` lacks.
  void complete(ControllerIdentity& told) const;

 private:
  ControllerIdentity answered_;
};

}  // namespace cobot_command::link
