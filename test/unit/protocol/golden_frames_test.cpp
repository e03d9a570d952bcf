#include "golden_frames.h"

#include <algorithm>
#include <cctype>

#include "decode_events.h"
#include "reference_decoder.h"
#include "test_names.h"
#include <gmock/gmock.h>

#include "cobot_command/common/foreign_text.h"
#include "cobot_command/protocol/message.h"
#include "cobot_command/protocol/status_items.h"

namespace cobot_command::protocol {
namespace {

using ::testing::ElementsAre;
using ::testing::SizeIs;

class Golden : public ::testing::TestWithParam<GoldenFrame> {
 protected:
  [[nodiscard]] std::string data() const {
    const std::string& bytes = GetParam().bytes;
    const std::size_t begin = bytes.find(',', bytes.find(',') + 1) + 1;
    return bytes.substr(begin, bytes.rfind(",*") - begin);
  }
};

std::string name(const ::testing::TestParamInfo<GoldenFrame>& info) {
  return testName(info.index, info.param.header + ' ' + info.param.meaning);
}

std::vector<GoldenFrame> validOnes() {
  std::vector<GoldenFrame> frames = goldenFrames();
  frames.erase(
      std::remove_if(frames.begin(), frames.end(), [](const GoldenFrame& frame) { return !frame.valid; }),
      frames.end());
  return frames;
}

class ValidGolden : public Golden {};

INSTANTIATE_TEST_SUITE_P(Frame, Golden, ::testing::ValuesIn(goldenFrames()), name);
INSTANTIATE_TEST_SUITE_P(Frame, ValidGolden, ::testing::ValuesIn(validOnes()), name);

TEST(GoldenFrames, areAllHere) {
  EXPECT_THAT(goldenFrames(), SizeIs(79));
}

TEST_P(Golden, isDecodedOrRefusedAsItsFieldsSay) {
  const GoldenFrame& golden = GetParam();
  if (!golden.length_valid) {
    EXPECT_THAT(decode(golden.bytes), ElementsAre("length"));
  } else if (!golden.checksum_valid) {
    EXPECT_THAT(decode(golden.bytes), ElementsAre("checksum"));
  } else {
    EXPECT_TRUE(golden.valid);
    EXPECT_THAT(decode(golden.bytes), ElementsAre(golden.header + ':' + data()));
  }
}

TEST_P(ValidGolden, isEncodedToTheSameBytes) {
  const GoldenFrame& golden = GetParam();
  std::string expected = golden.bytes;
  for (std::size_t i = expected.size() - 4; i < expected.size(); ++i) {
    expected[i] = static_cast<char>(std::toupper(static_cast<unsigned char>(expected[i])));
  }
  EXPECT_EQ(encodeFrame(golden.header, data()), expected);
}

TEST_P(ValidGolden, hasTheMeaningThatItsDirectionSays) {
  const GoldenFrame& golden = GetParam();
  const Frame frame{golden.header, data()};
  const bool refused = golden.meaning.find("framing only") == 0 ||
                       golden.meaning.find("unknown TMSTA") == 0 || golden.header == "TMsct" ||
                       golden.header == "TMsvr";
  if (golden.header == header::kItems || golden.header == "TMsvr") {
    EXPECT_EQ(parseStatusFrame(frame).has_value(), !refused);
  } else if (golden.from_robot) {
    EXPECT_EQ(parseControllerMessage(frame).has_value(), !refused);
  } else {
    EXPECT_EQ(parseClientMessage(frame).has_value(), !refused);
  }
  EXPECT_FALSE(describe(frame).empty());
}

TEST(GoldenFrames, waitAtEveryPrefix) {
  for (const GoldenFrame& golden : goldenFrames()) {
    for (std::size_t size = 0; size < golden.bytes.size(); ++size) {
      const auto prefix = std::string_view(golden.bytes).substr(0, size);
      ASSERT_EQ(decode(prefix), reference::decode(prefix)) << escaped(prefix);
    }
  }
}

TEST(GoldenFrames, areTheSameInAnyTwoPieces) {
  for (const GoldenFrame& golden : goldenFrames()) {
    const std::string& bytes = golden.bytes;
    for (std::size_t first = 1; first < bytes.size(); ++first) {
      ASSERT_EQ(decodeInPieces(bytes, first, bytes.size()), reference::decode(bytes))
          << escaped(bytes) << first;
    }
  }
}

TEST(GoldenFrames, areTheSameByteByByte) {
  for (const GoldenFrame& golden : goldenFrames()) {
    ASSERT_EQ(decodeInPieces(golden.bytes, 1, 1), reference::decode(golden.bytes)) << escaped(golden.bytes);
  }
}

TEST(GoldenFrames, areAsTheReferenceSaysAfterEverySingleByteChange) {
  const std::string next = "$TMSCT,5,10,OK,*6D\r\n";
  for (const GoldenFrame& golden : goldenFrames()) {
    std::string bytes = golden.bytes + next;
    for (std::size_t at = 0; at < golden.bytes.size(); ++at) {
      for (int value = 0; value < 256; ++value) {
        bytes[at] = static_cast<char>(value);
        ASSERT_EQ(decode(bytes), reference::decode(bytes)) << escaped(bytes);
      }
      bytes[at] = golden.bytes[at];
    }
  }
}

TEST(GoldenFrames, areAsTheReferenceSaysInEveryPair) {
  const std::vector<GoldenFrame> frames = goldenFrames();
  for (const GoldenFrame& first : frames) {
    for (const GoldenFrame& second : frames) {
      const std::string bytes = first.bytes + second.bytes;
      ASSERT_EQ(decode(bytes), reference::decode(bytes)) << escaped(bytes);
      ASSERT_EQ(decodeInPieces(bytes, 1, 1), reference::decode(bytes)) << escaped(bytes);
    }
  }
}

/// The frames that we computed ourselves, TM 1.7, apart from those that are golden as well.
class ComputedFrame : public ::testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(
    Frame, ComputedFrame,
    ::testing::Values(
        "$TMSCT,41,1,PTP(\"JPP\",0,0,90,0,90,0,35,200,0,false),*0F\r\n",
        "$TMSCT,73,2,PTP(\"CPP\",417.50,-122.30,343.90,180.00,0.00,90.00,10,200,0,false,0,2,4),*0C\r\n",
        "$TMSCT,70,3,Line(\"CAR\",417.50,-122.30,343.90,180.00,0.00,90.00,100,200,50,false),*78\r\n",
        "$TMSCT,116,4,Circle(\"CAP\",417.50,-122.30,343.90,180.00,0.00,90.00,381.70,208.74,343.90,180.00,0."
        "00,135.00,"
        "100,200,50,270,false),*4E\r\n",
        "$TMSCT,65,5,PLine(\"CAP\",417.50,-122.30,343.90,180.00,0.00,90.00,100,200,50),*79\r\n",
        "$TMSCT,46,6,Move_PTP(\"TPP\",0,0,10,45,0,0,10,200,0,false),*78\r\n",
        "$TMSCT,48,7,Move_Line(\"TAP\",0,0,10,45,0,0,125,200,0,false),*2B\r\n",
        "$TMSCT,43,8,Move_PLine(\"CAP\",0,0,10,45,0,0,125,200,0),*39\r\n",
        "$TMSCT,29,9,ChangeBase(20,30,10,0,0,90),*58\r\n",
        "$TMSCT,54,10,ChangeTCP(0,0,150,0,0,90,2,2,0.5,0.5,0,0,-80,0,0,0),*39\r\n",
        "$TMSCT,18,11,ChangeLoad(5.3),*7D\r\n", "$TMSCT,16,12,QueueTag(1,1),*77\r\n",
        "$TMSCT,23,13,WaitQueueTag(1,5000),*6F\r\n", "$TMSCT,23,14,StopAndClearBuffer(),*52\r\n",
        "$TMSCT,10,15,Pause(),*0B\r\n", "$TMSCT,11,16,Resume(),*62\r\n", "$TMSCT,15,17,ScriptExit(),*51\r\n",
        "$TMSCT,27,18,IO[\"ControlBox\"].DO[2]=1,*5E\r\n",
        "$TMSCT,66,19,PVTEnter(0)\r\nPVTPoint(0,0,90,0,90,0,0,0,0,0,0,0,2.0)\r\nPVTExit(),*3E\r\n",
        "$TMSCT,48,20,ListenSend(90,GetString(Robot[0].CoordRobot)),*4D\r\n", "$TMSTA,11,01,01,false,*0E\r\n",
        "$TMSTA,5,01,01,*6A\r\n", "$TMSTA,9,00,false,,*37\r\n", "$CPERR,2,00,*48\r\n",
        "$TMSCT,9,1,ERROR;1,*07\r\n", "$TMSCT,6,1,OK;1,*54\r\n"),
    kTextAsName);

TEST_P(ComputedFrame, isDecodedAndEncodedToTheSameBytes) {
  FrameDecoder decoder;
  decoder.feed(GetParam());
  const auto event = decoder.next();
  ASSERT_TRUE(event && std::holds_alternative<Frame>(*event));
  const auto& frame = std::get<Frame>(*event);
  EXPECT_EQ(encodeFrame(frame.header, frame.data), GetParam());
  EXPECT_EQ(decoder.pending(), 0u);
}

}  // namespace
}  // namespace cobot_command::protocol
