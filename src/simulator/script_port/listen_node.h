// The script port: who is connected, what they ask, where the project's flow is, which scripts run.
//
// Checks of a frame in the order length, checksum, header, data, mode (TM 1.6).
#pragma once

#include <optional>
#include <string_view>

#include "queue/motion_queue.h"
#include "script_port/node_flow.h"
#include "script_port/script_clients.h"
#include "script_port/script_scheduler.h"
#include "script_port/tag_table.h"

#include "cobot_command/protocol/message.h"
#include "cobot_command/simulator/settings.h"

namespace cobot_command::simulator {

class ListenNode {
 public:
  ListenNode(const Settings& settings, const ScriptedRobot& robot, FaultSwitches& faults, Outgoing& outgoing,
             Outbox& outbox);

  // --- The wire.
  void connected(ClientId client, Instant now);
  void disconnected(ClientId client) { clients_.disconnect(client); }
  void feed(ClientId client, std::string_view bytes) { clients_.feed(client, bytes); }
  /// Takes the client's next frame; false when there is none.
  bool handleNext(ClientId client, Instant now);
  void closeConnections() { clients_.closeAll(); }
  /// Opens or closes the port as the project and the faults want it now.
  void updatePort();

  // --- The project.
  void run(Instant now) { on(FlowEvent::Run, now); }
  /// Closes the port and its clients, forgets all scripts and tags.
  void stop(Instant now) { on(FlowEvent::Stop, now); }
  /// The operator lets the flow go elsewhere, once the queued motions are done, and back.
  void leaveForGood(Instant now);
  void comeBack(Instant now);
  [[nodiscard]] bool projectRuns() const { return flow_ != FlowState::Stopped; }
  [[nodiscard]] bool listening() const { return flow_ == FlowState::Listening; }

  // --- Time.
  /// Runs scripts, leaves and enters the node, as far as it goes at `now`; false when nothing was to be done.
  bool step(Instant now);
  [[nodiscard]] Instant nextEvent() const;

  // --- What the queue tells.
  void on(const TagSettled& settled);
  void on(const TagDropped& dropped) { tags_.forget(dropped.tag); }
  /// Nothing moves after an error but what is sent after it: the script that runs ends, the waiting ones are
  /// dropped.
  void abandonScripts();

 private:
  void handle(ClientId client, const protocol::DecodeFault& fault);
  void handle(ClientId client, const protocol::Frame& frame, Instant now);
  void answer(ClientId client, const protocol::ScriptRequest& request, Instant now);
  void answer(ClientId client, const protocol::ListenNodeQuery& query, Instant now);
  void answer(ClientId client, const protocol::TagQuery& query, Instant now);
  void refuseFrame(ClientId client, protocol::CommunicationErrorCode code);
  void spoil(PendingScript& script);
  bool runPriorityCommand(const PendingScript& script, Instant now);
  void exit(Instant now);
  void stopAndClear(int mode, Instant now);
  void on(FlowEvent event, Instant now);
  void enter(Instant now);
  void leave(Instant now);
  [[nodiscard]] Instant timeout() const;

  const Settings& settings_;
  MotionQueue& queue_;
  FaultSwitches& faults_;
  Outbox& outbox_;
  ScriptClients clients_;
  TagTable tags_;
  ScriptScheduler scheduler_;
  FlowState flow_ = FlowState::Stopped;
  bool port_open_ = false;
  std::optional<Duration> reentry_delay_;  // from the next leaving
  std::optional<Instant> reenter_at_;
  Instant entered_at_{};
  std::optional<Instant> heard_at_;  // the last frame; before one the first connection, or the entry
};

}  // namespace cobot_command::simulator
