#include <gmock/gmock.h>

#include "cobot_command/rapid/source/dialect.h"
#include "cobot_command/rapid/source/name_table.h"

namespace cobot_command::rapid {
namespace {

using ::testing::Eq;
using ::testing::Optional;

TEST(RapidNames, haveTheReservedWordsFirst) {
  NameTable names;
  EXPECT_EQ(names.size(), static_cast<std::size_t>(kReservedWords));
  EXPECT_EQ(names.add("ENDIF"), static_cast<NameIndex>(TokenKind::Endif));
}

TEST(RapidNames, findTheSameNameInAnyCase) {
  NameTable names;
  const NameIndex name = names.add("PickPart");
  EXPECT_EQ(names.add("PICKPART"), name);
  EXPECT_THAT(names.find("pickpart"), Optional(name));
  EXPECT_THAT(names.find("pickparts"), Eq(std::nullopt));
  EXPECT_EQ(names.folded(name), "pickpart");
}

TEST(RapidNames, tellManyNamesApart) {
  NameTable names;
  std::vector<NameIndex> indices;
  indices.reserve(10000);
  for (int i = 0; i < 10000; ++i) indices.push_back(names.add("name_" + std::to_string(i)));
  for (int i = 0; i < 10000; ++i) {
    EXPECT_EQ(names.add("NAME_" + std::to_string(i)), indices.at(static_cast<std::size_t>(i)));
  }
}

TEST(RapidNames, readLongNamesAsShortOnes) {
  NameTable names;
  const std::string name(1000, 'A');
  EXPECT_EQ(names.add(name), names.add(std::string(1000, 'a')));
}

TEST(RapidNames, surviveAMove) {
  NameTable names;
  const NameIndex name = names.add("x");
  NameTable moved = std::move(names);
  EXPECT_EQ(moved.add("X"), name);
  EXPECT_EQ(moved.folded(name), "x");
}

TEST(RapidNames, ofDialectsAreThoseOfTheContract) {
  EXPECT_THAT(dialectNamed("irc5"), Optional(Dialect::Irc5));
  EXPECT_THAT(dialectNamed("s4c"), Optional(Dialect::S4c));
  EXPECT_THAT(dialectNamed("s4"), Eq(std::nullopt));
}

}  // namespace
}  // namespace cobot_command::rapid
