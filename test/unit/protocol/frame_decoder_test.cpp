#include "cobot_command/protocol/frame_decoder.h"

#include <vector>

#include "decode_events.h"
#include "test_names.h"
#include <gmock/gmock.h>

namespace cobot_command::protocol {
namespace {

using Kind = DecodeFault::Kind;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

const std::string kGood = "$TMSCT,5,10,OK,*6D\r\n";

DecodeFault onlyFault(std::string_view bytes) {
  FrameDecoder decoder;
  decoder.feed(bytes);
  const auto event = decoder.next();
  const auto* fault = event ? std::get_if<DecodeFault>(&*event) : nullptr;
  return fault == nullptr ? DecodeFault{Kind::Garbage, "no fault", ""} : *fault;
}

TEST(FrameDecoder, givesNothingForNoBytes) {
  EXPECT_THAT(decode(""), IsEmpty());
}

TEST(FrameDecoder, decodesOneFrame) {
  EXPECT_THAT(decode(kGood), ElementsAre("TMSCT:10,OK"));
}

TEST(FrameDecoder, decodesFramesThatArriveTogether) {
  EXPECT_THAT(decode(kGood + "$TMSTA,2,00,*41\r\n" + kGood),
              ElementsAre("TMSCT:10,OK", "TMSTA:00", "TMSCT:10,OK"));
}

TEST(FrameDecoder, decodesAFrameThatArrivesByteByByte) {
  FrameDecoder decoder;
  for (std::size_t i = 0; i + 1 < kGood.size(); ++i) {
    decoder.feed(kGood.substr(i, 1));
    EXPECT_FALSE(decoder.next());
    EXPECT_EQ(decoder.pending(), i + 1);
  }
  decoder.feed("\n");
  EXPECT_THAT(drain(decoder), ElementsAre("TMSCT:10,OK"));
  EXPECT_EQ(decoder.pending(), 0u);
}

TEST(FrameDecoder, cutsDataByLengthWhateverItHolds) {
  const std::string data = "90,$TMSCT,5,10,OK,*6D\r\n,*00\r\n$";
  EXPECT_THAT(decode(encodeFrame("TMSTA", data)), ElementsAre("TMSTA:" + data));
}

TEST(FrameDecoder, handsOutTheLastFrameAsItCame) {
  const std::string own_way = "$TMSCT,0x4,1,OK,*14\r\n";
  FrameDecoder decoder;
  EXPECT_EQ(decoder.lastFrame(), "");
  decoder.feed("noise" + own_way.substr(0, 5));
  EXPECT_TRUE(std::holds_alternative<DecodeFault>(decoder.next().value()));
  EXPECT_EQ(decoder.lastFrame(), "");
  decoder.feed(own_way.substr(5) + own_way);
  for (int i = 0; i < 2; ++i) {
    ASSERT_TRUE(std::holds_alternative<Frame>(decoder.next().value()));
    EXPECT_EQ(decoder.lastFrame(), own_way);
  }
  EXPECT_FALSE(decoder.next());
  decoder.feed("$");
  EXPECT_EQ(decoder.lastFrame(), "");
}

TEST(FrameDecoder, acceptsEmptyData) {
  EXPECT_THAT(decode("$TMSTA,0,,*43\r\n"), ElementsAre("TMSTA:"));
}

TEST(FrameDecoder, acceptsALowerCaseChecksum) {
  EXPECT_THAT(decode("$TMSCT,5,10,OK,*6d\r\n"), ElementsAre("TMSCT:10,OK"));
}

class FrameDecoderLength : public ::testing::TestWithParam<const char*> {
 protected:
  static std::string frame(std::string_view data) {
    const std::string body = std::string("TMSCT,") + GetParam() + "," + std::string(data) + ",";
    char sum[8];
    std::snprintf(sum, sizeof(sum), "*%02X\r\n", static_cast<unsigned>(checksum(body)));
    return "$" + body + sum;
  }
};

class ReadableLength : public FrameDecoderLength {};
INSTANTIATE_TEST_SUITE_P(FrameDecoder, ReadableLength,
                         ::testing::Values("5", "05", "0x5", "0x05", "0b101",
                                           "0b00000000000000000000000000000101"),
                         kTextAsName);

TEST_P(ReadableLength, isUnderstood) {
  EXPECT_THAT(decode(frame("10,OK") + kGood), ElementsAre("TMSCT:10,OK", "TMSCT:10,OK"));
}

class BadLength : public FrameDecoderLength {};
INSTANTIATE_TEST_SUITE_P(FrameDecoder, BadLength,
                         ::testing::Values("", "-5", "+5", " 5", "5 ", "five", "5.0", "4", "0", "0x", "0b",
                                           "0b5", "0xg", "5x", "16777217", "2147483647", "4294967301",
                                           "18446744073709551621", "99999999999999999999", "0x7fffffff",
                                           "00000000000000000000000000000000000000000000000000000005"),
                         kTextAsName);

TEST_P(BadLength, isOneLengthFaultAtOnce) {
  EXPECT_THAT(decode(frame("10,OK")), ElementsAre("length"));
}

TEST_P(BadLength, doesNotHarmTheNextFrame) {
  EXPECT_THAT(decode(frame("10,OK") + kGood), ElementsAre("length", "TMSCT:10,OK"));
}

TEST(FrameDecoder, refusesAHugeLengthBeforeItsEnd) {
  EXPECT_THAT(decode("$TMSCT,999999999"), ElementsAre("length"));
}

TEST(FrameDecoder, acceptsTheLargestData) {
  const std::string data(kMaxDataLength, 'x');
  FrameDecoder decoder;
  decoder.feed(encodeFrame("TMSCT", data));
  const auto event = decoder.next();
  ASSERT_TRUE(event && std::holds_alternative<Frame>(*event));
  EXPECT_TRUE(std::get<Frame>(*event).data == data);
}

TEST(FrameDecoder, dropsAFrameOfWrongChecksumWhole) {
  // The data holds a frame: it must not come to life because the frame around it was damaged.
  std::string outer = encodeFrame("TMSTA", "90," + kGood);
  outer[outer.size() - 3] ^= 1;
  EXPECT_THAT(decode(outer + kGood), ElementsAre("checksum", "TMSCT:10,OK"));
}

TEST(FrameDecoder, callsAChecksumThatIsNotHexadecimalAChecksumFault) {
  EXPECT_THAT(decode("$TMSCT,5,10,OK,*G1\r\n" + kGood), ElementsAre("checksum", "TMSCT:10,OK"));
}

TEST(FrameDecoder, checksLengthThenChecksumThenHeader) {
  EXPECT_THAT(decode("$TM_CT,4,10,OK,*00\r\n"), ElementsAre("length"));
  EXPECT_THAT(decode("$TM_CT,5,10,OK,*00\r\n"), ElementsAre("checksum"));
  EXPECT_THAT(decode("$TM_CT,5,10,OK,*61\r\n"), ElementsAre("header"));
  EXPECT_THAT(decode("$,5,10,OK,*30\r\n"), ElementsAre("header"));
}

TEST(FrameDecoder, passesAnUnknownHeaderOn) {
  EXPECT_THAT(decode(encodeFrame("TMsct", "1,")), ElementsAre("TMsct:1,"));
}

TEST(FrameDecoder, refusesAHeaderThatDoesNotEnd) {
  EXPECT_THAT(decode("$ABCDEFGHIJKLMNOP"), IsEmpty());
  EXPECT_THAT(decode("$ABCDEFGHIJKLMNOPQ"), ElementsAre("header"));
  EXPECT_THAT(decode("$TMSCT\r\n" + kGood), ElementsAre("header", "TMSCT:10,OK"));
  EXPECT_THAT(decode("$TM" + kGood), ElementsAre("header", "TMSCT:10,OK"));
}

TEST(FrameDecoder, waitsForTheEndOfTheLine) {
  FrameDecoder decoder;
  decoder.feed("$TMSCT,5,10,OK,*6D");
  EXPECT_THAT(drain(decoder), IsEmpty());
  decoder.feed("\r");
  EXPECT_THAT(drain(decoder), IsEmpty());
  decoder.feed("\n");
  EXPECT_THAT(drain(decoder), ElementsAre("TMSCT:10,OK"));
}

TEST(FrameDecoder, callsOtherBytesInPlaceOfTheEndOfTheLineALengthFault) {
  EXPECT_THAT(decode("$TMSCT,5,10,OK,*6D" + kGood), ElementsAre("length", "TMSCT:10,OK"));
  EXPECT_THAT(decode("$TMSCT,5,10,OK,*6D\n" + kGood), ElementsAre("length", "TMSCT:10,OK"));
  EXPECT_THAT(decode("$TMSCT,5,10,OK,*6\r\n" + kGood), ElementsAre("length", "TMSCT:10,OK"));
}

TEST(FrameDecoder, reportsGarbageOnceAndGoesOn) {
  EXPECT_THAT(decode("noise" + kGood + "\r\n\r\n" + kGood),
              ElementsAre("garbage", "TMSCT:10,OK", "garbage", "TMSCT:10,OK"));
}

TEST(FrameDecoder, reportsGarbageInPiecesOnce) {
  FrameDecoder decoder;
  std::vector<std::string> events;
  for (const char byte : std::string(1000, 'x') + "$ 5 and $$" + kGood.substr(1)) {
    decoder.feed(std::string_view(&byte, 1));
    for (const auto& event : drain(decoder)) events.push_back(event);
    ASSERT_LE(decoder.pending(), kMaxReportedBytes);
  }
  EXPECT_THAT(events, ElementsAre("garbage", "TMSCT:10,OK"));
}

TEST(FrameDecoder, reportsEndlessGarbageAndStoresNoneOfIt) {
  FrameDecoder decoder;
  std::vector<std::string> events;
  for (int i = 0; i < 1000; ++i) {
    decoder.feed(std::string(10000, 'x'));
    for (const auto& event : drain(decoder)) events.push_back(event);
    ASSERT_EQ(decoder.pending(), 0u);
  }
  EXPECT_THAT(events, ElementsAre("garbage"));
}

TEST(FrameDecoder, passesOverADollarThatStartsNoFrameWhenItLooksForOne) {
  EXPECT_THAT(decode("price $5, or $$ " + kGood), ElementsAre("garbage", "TMSCT:10,OK"));
  EXPECT_THAT(decode("$TMSCT,x,1,$5 $$,*00\r\n" + kGood), ElementsAre("length", "TMSCT:10,OK"));
}

TEST(FrameDecoder, isNotStuckByARunOfDollars) {
  EXPECT_THAT(decode("$$$$" + kGood), ElementsAre("header", "TMSCT:10,OK"));
}

TEST(FrameDecoder, quotesWhatWasDropped) {
  const DecodeFault garbage = onlyFault("noise\r\n" + kGood);
  EXPECT_EQ(garbage.bytes, "noise\r\n");
  EXPECT_THAT(garbage.message, HasSubstr("noise\\r\\n"));
  EXPECT_EQ(onlyFault("$TMSCT,5,10,OK,*00\r\n").bytes, "$TMSCT,5,10,OK,*00\r\n");
  EXPECT_THAT(onlyFault("$TMSCT,5,10,OK,*00\r\n").message, HasSubstr("\"00\", expected 6D"));
  EXPECT_EQ(onlyFault("$TMSCT,-5,1").bytes, "$TMSCT,-");
  EXPECT_EQ(onlyFault(std::string(5000, 'x') + kGood).bytes, std::string(kMaxReportedBytes, 'x'));
}

TEST(FrameDecoder, acceptsAnEmptyLengthOnlyWhenToldSo) {
  const std::string frame = "$TMSCT,,1,ScriptExit(),*62\r\n";
  FrameDecoder::Options options;
  EXPECT_THAT(decode(frame + kGood), ElementsAre("length", "TMSCT:10,OK"));
  options.accept_empty_length = true;
  EXPECT_THAT(decode(frame + kGood, FrameDecoder(options)),
              ElementsAre("TMSCT:1,ScriptExit()", "TMSCT:10,OK"));
}

TEST(FrameDecoder, findsTheEndOfAFrameOfEmptyLengthInPieces) {
  const auto events = decodeInPieces(std::string("$TMSCT,,1,*,*x,*6,,*\r\n,*67\r\n") + kGood, 1, 1,
                                     FrameDecoder(FrameDecoder::Options{true}));
  EXPECT_EQ(events.size(), 2u);
  EXPECT_EQ(events.back(), "TMSCT:10,OK");
}

TEST(FrameDecoder, doesNotWaitForEverForTheEndOfAFrameOfEmptyLength) {
  FrameDecoder decoder(FrameDecoder::Options{true});
  decoder.feed("$TMSCT,,1,");
  const std::string block(1 << 20, 'x');
  std::vector<std::string> events;
  for (int i = 0; i < 18; ++i) {
    decoder.feed(block);
    for (const auto& event : drain(decoder)) events.push_back(event);
  }
  EXPECT_THAT(events, ElementsAre("length"));
  EXPECT_EQ(decoder.pending(), 0u);
}

// These three take a moment; with bytes that are read or moved again for each piece they would take hours.
TEST(FrameDecoder, takesALongFrameByteByByteInLinearTime) {
  const std::string frame = encodeFrame("TMSCT", std::string(std::size_t{1} << 22u, '$'));
  EXPECT_EQ(decodeInPieces(frame, 1, 1).size(), 1u);
}

TEST(FrameDecoder, takesManyFramesAtOnceInLinearTime) {
  std::string stream;
  for (int i = 0; i < 200000; ++i) stream += "$TMSCT,5,10,OK,*6D\r\n";
  EXPECT_EQ(decode(stream).size(), 200000u);
}

TEST(FrameDecoder, takesManyFalseStartsInLinearTime) {
  std::string stream;
  for (int i = 0; i < 200000; ++i) stream += "$A,16000000,$A,,";
  const FrameDecoder lenient(FrameDecoder::Options{true});
  FrameDecoder decoder = lenient;
  decoder.feed(stream);
  decoder.finish();
  EXPECT_EQ(drain(decoder).size(), 400000u);
}

TEST(FrameDecoder, tellsWhatIsLeftWhenTheStreamEnds) {
  const auto finished = [](std::string_view bytes) {
    FrameDecoder decoder;
    decoder.feed(bytes);
    decoder.finish();
    return drain(decoder);
  };
  EXPECT_THAT(finished(""), IsEmpty());
  EXPECT_THAT(finished(kGood), ElementsAre("TMSCT:10,OK"));
  EXPECT_THAT(finished(kGood + "$TMSCT,5,10"), ElementsAre("TMSCT:10,OK", "incomplete"));
  EXPECT_THAT(finished("$"), ElementsAre("incomplete"));
  EXPECT_THAT(finished("noise$"), ElementsAre("garbage"));
  EXPECT_THAT(finished("$TMSCT,6,10,OK,*6D\r\n"), ElementsAre("length"));
  EXPECT_THAT(finished("$TMSCT,60,10,OK,*6D\r\n" + kGood), ElementsAre("length", "TMSCT:10,OK"));
}

TEST(FrameDecoder, forgetsEverythingOnReset) {
  FrameDecoder decoder(FrameDecoder::Options{true});
  decoder.feed("noise$TMSCT,50,10,");
  drain(decoder);
  decoder.reset();
  EXPECT_EQ(decoder.pending(), 0u);
  decoder.feed("$TMSCT,,1,ScriptExit(),*62\r\n");
  EXPECT_THAT(drain(decoder), ElementsAre("TMSCT:1,ScriptExit()"));
}

}  // namespace
}  // namespace cobot_command::protocol
