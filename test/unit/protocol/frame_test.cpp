#include "cobot_command/protocol/frame.h"

#include <gmock/gmock.h>

namespace cobot_command::protocol {
namespace {

TEST(EncodeFrame, takesDataInParts) {
  EXPECT_EQ(encodeFrame("TMSCT", {"1", ",", "", "Pause()"}), encodeFrame("TMSCT", "1,Pause()"));
}

TEST(Checksum, isTheXorOfTheManualsWorkedExample) {
  EXPECT_EQ(checksum("TMSCT,5,10,OK,"), 0x6D);
}

TEST(Checksum, ofNoBytesIsZero) {
  EXPECT_EQ(checksum(""), 0);
}

TEST(Checksum, equalsTheByteLoopForEveryLength) {
  std::string bytes;
  std::uint8_t expected = 0;
  for (int i = 0; i < 300; ++i) {
    const auto byte = static_cast<unsigned char>(i * 131 + 7);
    bytes += static_cast<char>(byte);
    expected = static_cast<std::uint8_t>(expected ^ byte);
    ASSERT_EQ(checksum(bytes), expected) << bytes.size() << " bytes";
  }
}

TEST(EncodeFrame, writesTheManualsWorkedExample) {
  EXPECT_EQ(encodeFrame("TMSCT", "10,OK"), "$TMSCT,5,10,OK,*6D\r\n");
}

TEST(EncodeFrame, countsBytesNotCharacters) {
  EXPECT_EQ(encodeFrame("TMSCT", "1,\u9054\u660e"), "$TMSCT,8,1,\u9054\u660e,*58\r\n");
}

TEST(EncodeFrame, writesEmptyData) {
  EXPECT_EQ(encodeFrame("TMSTA", ""), "$TMSTA,0,,*43\r\n");
}

TEST(EncodeFrame, padsTheChecksumToTwoDigits) {
  EXPECT_EQ(encodeFrame("TMSCT", "4,ERROR;1"), "$TMSCT,9,4,ERROR;1,*02\r\n");
}

}  // namespace
}  // namespace cobot_command::protocol
