// A robot at the other end of a watched core: it reads every frame that the core sends, and answers.
#pragma once

#include <string>
#include <string_view>

#include "fuzz_input.h"
#include "require.h"

#include "cobot_command/protocol/frame_decoder.h"
#include "cobot_command/protocol/message.h"

namespace cobot_command::fuzz {

class RobotPeer {
 public:
  /// What the core sends is always a frame that a controller can read.
  void hear(std::string_view sent) {
    decoder_.feed(sent);
    while (const auto event = decoder_.next()) {
      const auto* const frame = std::get_if<protocol::Frame>(&*event);
      REQUIRE(frame != nullptr);
      const auto message = protocol::parseClientMessage(*frame);
      REQUIRE(message.has_value());
      if (const auto* const script = std::get_if<protocol::ScriptRequest>(&*message)) {
        last_script_ = script->id;
      }
    }
  }

  /// The OK of the script that came last.
  [[nodiscard]] std::string accepted() const {
    return protocol::encode(protocol::ScriptReply{last_script_, true, {}});
  }

  /// An answer that fits, or not.
  [[nodiscard]] std::string answer(FuzzInput& input) const {
    switch (input.choice(6)) {
      case 0:
        return accepted();
      case 1:
        return protocol::encode(protocol::ScriptReply{last_script_, false, {static_cast<int>(input.byte())}});
      case 2:
        return protocol::encode(protocol::ListenNodeState{input.flag(), "Listen1"});
      case 3:
        return protocol::encode(protocol::ListenNodeEntered{"Listen1"});
      case 4:
        return protocol::encode(protocol::TagReport{static_cast<int>(input.choice(16)),
                                                    static_cast<protocol::TagState>(input.choice(3))});
      default:
        return protocol::encodeFrame(input.flag() ? "TMSTA" : "CPERR", input.text());
    }
  }

 private:
  protocol::FrameDecoder decoder_;
  std::string last_script_ = "1";
};

}  // namespace cobot_command::fuzz
