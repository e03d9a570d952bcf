#include "cobot_command/rapid/source/literals.h"

#include <limits>

#include <gmock/gmock.h>

namespace cobot_command::rapid {
namespace {

using ::testing::Eq;
using ::testing::Optional;

TEST(RapidLiterals, roundsNumbersToSinglePrecisionOnce) {
  EXPECT_THAT(numberValue("0.1"), Optional(0.1F));
  EXPECT_THAT(numberValue("8388607"), Optional(8388607.0F));
  EXPECT_THAT(numberValue("123456789"), Optional(123456792.0F));
  EXPECT_THAT(numberValue("9E+09"), Optional(9e9F));
  // Halfway between two floats in double, above it in decimal: two roundings would go down.
  EXPECT_THAT(numberValue("1.00000005960464477540"), Optional(1.00000011920928955078125F));
}

TEST(RapidLiterals, readsTheFormsOfIrc5) {
  EXPECT_THAT(numberValue(".5"), Optional(0.5F));
  EXPECT_THAT(numberValue("5."), Optional(5.0F));
  EXPECT_THAT(numberValue("0x1F"), Optional(31.0F));
  EXPECT_THAT(numberValue("0B101"), Optional(5.0F));
  EXPECT_THAT(numberValue("0o17"), Optional(15.0F));
}

TEST(RapidLiterals, refusesWhatIsBeyondSinglePrecision) {
  EXPECT_THAT(numberValue("3.4028234E38"), Optional(std::numeric_limits<float>::max()));
  EXPECT_THAT(numberValue("1E39"), Eq(std::nullopt));
  EXPECT_THAT(numberValue("1E400"), Eq(std::nullopt));
  EXPECT_THAT(numberValue("1E99999999999999999999"), Eq(std::nullopt));
  EXPECT_THAT(numberValue("1" + std::string(39, '0')), Eq(std::nullopt));
  EXPECT_THAT(numberValue("0x1" + std::string(32, '0')), Eq(std::nullopt));
}

TEST(RapidLiterals, takesWhatIsTooSmallAsZero) {
  EXPECT_THAT(numberValue("1E-60"), Optional(0.0F));
  EXPECT_THAT(numberValue("1E-400"), Optional(0.0F));
  EXPECT_THAT(numberValue("1E-99999999999999999999"), Optional(0.0F));
  EXPECT_THAT(numberValue("0." + std::string(400, '0') + "1"), Optional(0.0F));
  EXPECT_THAT(numberValue("0E400"), Optional(0.0F));
}

TEST(RapidLiterals, refusesWhatIsNoNumber) {
  for (const char* written : {"1.2.3", "12ab", "0x", "0xG", "0b2", ""}) {
    EXPECT_THAT(numberValue(written), Eq(std::nullopt)) << written;
  }
}

TEST(RapidLiterals, replacesTheEscapesOfTexts) {
  EXPECT_EQ(textValue(R"("a ""b"" \\ \07")"), "a \"b\" \\ \a");
  EXPECT_EQ(textValue(R"("")"), "");
  EXPECT_EQ(textValue(R"("\41\42C!")"), "ABC!");
  EXPECT_EQ(textValue(R"("\e4\FF")"), "\xC3\xA4\xC3\xBF");
}

TEST(RapidLiterals, readsADamagedTextWithoutHarm) {
  EXPECT_EQ(textValue(R"("\zz")"), R"(\zz)");
  EXPECT_EQ(textValue(R"("open)"), "open");
  EXPECT_EQ(textValue(R"("\4)"), R"(\4)");
  EXPECT_EQ(textValue("\""), "");
  EXPECT_EQ(textValue(""), "");
}

}  // namespace
}  // namespace cobot_command::rapid
