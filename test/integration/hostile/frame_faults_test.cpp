// What each fault of the proxy makes of a frame, without a proxy.
#include "frame_faults.h"

#include "fault_line.h"
#include "frame_cutter.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cobot_command/protocol/frame_decoder.h"
#include "cobot_command/protocol/message.h"

namespace cobot_command::testing {
namespace {

using namespace std::chrono_literals;
using protocol::encodeFrame;
using protocol::Frame;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::SizeIs;

const Frame kReply{"TMSCT", "4,OK"};
const Frame kTag{"TMSTA", "01,03,true"};
const Frame kState{"TMSTA", "00,true,Listen1"};
const Frame kScript{"TMSCT", "4,Pause()"};

std::string bytesOf(const Frame& frame) {
  return encodeFrame(frame.header, frame.data);
}

Fault fault(FaultKind kind, Direction direction = Direction::ToClient) {
  Fault made;
  made.kind = kind;
  made.direction = direction;
  return made;
}

std::vector<std::string> bytesOf(const std::vector<Step>& steps) {
  std::vector<std::string> bytes;
  bytes.reserve(steps.size());
  for (const Step& step : steps) bytes.push_back(step.bytes);
  return bytes;
}

/// What becomes of a frame with this fault alone.
std::vector<Step> struck(const Fault& fault, const Frame& frame) {
  FrameFaults faults(1);
  faults.add(fault);
  auto steps = faults.pass(fault.direction, frame);
  EXPECT_EQ(faults.strikes(), 1u);
  return steps;
}

TEST(FrameFaults, passEverythingUntilThereIsOne) {
  FrameFaults faults(1);
  EXPECT_THAT(bytesOf(faults.pass(Direction::ToClient, kReply)), ElementsAre(bytesOf(kReply)));
  faults.add(fault(FaultKind::Drop));
  EXPECT_THAT(faults.pass(Direction::ToClient, kReply), SizeIs(0));
  EXPECT_THAT(bytesOf(faults.pass(Direction::ToController, kScript)), ElementsAre(bytesOf(kScript)));
  faults.clear();
  EXPECT_THAT(bytesOf(faults.pass(Direction::ToClient, kReply)), ElementsAre(bytesOf(kReply)));
}

TEST(FrameFaults, strikeTheFramesThatTheyAreMeantFor) {
  FrameFaults faults(1);
  Fault drop = fault(FaultKind::Drop);
  drop.which = Which::Tag;
  drop.first = 1;
  drop.count = 2;
  faults.add(drop);
  EXPECT_THAT(faults.pass(Direction::ToClient, kTag), SizeIs(1));
  EXPECT_THAT(faults.pass(Direction::ToClient, kState), SizeIs(1));
  EXPECT_THAT(faults.pass(Direction::ToClient, kTag), SizeIs(0));
  EXPECT_THAT(faults.pass(Direction::ToClient, kReply), SizeIs(1));
  EXPECT_THAT(faults.pass(Direction::ToClient, kTag), SizeIs(0));
  EXPECT_THAT(faults.pass(Direction::ToClient, kTag), SizeIs(1));
  EXPECT_EQ(faults.strikes(), 2u);
}

TEST(FrameFaults, tellScriptsTagsAndNodeStatesApart) {
  const Frame entered{"TMSCT", "0,Listen1"};
  const std::pair<Which, Frame> meant[] = {
      {Which::Script, kReply}, {Which::Tag, kTag}, {Which::NodeState, kState}};
  for (const auto& [which, frame] : meant) {
    FrameFaults faults(1);
    Fault drop = fault(FaultKind::Drop);
    drop.which = which;
    faults.add(drop);
    for (const Frame& other : {kReply, kTag, kState, entered}) {
      EXPECT_EQ(faults.pass(Direction::ToClient, other).empty(), other == frame) << other.data;
    }
  }
}

TEST(FrameFaults, repeatAndReorder) {
  EXPECT_THAT(bytesOf(struck(fault(FaultKind::Duplicate), kTag)), ElementsAre(bytesOf(kTag), bytesOf(kTag)));
  Fault echo = fault(FaultKind::Echo);
  echo.time = 200ms;
  const auto echoed = struck(echo, kTag);
  ASSERT_THAT(echoed, SizeIs(2));
  EXPECT_EQ(echoed[1].kind, Step::Kind::SendOvertaken);
  EXPECT_EQ(echoed[1].wait, 200ms);
  FrameFaults faults(1);
  faults.add(fault(FaultKind::Swap));
  EXPECT_THAT(faults.pass(Direction::ToClient, kReply), SizeIs(0));
  EXPECT_THAT(bytesOf(faults.pass(Direction::ToClient, kTag)), ElementsAre(bytesOf(kTag), bytesOf(kReply)));
}

TEST(FrameFaults, delayWithinTheirJitterAndTheSameForTheSameSeed) {
  Fault delay = fault(FaultKind::Delay);
  delay.time = 500ms;
  delay.jitter = 400ms;
  const auto waits = [&](unsigned seed) {
    FrameFaults faults(seed);
    faults.add(delay);
    std::vector<Duration> all;
    all.reserve(50);
    for (int i = 0; i < 50; ++i) all.push_back(faults.pass(Direction::ToClient, kTag).at(0).wait);
    return all;
  };
  for (const Duration wait : waits(7)) {
    EXPECT_GE(wait, 100ms);
    EXPECT_LE(wait, 901ms);
  }
  EXPECT_EQ(waits(7), waits(7));
  EXPECT_NE(waits(7), waits(8));
}

TEST(FrameFaults, cutFramesIntoPiecesThatAreTheFrame) {
  Fault trickle = fault(FaultKind::ByteByByte);
  trickle.rate = 10;
  std::string whole;
  for (const Step& step : struck(trickle, kTag)) {
    EXPECT_EQ(step.bytes.size(), 1u);
    EXPECT_EQ(step.wait, 100ms);
    whole += step.bytes;
  }
  EXPECT_EQ(whole, bytesOf(kTag));
  Fault cut = fault(FaultKind::Cut);
  cut.time = 2s;
  const auto parts = struck(cut, kTag);
  ASSERT_THAT(parts, SizeIs(2));
  EXPECT_FALSE(parts[0].bytes.empty());
  EXPECT_EQ(parts[0].bytes + parts[1].bytes, bytesOf(kTag));
  EXPECT_EQ(parts[1].wait, 2s);
}

/// What a decoder makes of it.
std::vector<std::string> decoded(const std::vector<Step>& steps) {
  protocol::FrameDecoder decoder;
  for (const Step& step : steps) decoder.feed(step.bytes);
  decoder.finish();
  std::vector<std::string> events;
  while (const auto event = decoder.next()) {
    const auto* const bad = std::get_if<protocol::DecodeFault>(&*event);
    events.emplace_back(bad != nullptr ? toString(bad->kind) : std::get<Frame>(*event).data);
  }
  return events;
}

TEST(FrameFaults, spoilFramesInOneWayOnly) {
  EXPECT_THAT(decoded(struck(fault(FaultKind::WrongChecksum), kTag)), ElementsAre("checksum"));
  EXPECT_THAT(decoded(struck(fault(FaultKind::WrongChecksumThenGood), kTag)),
              ElementsAre("checksum", kTag.data));
  EXPECT_THAT(decoded(struck(fault(FaultKind::Garbage), kTag)), ElementsAre("garbage", kTag.data));
  for (const char* length : {"-5", "abc", "99999999999999999999", "16777217"}) {
    Fault bad = fault(FaultKind::BadLength);
    bad.text = length;
    EXPECT_THAT(decoded(struck(bad, kTag)), ElementsAre("length")) << length;
  }
}

TEST(FrameFaults, answerInTheNameOfTheController) {
  EXPECT_THAT(bytesOf(struck(fault(FaultKind::OtherId), kReply)),
              ElementsAre(encodeFrame("TMSCT", "4000,OK")));
  Fault complaint = fault(FaultKind::Cperr);
  complaint.text = "04";
  EXPECT_THAT(bytesOf(struck(complaint, kReply)), ElementsAre(encodeFrame("CPERR", "04")));
  const auto first = struck(fault(FaultKind::AnswerFirst, Direction::ToController), kScript);
  EXPECT_THAT(bytesOf(first), ElementsAre(bytesOf(kReply), bytesOf(kScript)));
  EXPECT_EQ(first[0].direction, Direction::ToClient);
  EXPECT_EQ(first[1].direction, Direction::ToController);
  EXPECT_THAT(bytesOf(struck(fault(FaultKind::AnswerAhead, Direction::ToController), kScript)),
              ElementsAre(encodeFrame("TMSCT", "5,OK"), bytesOf(kScript)));
}

TEST(FaultLine, saysAllThatAFaultIs) {
  const auto order = parseFaultLine(
      "status delay direction=to_controller which=tag first=2 count=3 time=0.5 jitter=0.25 rate=10 text=F1");
  ASSERT_TRUE(order.has_value()) << order.error();
  EXPECT_EQ(order->port, FaultProxy::Port::Status);
  const Fault& read = order->fault;
  EXPECT_EQ(read.kind, FaultKind::Delay);
  EXPECT_EQ(read.direction, Direction::ToController);
  EXPECT_EQ(read.which, Which::Tag);
  EXPECT_EQ(std::pair(read.first, read.count), std::pair(std::size_t{2}, std::size_t{3}));
  EXPECT_EQ(std::pair(read.time, read.jitter), std::pair(Duration(500ms), Duration(250ms)));
  EXPECT_EQ(read.rate, 10);
  EXPECT_EQ(read.text, "F1");
}

TEST(FaultLine, namesWhatIsWrong) {
  const std::pair<const char*, const char*> lines[] = {{"", "port"},
                                                       {"tcp drop", "tcp"},
                                                       {"script", "unknown fault"},
                                                       {"script x", "\"x\""},
                                                       {"script drop time=-1", "time"},
                                                       {"script drop time=nan", "time"},
                                                       {"script drop which=", "which"},
                                                       {"script drop up", "up"}};
  for (const auto& [line, words] : lines) {
    const auto order = parseFaultLine(line);
    ASSERT_FALSE(order.has_value()) << line;
    EXPECT_THAT(order.error(), HasSubstr(words));
  }
}

/// What a cutter makes of a stream; frames in brackets.
std::vector<std::string> cut(std::string_view stream, std::size_t piece) {
  FrameCutter cutter;
  std::vector<std::string> pieces;
  for (std::size_t at = 0; at < stream.size(); at += piece) {
    cutter.feed(stream.substr(at, piece));
    while (const auto next = cutter.next()) {
      const auto* const raw = std::get_if<std::string>(&*next);
      pieces.push_back(raw != nullptr ? *raw : '[' + std::get<Frame>(*next).data + ']');
    }
  }
  return pieces;
}

TEST(FrameCutter, findsTheFramesHoweverTheyArrive) {
  const std::string stream = bytesOf(kReply) + bytesOf(Frame{"TMSVR", "0,1,$TMSCT,4,1,OK,*00\r\n"});
  for (std::size_t piece = 1; piece <= stream.size(); ++piece) {
    EXPECT_THAT(cut(stream, piece), ElementsAre("[4,OK]", "[0,1,$TMSCT,4,1,OK,*00\r\n]")) << piece;
  }
}

TEST(FrameCutter, letsThroughWhatIsNoFrame) {
  for (const char* stream :
       {"SSH-2.0", "$$$", "$TMSCT,-5,4,OK,*00\r\n", "$TMSCT,4,4,OK.*00\r\n", "$TMSCT,4,4,OK,*00\n.",
        "$ABCDEFGHIJKLMNOPQRSTUVWXYZ", "$TMSCT,99999999999999999999,"}) {
    std::string all;
    for (const std::string& piece : cut(std::string(stream) + "\r\n", 3)) all += piece;
    EXPECT_EQ(all, std::string(stream) + "\r\n");
  }
  EXPECT_THAT(cut("$TMSCT,4,4,O" + bytesOf(kTag) + "x", 100), ::testing::Contains("[" + kTag.data + "]"))
      << "a frame that breaks off";
}

TEST(FrameFaults, ofConnectionsStrikeNoFrame) {
  FrameFaults faults(1);
  faults.add(fault(FaultKind::NeverRead, Direction::ToController));
  EXPECT_TRUE(faults.has(FaultKind::NeverRead));
  EXPECT_TRUE(faults.neverReads(Direction::ToController));
  EXPECT_FALSE(faults.neverReads(Direction::ToClient));
  EXPECT_THAT(faults.pass(Direction::ToController, kScript), SizeIs(1));
  EXPECT_EQ(faults.strikes(), 0u);
}

}  // namespace
}  // namespace cobot_command::testing
