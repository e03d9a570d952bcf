// Peers of the status port.

#include <limits>
#include <utility>

#include "misbehaving_peers.h"
#include "whole_stream.h"
#include <fmt/format.h>

#include "cobot_command/blocks/shared/error_ids.h"
#include "cobot_command/protocol/status_items.h"

namespace cobot_command::testing {
namespace {

using protocol::StatusItem;
namespace item = protocol::item;

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInf = std::numeric_limits<float>::infinity();

void set(std::vector<StatusItem>& items, StatusItem other) {
  for (StatusItem& known : items) {
    if (known.name == other.name) {
      known = std::move(other);
      return;
    }
  }
  items.push_back(std::move(other));
}

std::vector<StatusItem> standing(const std::vector<float>& joints_deg) {
  auto items = wholeStream();
  set(items, item::ofFloats("Joint_Angle", joints_deg));
  return items;
}

std::string frameOf(const std::vector<StatusItem>& items, int mode = 1) {
  return encode(protocol::StatusFrame{"0", mode, protocol::encodeBinaryItems(items)});
}
std::string frameWith(StatusItem other) {
  auto items = wholeStream();
  set(items, std::move(other));
  return frameOf(items);
}
std::string frameOfContent(int mode, std::string content) {
  return encode(protocol::StatusFrame{"0", mode, std::move(content)});
}

/// Sends this every 20 ms. Motions are Done all the same, as the stream is none, or what it says is enough.
MisbehavingPeer streams(std::string name, std::string bytes, std::string words,
                        std::set<int> goal_errors = {}) {
  MisbehavingPeer peer;
  peer.name = std::move(name);
  peer.port = link::Channel::Status;
  peer.greets = [] { return PeerTalk{}; };
  peer.answers = [](const protocol::ClientMessage&) { return PeerTalk{}; };
  peer.talks = [bytes = std::move(bytes)](int tick) { return PeerTalk{tick % 2 == 0 ? bytes : "", false}; };
  peer.words = std::move(words);
  peer.goal_errors = std::move(goal_errors);
  return peer;
}

constexpr const char* kNoStream = "not the status stream of a TM robot";

void addNoStreams(std::vector<MisbehavingPeer>& peers) {
  peers.push_back(streams("says nothing", "", "sends nothing"));
  MisbehavingPeer closing = streams("closes at once", "", "closed");
  closing.greets = [] { return PeerTalk{"", true}; };
  peers.push_back(closing);
  peers.push_back(streams("noise", std::string(5000, '\x7f') + "$a$$,", kNoStream));
  peers.push_back(streams("a flood of zeros", std::string(64 * 1024, '\0'), kNoStream));
  peers.push_back(streams("trickles", "x", kNoStream));
  peers.push_back(streams("the script port", goodGreeting().bytes, "is the script port"));
  const std::string good = streamFrame();
  peers.push_back(streams("wrong checksums", good.substr(0, good.size() - 4) + "ZZ\r\n", kNoStream));
  MisbehavingPeer half = streams("half a frame for ever", "x", kNoStream);
  half.greets = [] { return PeerTalk{"$TMSVR,16777216,0,1,", false}; };
  peers.push_back(half);
  peers.push_back(streams("a header of its own", protocol::encodeFrame("TMXXX", "0,1,"), kNoStream));
}

void addFormats(std::vector<MisbehavingPeer>& peers) {
  peers.push_back(streams("STRING", frameOfContent(2, "{Robot_Link}={true}"), "STRING"));
  peers.push_back(streams("JSON", frameOfContent(3, R"([{"Item":"Robot_Link","Value":true}])"), "JSON"));
  peers.push_back(streams(
      "1 MB of JSON", frameOfContent(3, R"([{"Item":")" + std::string(1024 * 1024, 'x') + R"(","Value":1}])"),
      "JSON"));
  peers.push_back(streams("a mode that nobody knows", frameOfContent(77, ""), "mode 77"));
  peers.push_back(streams("replies to nobody", frameOfContent(0, "00,OK"), "mode 0"));
  for (const char* data : {"", "0", "0,1", ",1,", "0,-1,", "0,one,", "$,1,"}) {
    peers.push_back(
        streams(fmt::format("a frame of \"{}\"", data), protocol::encodeFrame("TMSVR", data), kNoStream));
  }
}

void addItems(std::vector<MisbehavingPeer>& peers) {
  constexpr const char* kUnreadable = "cannot be read";
  peers.push_back(streams("one byte of items", frameOfContent(1, "x"), kUnreadable));
  peers.push_back(streams("an item longer than the frame",
                          frameOfContent(1, "\xff\xff" + std::string(9, 'a')), kUnreadable));
  peers.push_back(
      streams("a value that breaks off", frameOfContent(1, std::string("\x01\0a\x05\0b", 6)), kUnreadable));
  peers.push_back(streams("no items", frameOf({}), "does not have Robot_Error"));
  peers.push_back(
      streams("names without letters", frameOfContent(1, std::string("\0\0\x01\0x", 5)), kUnreadable));
  peers.push_back(streams("a name of 65535 bytes", frameWith({std::string(65535, 'n'), "x"}), ""));
  peers.push_back(streams("10,000 items",
                          frameOf(std::vector<StatusItem>(10000, item::ofBool("ESTOP", false))),
                          "does not have Robot_Error"));
  peers.push_back(
      streams("NaN joints", frameWith(item::ofFloats("Joint_Angle", {0, kNan, 0, 0, 0, 0})), "Joint_Angle"));
  peers.push_back(streams("infinite speeds", frameWith(item::ofFloats("Joint_Speed", {0, 0, 0, 0, 0, -kInf})),
                          "Joint_Speed"));
  peers.push_back(
      streams("five joints", frameWith(item::ofFloats("Joint_Angle", {0, 0, 90, 0, 90})), "Joint_Angle"));
  peers.push_back(streams("joints in 3 bytes", frameWith({"Joint_Angle", "abc"}), "Joint_Angle"));
  peers.push_back(streams("a bool of 4 bytes", frameWith(item::ofInt("ESTOP", 0)), "ESTOP"));
  peers.push_back(
      streams("an NaN pose", frameWith(item::ofFloats("TCP_Value", {0, 0, 0, 0, 0, kNan})), "TCP_Value"));
  peers.push_back(streams("a base of control bytes",
                          frameWith(item::ofString("Base_Name", std::string("\0\x1b\xff", 3))), ""));
  MisbehavingPeer often = streams("10,000 frames a second", "", "");
  often.talks = [frame = streamFrame()](int) {
    std::string frames;
    for (int i = 0; i < 100; ++i) frames += frame;
    return PeerTalk{frames, false};
  };
  peers.push_back(often);
}

/// What the stream says keeps the motion from being sent, or ends it.
void addRobotsThatCannotMove(std::vector<MisbehavingPeer>& peers) {
  using namespace blocks;
  auto error = wholeStream();
  set(error, item::ofBool("Robot_Error", true));
  set(error, item::ofInt("Error_Code", 0x1405A));
  peers.push_back(streams("an error", frameOf(error), "", {own_error::kRobotError}));
  error.push_back(item::ofString("Error_Content", std::string(60000, 'E')));
  peers.push_back(streams("an error of 60 kB", frameOf(error), "", {own_error::kRobotError}));
  peers.push_back(
      streams("an emergency stop", frameWith(item::ofBool("ESTOP", true)), "", {own_error::kEmergencyStop}));
}

}  // namespace

std::string streamFrame(const std::vector<float>& joints_deg) {
  return frameOf(standing(joints_deg));
}

MisbehavingPeer goodStream() {
  return streams("a good stream", streamFrame(), "");
}

std::vector<MisbehavingPeer> peersOfTheStatusPort() {
  std::vector<MisbehavingPeer> peers;
  addNoStreams(peers);
  addFormats(peers);
  addItems(peers);
  addRobotsThatCannotMove(peers);
  return peers;
}

}  // namespace cobot_command::testing
