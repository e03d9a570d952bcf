// Requests on the status port, once for each connection, for identity items that the stream does not contain.
// Items of a TM controller can be read even if they are not selected for the stream (TM 3).
#pragma once

#include <vector>

#include "cobot_command/link/controller_identity.h"
#include "cobot_command/protocol/status_items.h"

namespace cobot_command::link {

class IdentityQuestions {
 public:
  /// The requests for the items missing in `told`. Each request has one item, so that an item that a
  /// controller does not have makes no other request fail.
  [[nodiscard]] static std::vector<protocol::StatusFrame> missingIn(const ControllerIdentity& told);

  /// True: the frame is the answer to such a request, or the reason why there is none; it is consumed.
  bool take(const protocol::StatusFrame& frame);
  /// Fills in the answered items that `told` lacks.
  void complete(ControllerIdentity& told) const;

 private:
  ControllerIdentity answered_;
};

}  // namespace cobot_command::link
