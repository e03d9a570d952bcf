#include "catalogue_tables.h"

#include "cobot_command/blocks/error_ids.h"

namespace cobot_command::blocks {

std::vector<ErrorEntry> connectErrors() {
  constexpr Block kBlock = Block::Connect;
  constexpr const char* kWiring = "Check Ethernet connection wiring";
  constexpr const char* kRange = "Set parameter in acceptable range";
  constexpr const char* kNoStep = "cannot occur any more: there is no such step, bytes are read as they come";
  return {
      {kBlock, connect_error::kTimeoutRange, "Timeout range: 10~300 seconds", kRange,
       "timeout is below 10 s, above 300 s, or not a number"},
      {kBlock, connect_error::kConnection, "Connection Error", "Use CBT_Connect FB for connection",
       "until the timeout no TCP connection could be made or kept: refused (no project is running), unknown "
       "host, unreachable, no answer, or closed again at once"},
      {kBlock, connect_error::kTimeOut, "TimeOut Error", "Cobot is not in Listen Node",
       "until the timeout the controller answered, but its flow was in no Listen node"},
      {kBlock, connect_error::kClearBuffer, "Clear Buffer Error", kWiring, kNoStep},
      {kBlock, connect_error::kGetStatus, "Get TCP Status Error", kWiring,
       "cannot occur any more: the state of the socket is told by its events, it is not asked for"},
      {kBlock, connect_error::kSend, "TCP Send Error", kWiring,
       "cannot occur any more: a failed send closes the connection, see 16#20 and 16#90"},
      {kBlock, connect_error::kReceive, "TCP Receive Error", kWiring,
       "cannot occur any more: bytes are read as they come; a device that sends none is 16#70"},
      {kBlock, connect_error::kNotACobot, "Target device is not a Cobot", "Cobot is not in Listen Node",
       "until the timeout the device accepted connections and answered nothing, or something that is not the "
       "protocol of a script port; or it is the status port"},
      {kBlock, connect_error::kGetStatusAgain, "Get TCP Status Error", kWiring,
       "cannot occur any more: see 16#40"},
      {kBlock, connect_error::kDisconnected, "Socket disconnected", kWiring,
       "an established link was closed by the peer, or its lifesigns were not answered"},
      {kBlock, connect_error::kClose, "TCP Close Error", kWiring,
       "cannot occur any more: closing cannot fail in a way that leaves the connection open"},
      {kBlock, own_error::kShutDown, "Command layer is shutting down", "Start the command layer again",
       "the goal came after the command layer was told to shut down"},
      {kBlock, own_error::kHostInvalid, "Host name or address invalid",
       "Give the name or the IP address of the controller",
       "host is empty, longer than 255 characters, or has blanks, control or non-ASCII characters"},
      {kBlock, own_error::kPortRange, "Port range: 1~65535", kRange,
       "port is 0, on which nothing can listen, negative, or above 65535; or status_port is negative or "
       "above 65535"},
      {kBlock, own_error::kConnectBusy, "Connect is under execution",
       "Cancel the running connect, or use the connection that it made", "another connect goal is Busy"},
  };
}

}  // namespace cobot_command::blocks
