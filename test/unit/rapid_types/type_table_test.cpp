#include "cobot_command/rapid/types/type_table.h"

#include <gmock/gmock.h>

#include "cobot_command/rapid/types/cells.h"
#include "cobot_command/rapid/types/signal.h"

namespace cobot_command::rapid {
namespace {

using ::testing::Eq;
using ::testing::Optional;

TEST(RapidTypes, haveASizeInCells) {
  TypeTable types;
  EXPECT_EQ(types[kNum].cells, 1U);
  EXPECT_EQ(types[kBool].cells, 1U);
  EXPECT_EQ(types[kString].cells, kStringCells);
  EXPECT_EQ(types[types.atomicNamed("clock")].cells, 1U);
  EXPECT_EQ(types[types.arrayOf(kString, 2, {2, 3})].cells, 6 * kStringCells);
  EXPECT_EQ(types.atomicNamed("robtarget"), kNoType);
}

TEST(RapidTypes, placeTheComponentsOfARecordOneAfterAnother) {
  TypeTable types;
  const TypeIndex part = types.addRecord("part");
  types.setComponents(part, {{"name", kString}, {"count", kNum}, {"list", types.arrayOf(kNum, 1, {4})}});
  EXPECT_EQ(types[part].cells, kStringCells + 5);
  EXPECT_THAT(types.componentNamed(part, "count"), Optional(1U));
  EXPECT_EQ(types[part].components[1].offset, kStringCells);
  EXPECT_EQ(types[part].components[2].offset, kStringCells + 1);
  EXPECT_THAT(types.componentNamed(part, "weight"), Eq(std::nullopt));
}

TEST(RapidTypes, areOneTypeIfTheyAreEqual) {
  TypeTable types;
  const TypeIndex row = types.arrayOf(kNum, 1, {3});
  EXPECT_EQ(types.arrayOf(kNum, 1, {3}), row);
  EXPECT_NE(types.arrayOf(kNum, 1, {4}), row);
  EXPECT_NE(types.arrayOf(kNum, 2, {3, 1}), row);
  EXPECT_NE(types.addRecord("a"), types.addRecord("a"));
}

TEST(RapidTypes, areNamedAsInADeclaration) {
  TypeTable types;
  EXPECT_EQ(types.nameOf(kNum), "num");
  EXPECT_EQ(types.nameOf(types.arrayOf(kBool, 2, {2, 3})), "bool{2,3}");
  EXPECT_EQ(types.nameOf(types.arrayOf(kNum, 2, {})), "num{*,*}");
  EXPECT_TRUE(types.isConformant(types.arrayOf(kNum, 2, {})));
}

TEST(RapidTypes, haveNoValuesIfAPartHasNone) {
  TypeTable types;
  const TypeIndex timer = types.addRecord("timer");
  types.setComponents(timer, {{"at", kNum}, {"clock", types.atomicNamed("clock")}});
  EXPECT_FALSE(types[timer].has_values);
  EXPECT_FALSE(types[types.arrayOf(timer, 1, {2})].has_values);
  EXPECT_TRUE(types[typeOf(SignalType::Di)].has_values);
  EXPECT_FALSE(types[typeOf(SignalType::Do)].has_values);
}

TEST(RapidTypes, stopCountingCellsBeyondWhatAProgramMayHave) {
  TypeTable types;
  TypeIndex type = kString;
  for (int i = 0; i < 100; ++i) {
    const TypeIndex twice = types.addRecord("twice");
    types.setComponents(twice, {{"a", type}, {"b", type}});
    type = twice;
  }
  EXPECT_EQ(types[type].cells, kMostCells + 1);
  EXPECT_EQ(types[types.arrayOf(type, 3, {1000, 1000, 1000})].cells, kMostCells + 1);
}

}  // namespace
}  // namespace cobot_command::rapid
