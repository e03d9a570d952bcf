// How much a slow peer may cost.
#pragma once

#include <cstddef>

namespace cobot_command::transport {

/// A peer that has left this many bytes unread when the next message is sent is dropped, beyond what the
/// system itself buffers [bytes]. What is kept for one peer is thus at most this and one message.
inline constexpr std::size_t kSendLimit = std::size_t{1024} * 1024;

}  // namespace cobot_command::transport
