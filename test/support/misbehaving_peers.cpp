// Peers of the script port, and what the tables have in common. The status port: misbehaving_streams.cpp.

#include "misbehaving_peers.h"

#include <utility>

#include <fmt/format.h>

#include "cobot_command/blocks/shared/error_ids.h"
#include "cobot_command/protocol/frame.h"
#include "cobot_command/protocol/status_items.h"

namespace cobot_command::testing {
namespace {

using namespace blocks;
using protocol::encodeFrame;

constexpr std::size_t kMegabyte = std::size_t{1024} * 1024;

PeerTalk nothing(const protocol::ClientMessage&) {
  return {};
}
std::string reply(const std::string& data) {
  return encodeFrame("TMSCT", data);
}
std::string status(const std::string& data) {
  return encodeFrame("TMSTA", data);
}
std::string times(std::size_t count, const std::string& text) {
  std::string all;
  all.reserve(count * text.size());
  for (std::size_t i = 0; i < count; ++i) all += text;
  return all;
}

constexpr int kNotACobot = connect_error::kNotACobot;
constexpr const char* kForeign = "does not speak the protocol";
constexpr const char* kNobody = "nothing answers";
constexpr const char* kErrorsOnly = "received: CPERR (controller: ";
constexpr const char* kTagOnly = "received: TMSTA (tag 1 complete)";

/// Says this once, and then nothing.
MisbehavingPeer says(std::string name, std::string bytes, std::string words, int error = kNotACobot,
                     bool closes = false) {
  MisbehavingPeer peer;
  peer.name = std::move(name);
  peer.greets = [talk = PeerTalk{std::move(bytes), closes}] { return talk; };
  peer.answers = nothing;
  peer.talks = [](int) { return PeerTalk{}; };
  peer.connect_error = error;
  peer.words = std::move(words);
  return peer;
}
/// Says this with each tick, answers nothing.
MisbehavingPeer repeats(std::string name, std::string bytes, std::string words = kForeign) {
  MisbehavingPeer peer = says(std::move(name), "", std::move(words));
  peer.talks = [talk = PeerTalk{std::move(bytes), false}](int) { return talk; };
  return peer;
}
/// Answers every frame with this.
MisbehavingPeer replies(std::string name, std::string bytes, std::string words, int error = kNotACobot,
                        bool closes = false) {
  MisbehavingPeer peer = says(std::move(name), "", std::move(words), error);
  peer.answers = [talk = PeerTalk{std::move(bytes), closes}](const auto&) { return talk; };
  return peer;
}

std::string frameWith(const std::string& header, const std::string& length, const std::string& data) {
  const std::string inside = fmt::format("{},{},{},", header, length, data);
  return fmt::format("${}*{:02X}\r\n", inside, protocol::checksum(inside));
}

/// Bytes of all kinds, the same in each run.
std::string noise(std::size_t size) {
  std::string bytes;
  std::uint32_t state = 1;
  for (std::size_t i = 0; i < size; ++i) {
    state = state * 1664525 + 1013904223;
    bytes += static_cast<char>(state >> 24U);
  }
  return bytes;
}

void addGarbage(std::vector<MisbehavingPeer>& peers) {
  peers.push_back(says("says nothing", "", kNobody));
  peers.push_back(
      says("closes at once", "", "closed the connection at once", connect_error::kConnection, true));
  peers.push_back(replies("closes at the question", "", "closed the connection at once",
                          connect_error::kConnection, true));
  peers.push_back(says("greets like an SSH server", "SSH-2.0-OpenSSH_8.9\r\n", kForeign));
  peers.push_back(replies("answers like a web server", "HTTP/1.1 400 Bad Request\r\n\r\n",
                          "closed the connection at once", connect_error::kConnection, true));
  peers.push_back(replies("echoes the question", status("00"), kForeign));
  peers.push_back(repeats("noise", noise(1000)));
  peers.push_back(repeats("a flood of zeros", std::string(64 * 1024, '\0')));
  peers.push_back(repeats("a flood of dollars", std::string(64 * 1024, '$')));
  peers.push_back(repeats("a flood of beginnings", times(500, "$A,1,")));
  peers.push_back(repeats("trickles garbage", "x"));
  peers.push_back(repeats("trickles dollars", "$"));
}

void addFrames(std::vector<MisbehavingPeer>& peers) {
  MisbehavingPeer half = repeats("half a frame for ever", "x", kForeign);
  half.greets = [] { return PeerTalk{"$TMSTA,16777216,00,", false}; };
  peers.push_back(half);
  half.name = "half a frame of 16 MB, fast";
  half.talks = [](int tick) { return PeerTalk{tick < 17 ? std::string(kMegabyte, 'x') : "", false}; };
  peers.push_back(half);
  MisbehavingPeer endless = repeats("a header without an end", "TMSTA", kForeign);
  endless.greets = [] { return PeerTalk{"$", false}; };
  peers.push_back(endless);
  endless = repeats("a LENGTH without an end", "1234567890", kForeign);
  endless.greets = [] { return PeerTalk{"$TMSTA,", false}; };
  peers.push_back(endless);
  const std::string data = "00,true,Listen1";
  for (const char* length : {"-15", "abc", "", "99999999999999999999", "16777217", "14", "16"}) {
    peers.push_back(
        replies(fmt::format("LENGTH \"{}\"", length), frameWith("TMSTA", length, data), kForeign));
  }
  const std::string good = status(data);
  peers.push_back(replies("wrong checksums", good.substr(0, good.size() - 4) + "00\r\n", kForeign));
  peers.push_back(replies("checksums that are none", good.substr(0, good.size() - 4) + "ZZ\r\n", kForeign));
  peers.push_back(replies("lines that end without CR", good.substr(0, good.size() - 2) + "\n", kForeign));
  for (const char* header : {"TMXXX", "tmsta", "ABCDEFGHIJKLMNOPQRSTUVWXYZ", "TM-ST", ""}) {
    peers.push_back(replies(fmt::format("header \"{}\"", header), frameWith(header, "15", data), kForeign));
  }
  peers.push_back(repeats("the status port", streamFrame(), "is the status port"));
}

void addStates(std::vector<MisbehavingPeer>& peers) {
  for (const char* data : {"00", "00,", "00,maybe,Listen1", "00,TRUE,Listen1", "0,true", "", ",,,,"}) {
    peers.push_back(replies(fmt::format("TMSTA \"{}\"", data), status(data), kForeign));
  }
  peers.push_back(replies("a tag for an answer", status("01,01,true"), kTagOnly));
  peers.push_back(replies("data of a script for an answer", status("90,hello"),
                          "received: TMSTA (script data on 90: hello)"));
  peers.push_back(replies("a state with the header of scripts", reply("00,true,Listen1"), kForeign));
  peers.push_back(replies("never in a Listen node", status("00,false,"), "not in a Listen node",
                          connect_error::kTimeOut));
  for (const char* code : {"00", "01", "02", "03", "04", "F1"}) {
    peers.push_back(
        replies(fmt::format("CPERR {} to everything", code), encodeFrame("CPERR", code), kErrorsOnly));
  }
  peers.push_back(replies("CPERR of no known code", encodeFrame("CPERR", "77"), kForeign));
  peers.push_back(repeats("a flood of CPERR", times(1000, encodeFrame("CPERR", "04")), kErrorsOnly));
  peers.push_back(repeats("answers before it is asked", status("01,01,true"), kTagOnly));
}

// --- Those that can be connected to.

/// A good controller but for what the caller changes.
MisbehavingPeer strange(std::string name, std::set<int> goal_errors = {}, std::string words = "") {
  MisbehavingPeer peer;
  peer.name = std::move(name);
  peer.greets = goodGreeting;
  peer.answers = goodAnswer;
  peer.talks = [](int) { return PeerTalk{}; };
  peer.goal_errors = std::move(goal_errors);
  peer.words = std::move(words);
  return peer;
}

int tagOf(const std::string& script) {
  const std::string word = "QueueTag(";
  const std::size_t at = script.find(word);
  return at == std::string::npos ? 0 : std::stoi(script.substr(at + word.size()));
}

/// Answers scripts with a text in which {id} and {tag} stand for those of the script; the stop as it should.
MisbehavingPeer toScripts(std::string name, std::string text, std::set<int> goal_errors,
                          std::string words = "", bool closes = false) {
  MisbehavingPeer peer = strange(std::move(name), std::move(goal_errors), std::move(words));
  peer.answers = [text = std::move(text), closes](const protocol::ClientMessage& message) -> PeerTalk {
    const auto* const script = std::get_if<protocol::ScriptRequest>(&message);
    const bool stops = script != nullptr && script->script.find("StopAndClearBuffer") != std::string::npos;
    if (script == nullptr || stops) return goodAnswer(message);
    std::string bytes;
    for (std::size_t begin = 0; begin < text.size();) {  // one frame a line
      const std::size_t end = std::min(text.find('\n', begin), text.size());
      const std::string line = fmt::format(text.substr(begin, end - begin), fmt::arg("id", script->id),
                                           fmt::arg("tag", tagOf(script->script)));
      const std::size_t space = line.find(' ');
      bytes += encodeFrame(line.substr(0, space), line.substr(space + 1));
      begin = end + 1;
    }
    return {bytes, closes};
  };
  return peer;
}

/// Answers scripts well, but reports no tag, and a question for one with this.
MisbehavingPeer toTagQueries(std::string name, std::string frame, std::set<int> goal_errors) {
  MisbehavingPeer peer = toScripts(std::move(name), "TMSCT {id},OK", std::move(goal_errors));
  peer.answers = [for_scripts = peer.answers,
                  frame = std::move(frame)](const protocol::ClientMessage& message) -> PeerTalk {
    const auto* const query = std::get_if<protocol::TagQuery>(&message);
    if (query == nullptr) return for_scripts(message);
    return {frame.empty() ? "" : status(fmt::format(frame, fmt::arg("tag", query->tag))), false};
  };
  return peer;
}

void addReplies(std::vector<MisbehavingPeer>& peers) {
  const int none = motion_error::kReceiveReply;
  const int refused = motion_error::kRejected;
  peers.push_back(toScripts("no answer to scripts", "", {none}, "no reply"));
  for (const char* text : {"TMSCT 77,OK", "TMSCT 0,OK", "TMSCT {id}", "TMSCT {id},", "TMSCT {id},ok",
                           "TMSCT {id},OKAY", "TMSCT {id},OK;99999999999", "TMSCT {id},ERROR;-1",
                           "TMSCT {id},ERROR;;", "TMSTA {id},OK", "TMSCT ,OK", "TMSCT 00{id},OK"}) {
    peers.push_back(toScripts(fmt::format("answers \"{}\"", text), text, {none}, "no reply"));
  }
  peers.push_back(toScripts("an id of 1 MB", "TMSCT " + std::string(kMegabyte, '1') + ",OK", {none}));
  peers.push_back(toScripts("ERROR without a line", "TMSCT {id},ERROR", {refused}, "no line was named"));
  peers.push_back(
      toScripts("ERROR of a line beyond the script", "TMSCT {id},ERROR;99", {refused}, "line 99"));
  peers.push_back(
      toScripts("ERROR of 100,000 lines", "TMSCT {id},ERROR" + times(100000, ";1"), {refused}, "line 1"));
  peers.push_back(toScripts("ERROR, then OK", "TMSCT {id},ERROR;1\nTMSCT {id},OK", {refused}, "line 1"));
  peers.push_back(toScripts("OK twice", "TMSCT {id},OK\nTMSCT {id},OK\nTMSTA 01,{tag},true", {}));
  peers.push_back(toScripts("OK, then ERROR", "TMSCT {id},OK\nTMSCT {id},ERROR;1\nTMSTA 01,{tag},true", {}));
  peers.push_back(toScripts("OK with warnings", "TMSCT {id},OK;1;2\nTMSTA 01,{tag},true", {}));
  peers.push_back(toScripts("CPERR 02", "CPERR 02", {own_error::kCommunication}, "checksum"));
  peers.push_back(toScripts("CPERR 00", "CPERR 00", {own_error::kCommunication}));
  peers.push_back(toScripts("CPERR F1", "CPERR F1", {own_error::kNotListening}));
  peers.push_back(toScripts("CPERR FF", "CPERR FF", {none}));
  peers.push_back(toScripts("closes at the script", "", {motion_error::kLinkDropped}, "", true));
  peers.push_back(toScripts("OK, and closes", "TMSCT {id},OK", {motion_error::kLinkDropped}, "", true));
}

void addTags(std::vector<MisbehavingPeer>& peers) {
  const int failed = motion_error::kMotionFailed;
  peers.push_back(toScripts("the tag before the OK", "TMSTA 01,{tag},true\nTMSCT {id},OK", {}));
  peers.push_back(toScripts("the tag, and no OK", "TMSTA 01,{tag},true", {motion_error::kReceiveReply}));
  peers.push_back(toScripts("the tag ten times", "TMSCT {id},OK" + times(10, "\nTMSTA 01,{tag},true"), {}));
  peers.push_back(toScripts("tag false", "TMSCT {id},OK\nTMSTA 01,{tag},false", {failed}, "false"));
  peers.push_back(
      toScripts("tag true, then false", "TMSCT {id},OK\nTMSTA 01,{tag},true\nTMSTA 01,{tag},false", {}));
  peers.push_back(toScripts("tags that nobody waits for",
                            "TMSCT {id},OK\nTMSTA 01,0,true\nTMSTA 01,16,true\nTMSTA 01,2000000000,true\n"
                            "TMSTA 01,{tag},true",
                            {}));
  const int no_answer = motion_error::kReceiveTag;
  for (const char* answer :
       {"", "01,{tag},TRUE", "01,{tag},1", "01,{tag}", "01,,true", "01,-1,true", "01,16,true"}) {
    peers.push_back(toTagQueries(fmt::format("a tag asked for, \"{}\"", answer), answer, {no_answer}));
  }
  peers.push_back(toTagQueries("a tag asked for, none", "01,{tag},none", {own_error::kTagLost}));
  peers.push_back(toTagQueries("a tag asked for, false for ever", "01,{tag},false", {own_error::kTagLost}));
  peers.push_back(toTagQueries("a tag asked for, true", "01,{tag},true", {}));
}

void addHabits(std::vector<MisbehavingPeer>& peers) {
  const auto talking = [&](std::string name, const std::string& bytes) {
    MisbehavingPeer peer = strange(std::move(name));
    peer.talks = [bytes](int) { return PeerTalk{bytes, false}; };
    peers.push_back(std::move(peer));
  };
  talking("the entry message for ever", times(100, reply("0,Listen1")));
  talking("states that nobody asked for", times(100, status("00,true,Listen1")));
  talking("data of scripts for ever", status("90," + noise(50000)));
  talking("garbage between its frames", "x$y");
  talking("frames of unknown headers", encodeFrame("TMXXX", "1"));
  MisbehavingPeer peer = strange("a Listen node of 1 MB");
  peer.greets = [] { return PeerTalk{reply("0," + std::string(kMegabyte, 'L')), false}; };
  peers.push_back(peer);
  peer = strange("a Listen node of control bytes");
  peer.greets = [] { return PeerTalk{reply("0," + noise(300)), false}; };
  peers.push_back(peer);
  peer = strange("OK for scripts that nobody sent");
  peer.greets = [] {
    std::string early;
    for (int id = 1; id < 50; ++id) early += reply(std::to_string(id) + ",OK");
    return PeerTalk{goodGreeting().bytes + early, false};
  };
  peers.push_back(peer);
  peer = strange("tags that nobody sent");
  peer.greets = [] {
    std::string early;
    for (int tag = 1; tag <= 15; ++tag) early += status(fmt::format("01,{},true", tag));
    return PeerTalk{goodGreeting().bytes + early, false};
  };
  peers.push_back(peer);
  peer =
      strange("no answer but the entry message", {motion_error::kReceiveReply, motion_error::kLinkDropped});
  peer.answers = nothing;
  peers.push_back(peer);
  peer = strange("everything three times");
  peer.answers = [](const auto& message) { return PeerTalk{times(3, goodAnswer(message).bytes), false}; };
  peers.push_back(peer);
}

}  // namespace

PeerTalk goodGreeting() {
  return {reply("0,Listen1"), false};
}

PeerTalk goodAnswer(const protocol::ClientMessage& message) {
  if (const auto* const script = std::get_if<protocol::ScriptRequest>(&message)) {
    const int tag = tagOf(script->script);
    return {reply(script->id + ",OK") + (tag > 0 ? status(fmt::format("01,{:02},true", tag)) : ""), false};
  }
  if (const auto* const query = std::get_if<protocol::TagQuery>(&message)) {
    return {status(fmt::format("01,{:02},none", query->tag)), false};
  }
  return {status("00,true,Listen1"), false};
}

MisbehavingPeer goodController() {
  return strange("a good controller");
}

std::vector<MisbehavingPeer> peersThatCannotBeCommanded() {
  std::vector<MisbehavingPeer> peers;
  addGarbage(peers);
  addFrames(peers);
  addStates(peers);
  return peers;
}

std::vector<MisbehavingPeer> peersThatAnswerStrangely() {
  std::vector<MisbehavingPeer> peers;
  addReplies(peers);
  addTags(peers);
  addHabits(peers);
  return peers;
}

}  // namespace cobot_command::testing
