// The Ethernet Slave on the status port: a periodic frame for everybody, and answers to requests.
//
// The stream ticks at fixed times since the start; a tick that nobody listens to costs nothing. Requests and
// their answers are in the log, the stream is not.
#pragma once

#include <map>
#include <string_view>
#include <utility>
#include <vector>

#include "status_port/item_table.h"
#include "wire/outgoing.h"

#include "cobot_command/protocol/frame_decoder.h"
#include "cobot_command/protocol/status_items.h"

namespace cobot_command::simulator {

class StatusServer {
 public:
  StatusServer(const Settings& settings, const tm_script::Variables& variables, Instant start,
               Outgoing& outgoing, Outbox& outbox);

  /// The address decides whether the client may write.
  void connected(ClientId client, std::string_view address, Instant now);
  void disconnected(ClientId client);
  void closeAll();
  void feed(ClientId client, std::string_view bytes);
  /// Answers the next request of the client that is complete. False: there is none.
  bool answerNext(ClientId client, const ItemSource& source);
  /// What the answered requests have written, in order. To be done before the next answer.
  [[nodiscard]] std::vector<ItemWrite> takeWrites() { return std::exchange(writes_, {}); }

  /// The next tick; Instant::max() without clients.
  [[nodiscard]] Instant nextEvent() const;
  /// The tick at nextEvent(): one frame to every client, ids 0 to 9 in turn.
  void stream(const ItemSource& source);

 private:
  struct Client {
    protocol::FrameDecoder decoder;
    bool may_write = false;
  };
  void answer(ClientId id, const Client& client, const protocol::Frame& frame, const ItemSource& source);
  void refuseFrame(ClientId client, protocol::CommunicationErrorCode code);
  [[nodiscard]] protocol::StatusFrame answerTo(const protocol::StatusFrame& request, bool may_write,
                                               const ItemSource& source);
  [[nodiscard]] protocol::StatusFrame read(const protocol::StatusFrame& request, protocol::ItemFormat format,
                                           const ItemSource& source) const;
  [[nodiscard]] protocol::StatusFrame write(const protocol::StatusFrame& request, protocol::ItemFormat format,
                                            const ItemSource& source);
  [[nodiscard]] protocol::StatusFrame refuseContent(const protocol::StatusFrame& request,
                                                    const protocol::MessageFault& fault) const;

  Duration period_;
  Instant start_;
  protocol::ItemFormat format_;
  std::optional<std::set<std::string, std::less<>>> writers_;
  ItemTable table_;
  Outgoing& outgoing_;
  Outbox& outbox_;
  std::map<ClientId, Client> clients_;
  std::vector<ItemWrite> writes_;
  Duration::rep next_tick_ = 1;
};

}  // namespace cobot_command::simulator
