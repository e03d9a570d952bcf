#include "cobot_command/rapid/types/cells.h"

#include <array>
#include <cmath>

#include <gmock/gmock.h>

namespace cobot_command::rapid {
namespace {

using ::testing::Eq;
using ::testing::Optional;

using StringCells = std::array<Cell, kStringCells>;

StringCells cellsOf(std::string_view bytes) {
  StringCells cells;
  cells.fill(1234.5F);
  putString(bytes, cells.data());
  return cells;
}

TEST(RapidCells, keepStringsOfUpToEightyBytesInline) {
  EXPECT_EQ(stringIn(cellsOf("").data()), "");
  EXPECT_EQ(stringIn(cellsOf("lid").data()), "lid");
  const std::string longest(kMostTextCharacters, '\xE9');
  EXPECT_EQ(stringIn(cellsOf(longest).data()), longest);
  const std::string with_zero("a\0b", 3);
  EXPECT_EQ(stringIn(cellsOf(with_zero).data()), with_zero);
}

TEST(RapidCells, ofEqualValuesAreEqualMemory) {
  EXPECT_TRUE(areEqual(cellsOf("lid").data(), cellsOf("lid").data(), kStringCells));
  EXPECT_FALSE(areEqual(cellsOf("lid").data(), cellsOf("lie").data(), kStringCells));
  EXPECT_FALSE(areEqual(cellsOf("").data(), cellsOf(std::string(1, '\0')).data(), kStringCells));
  const std::array<Cell, 2> left{numCell(-0.0F), boolCell(true)};
  const std::array<Cell, 2> right{numCell(0.0F), boolCell(true)};
  EXPECT_TRUE(areEqual(left.data(), right.data(), left.size()));
}

TEST(RapidCells, haveNoNegativeZero) {
  EXPECT_FALSE(std::signbit(numCell(-0.0F)));
  EXPECT_EQ(numCell(-1.5F), -1.5F);
}

TEST(RapidCells, convertTextsBetweenUtf8AndIso8859) {
  EXPECT_THAT(latin1("gr\xC3\xBC\xC3\x9F"), Optional(Eq("gr\xFC\xDF")));
  EXPECT_EQ(utf8("gr\xFC\xDF"), "gr\xC3\xBC\xC3\x9F");
  EXPECT_THAT(latin1("\xE2\x82\xAC 5"), Eq(std::nullopt));  // the sign of the euro
  EXPECT_THAT(latin1("\xFF"), Eq(std::nullopt));
}

}  // namespace
}  // namespace cobot_command::rapid
