// How much a slow peer may cost.
#pragma once

#include <cstddef>

namespace cobot_command::transport {

/// A peer that has left this many bytes unread when the next message is sent is dropped, beyond what the
/// system itself buffers [bytes]. What is kept for one peer is thus at most this and one message.
///
/// The largest that waits for a peer who is well are the two PVTs that a path has under way, of 5,000 points
/// with up to 150 bytes each. They leave half a megabyte for what follows them: a stop must get through.
inline constexpr std::size_t kSendLimit = std::size_t{2} * 1024 * 1024;

}  // namespace cobot_command::transport
