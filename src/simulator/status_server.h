// The Ethernet Slave on the status port: a periodic BINARY frame for everybody, and answers to requests.
//
// The stream ticks at fixed times since the start; a tick that nobody listens to costs nothing. Requests and
// their answers are in the log, the stream is not.
#pragma once

#include <map>
#include <string_view>

#include "item_table.h"
#include "outgoing.h"

#include "cobot_command/protocol/frame_decoder.h"
#include "cobot_command/protocol/status_items.h"

namespace cobot_command::simulator {

class StatusServer {
 public:
  StatusServer(Duration period, Instant start, Outgoing& outgoing, Outbox& outbox);

  void connected(ClientId client, Instant now);
  void disconnected(ClientId client);
  void closeAll();
  /// Answers every request that is complete now.
  void received(ClientId client, std::string_view bytes, const ItemSource& source);

  /// The next tick; Instant::max() without clients.
  [[nodiscard]] Instant nextEvent() const;
  /// The tick at nextEvent(): one frame to every client, ids 0 to 9 in turn.
  void stream(const ItemSource& source);

 private:
  void answer(ClientId client, const protocol::Frame& frame, const ItemSource& source);
  void refuseFrame(ClientId client, protocol::CommunicationErrorCode code);
  [[nodiscard]] static protocol::StatusFrame answerTo(const protocol::StatusFrame& request,
                                                      const ItemSource& source);
  [[nodiscard]] static protocol::StatusFrame read(const protocol::StatusFrame& request,
                                                  const ItemSource& source);

  Duration period_;
  Instant start_;
  Outgoing& outgoing_;
  Outbox& outbox_;
  std::map<ClientId, protocol::FrameDecoder> decoders_;
  Duration::rep next_tick_ = 1;
};

}  // namespace cobot_command::simulator
