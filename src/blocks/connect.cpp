#include "cobot_command/blocks/connect.h"

#include <fmt/format.h>

#include "cobot_command/blocks/shared/error_ids.h"
#include "cobot_command/common/foreign_text.h"
#include "cobot_command/common/host_name.h"

namespace cobot_command::blocks {
namespace {

constexpr double kMinTimeout = 10;
constexpr double kMaxTimeout = 300;

}  // namespace

ErrorTable ConnectGoal::errors() {
  return ErrorTable()
      .row(connect_error::kTimeoutRange, "Timeout range: 10~300 seconds", kSetInRange,
           "timeout is below 10 s, above 300 s, or not a number")
      .row(connect_error::kConnection, "Connection Error",
           "Run the project in TMflow; check the address and the wiring",
           "until the timeout no TCP connection could be made or kept: refused (no project is running), "
           "unknown "
           "host, unreachable, no answer, or closed again at once")
      .row(connect_error::kTimeOut, "TimeOut Error",
           "Let the flow of the TMflow project enter its Listen node",
           "until the timeout the controller answered, but its flow was not in a Listen node")
      .row(connect_error::kClearBuffer, "Clear Buffer Error", kCheckWiring, kNoSuchStep)
      .row(connect_error::kGetStatus, "Get TCP Status Error", kCheckWiring,
           "cannot occur any more: the socket reports its state by events, it is not queried")
      .row(connect_error::kSend, "TCP Send Error", kCheckWiring,
           "cannot occur any more: a failed send closes the connection, see 16#20 and 16#90")
      .row(connect_error::kReceive, "TCP Receive Error", kCheckWiring,
           "cannot occur any more: bytes are read as they arrive; a device that sends none is 16#70")
      .row(connect_error::kNotACobot, "Target device is not a Cobot",
           "Check address and port: the script port of a controller is 5890",
           "until the timeout the device accepted connections, but sent nothing, only errors, or data that "
           "are not the protocol of a script port; or it is the status port")
      .row(connect_error::kGetStatusAgain, "Get TCP Status Error", kCheckWiring,
           "cannot occur any more: see 16#40")
      .row(connect_error::kDisconnected, "Socket disconnected", kCheckWiring,
           "an established link was closed by the peer, or its heartbeats were not answered")
      .row(connect_error::kClose, "TCP Close Error", kCheckWiring,
           "cannot occur any more: closing cannot fail in a way that leaves the connection open")
      .shared({own_error::kShutDown})
      .row(own_error::kHostInvalid, "Host name or address invalid",
           "Give the name or the IP address of the controller",
           "host is empty, longer than 255 characters, or has blanks, control or non-ASCII characters")
      .row(own_error::kPortRange, "Port range: 1~65535", kSetInRange,
           "port is 0, on which nothing can listen, negative, or above 65535; or status_port is negative or "
           "above 65535")
      .row(own_error::kConnectBusy, "Connect is under execution",
           "Cancel the running connect, or use the connection that it made",
           "another connect goal is Busy, a command is running on the existing link, or the robot of another "
           "controller may still move by commands sent to it earlier");
}

GoalTraits traitsOf(const ConnectGoal& /*goal*/) {
  GoalTraits traits;
  traits.way = Way::Link;
  return traits;
}

std::vector<Failure> check(const ConnectGoal& goal) {
  std::vector<Failure> failures;
  if (!(goal.timeout >= kMinTimeout && goal.timeout <= kMaxTimeout)) {
    failures.push_back({connect_error::kTimeoutRange, fmt::format("timeout is {} s", goal.timeout), ""});
  }
  if (!isHostName(goal.host)) {
    failures.push_back(
        {own_error::kHostInvalid,
         fmt::format("host is '{}' ({} characters)", foreignText(goal.host, kQuoteLimit), goal.host.size()),
         ""});
  }
  if (goal.port < 1 || goal.port > 65535) {
    failures.push_back({own_error::kPortRange, fmt::format("port is {}", goal.port), ""});
  }
  if (goal.status_port && (*goal.status_port < 0 || *goal.status_port > 65535)) {
    failures.push_back(
        {own_error::kPortRange, fmt::format("status_port is {}; 0 means none", *goal.status_port), ""});
  }
  return failures;
}

}  // namespace cobot_command::blocks
