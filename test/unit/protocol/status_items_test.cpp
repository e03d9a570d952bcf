#include "cobot_command/protocol/status_items.h"

#include <limits>

#include <gmock/gmock.h>

namespace cobot_command::protocol {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using namespace std::string_literals;

TEST(StatusFrame, isIdModeAndContent) {
  const auto frame = parseStatusFrame({"TMSVR", "S5,2,Robot_Link=1,\r\n"});
  ASSERT_TRUE(frame);
  EXPECT_EQ(frame->id, "S5");
  EXPECT_EQ(frame->mode, 2);
  EXPECT_EQ(frame->content, "Robot_Link=1,\r\n");
  EXPECT_EQ(encode(StatusFrame{"S5", 2, "Robot_Link=1"}), "$TMSVR,17,S5,2,Robot_Link=1,*07\r\n");
}

TEST(StatusFrame, mayHaveAModeThatNobodyKnowsAndNoContent) {
  const auto frame = parseStatusFrame({"TMSVR", "S1,99,"});
  ASSERT_TRUE(frame);
  EXPECT_EQ(frame->mode, 99);
  EXPECT_EQ(frame->content, "");
}

TEST(StatusFrame, withoutIdOrModeIsADataFault) {
  for (const char* data :
       {"", ",", ",,", ",1,", "S1", "S1,1", "S_1,1,", "S1,x,", "S1,,", "S1,-1,", "S1,99999999999,"}) {
    const auto frame = parseStatusFrame({"TMSVR", data});
    ASSERT_FALSE(frame) << data;
    EXPECT_EQ(frame.error().kind, MessageFault::Kind::Data);
  }
}

TEST(StatusFrame, hasTheHeaderOfItsPort) {
  const auto frame = parseStatusFrame({"TMsvr", "S1,2,x"});
  ASSERT_FALSE(frame);
  EXPECT_EQ(frame.error().kind, MessageFault::Kind::UnknownHeader);
}

TEST(BinaryItems, areReadFromTheManualsPeriodicFrame) {
  const auto items = parseBinaryItems(
      "\n\0Robot_Link\x01\0\0\x09\0TCP_Value\x18\0\0\0\x80?\0\0\x80?\0\0\x80?"
      "\xCD\xCC\xCC=\xCD\xCCL>\xCD\xCC\xCC=\x08\0Ctrl_DO0\x01\0\0"s);
  ASSERT_TRUE(items) << items.error().message;
  ASSERT_EQ(items->size(), 3u);
  EXPECT_EQ((*items)[0].name, "Robot_Link");
  EXPECT_EQ(item::asByte((*items)[0]), 0);
  EXPECT_EQ((*items)[1].name, "TCP_Value");
  EXPECT_THAT(item::asFloats((*items)[1]).value(), ElementsAre(1.F, 1.F, 1.F, 0.1F, 0.2F, 0.1F));
  EXPECT_EQ(item::asBool((*items)[2]), false);
  EXPECT_EQ(encodeBinaryItems({item::ofByte("Robot_Link", 0),
                               item::ofFloats("TCP_Value", {1, 1, 1, 0.1F, 0.2F, 0.1F}),
                               item::ofBool("Ctrl_DO0", false)}),
            encodeBinaryItems(*items));
}

TEST(BinaryItems, mayBeNone) {
  const auto items = parseBinaryItems("");
  ASSERT_TRUE(items);
  EXPECT_TRUE(items->empty());
}

TEST(BinaryItems, areRefusedAtEveryPlaceWhereTheyAreCut) {
  const std::string whole = encodeBinaryItems({item::ofInt("A", 1), item::ofString("B", "text")});
  const std::size_t first = 2 + 1 + 2 + 4;
  for (std::size_t size = 1; size < whole.size(); ++size) {
    const auto items = parseBinaryItems(std::string_view(whole).substr(0, size));
    if (size == first) continue;
    ASSERT_FALSE(items) << size << " bytes";
    EXPECT_EQ(items.error().kind, MessageFault::Kind::Data);
    EXPECT_THAT(items.error().message, HasSubstr(size < first ? "item 1 at byte 0" : "item 2 at byte 9"));
  }
}

TEST(BinaryItems, withALengthBeyondTheContentAreRefused) {
  EXPECT_FALSE(parseBinaryItems("\xFF\xFF"s + "A"));
  EXPECT_FALSE(parseBinaryItems("\x01\0A\xFF\xFF"s + "x"));
  EXPECT_FALSE(parseBinaryItems("[{}]"));
}

TEST(BinaryItems, withoutANameAreRefused) {
  EXPECT_FALSE(parseBinaryItems("\0\0\x01\0x"s));
}

TEST(BinaryItems, holdTheLongestNameAndValue) {
  const StatusItem longest{std::string(65535, 'n'), std::string(65535, 'v')};
  const auto items = parseBinaryItems(encodeBinaryItems({longest, longest}));
  ASSERT_TRUE(items);
  EXPECT_TRUE(*items == std::vector<StatusItem>({longest, longest}));
}

TEST(Item, isLittleEndianOnTheWire) {
  EXPECT_EQ(item::ofInt("x", 0x01020304).value, "\x04\x03\x02\x01");
  EXPECT_EQ(item::ofInt("x", -2).value, "\xFE\xFF\xFF\xFF");
  EXPECT_EQ(item::ofFloat("x", 1.F).value, "\0\0\x80?"s);
  EXPECT_EQ(item::ofFloats("x", {1.F, 0.1F}).value, "\0\0\x80?\xCD\xCC\xCC="s);
  EXPECT_EQ(item::ofByte("x", 200).value, "\xC8");
  EXPECT_EQ(item::ofBool("x", true).value, "\x01");
  EXPECT_EQ(item::ofString("x", "TM5").value, "TM5");
}

TEST(Item, isReadAsWhatItWasWrittenAs) {
  for (const std::int32_t value :
       {0, 1, -1, std::numeric_limits<int>::max(), std::numeric_limits<int>::min()}) {
    EXPECT_EQ(item::asInt(item::ofInt("x", value)), value);
  }
  for (const float value : {0.F, -1.29178234E-05F, 125.000435F, std::numeric_limits<float>::max()}) {
    EXPECT_EQ(item::asFloat(item::ofFloat("x", value)), value);
  }
  EXPECT_EQ(item::asByte(item::ofByte("x", 255)), 255);
  EXPECT_EQ(item::asBool(item::ofBool("x", true)), true);
}

TEST(Item, isNothingWhenItsSizeDoesNotFit) {
  const StatusItem five{"x", "12345"};
  EXPECT_FALSE(item::asByte(five));
  EXPECT_FALSE(item::asBool(five));
  EXPECT_FALSE(item::asInt(five));
  EXPECT_FALSE(item::asFloat(five));
  EXPECT_FALSE(item::asFloats(five));
  EXPECT_TRUE(item::asFloats({"x", ""}).value().empty());
}

TEST(StatusReply, isReadAndWritten) {
  using Code = StatusReply::Code;
  EXPECT_EQ(toContent({Code::Ok, ""}), "00,OK");
  EXPECT_EQ(toContent({Code::NotSupported, ""}), "01,NotSupport");
  EXPECT_EQ(toContent({Code::NotExist, "TCP_MaXX"}), "04,NotExist;TCP_MaXX");
  for (int code = 0; code <= 7; ++code) {
    const StatusReply reply{static_cast<Code>(code), code < 4 ? "" : "Item"};
    const auto read = parseStatusReply(toContent(reply));
    ASSERT_TRUE(read);
    EXPECT_EQ(read->code, reply.code);
    EXPECT_EQ(read->item, reply.item);
  }
}

TEST(StatusReply, withoutAKnownCodeIsADataFault) {
  for (const char* content : {"", "00", "00,", "00,;x", "0,OK", "000,OK", "08,OK", "xx,OK", "-1,OK"}) {
    EXPECT_FALSE(parseStatusReply(content)) << content;
  }
}

}  // namespace
}  // namespace cobot_command::protocol
