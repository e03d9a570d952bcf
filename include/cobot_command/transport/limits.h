// Limits the memory that a slow peer can use.
#pragma once

#include <cstddef>

namespace cobot_command::transport {

/// A peer that has left more than this many bytes unread when the next message is sent is disconnected
/// [bytes]. Bytes in the buffers of the operating system are not counted. So at most this and one message are
/// stored for one peer.
///
/// The largest backlog of a healthy peer are the two PVTs of a running path, with 5,000 points of up to 150
/// bytes each. Half a megabyte remains for the messages after them: a stop must get through.
inline constexpr std::size_t kSendLimit = std::size_t{2} * 1024 * 1024;

}  // namespace cobot_command::transport
