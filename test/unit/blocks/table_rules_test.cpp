// The tables take what the blocks take: the same names, weights and inertias, by the same numbers.

#include <string>
#include <utility>

#include "block_goals.h"
#include <gtest/gtest.h>

#include "cobot_command/arm/controller_pose.h"
#include "cobot_command/tables/table_store.h"
#include "cobot_command/tables/table_text.h"

namespace cobot_command::testing {
namespace {

using namespace blocks;

static_assert(tables::table_error::kNotFinite == own_error::kNotFinite);
static_assert(tables::table_error::kCoordinateRange == own_error::kCoordinateRange);
static_assert(tables::table_error::kInertiaRange == own_error::kInertiaRange);
static_assert(tables::table_error::kNameInvalid == own_error::kNameInvalid);
static_assert(tables::table_error::kShutDown == own_error::kShutDown);

int idOfTool(const tables::Tool& tool) {
  const auto refusal = tables::TableStore().writeTool(1, tool);
  return refusal ? refusal->error_id : 0;
}

TEST(TableRules, takeTheNamesOfChangeTcp) {
  for (const std::string& name :
       {std::string("NOTOOL"), std::string("\xC3\xBC"), std::string(255, 'n'), std::string(256, 'n'),
        std::string("a\nb"), std::string("\xC3"), std::string("a\"b"), std::string("\x7F")}) {
    const int of_block = errorWith<ChangeTcpGoal>([&](auto& g) { g.tcp_name = name; });
    EXPECT_EQ(idOfTool({name, std::nullopt, 0}), of_block) << name;
  }
}

TEST(TableRules, takeTheNumbersOfChangeTcp) {
  for (const double value : {100000.0, -100000.0, 100000.001, 1e308, kNan, kInf}) {
    const int of_block = errorWith<ChangeTcpGoal>([&](auto& g) { g.tcp_offset[0] = value; });
    const auto pose = tables::poseIn({value, 0, 0, 0, 0, 0});
    EXPECT_EQ(pose ? 0 : pose.error().error_id, of_block) << value;
  }
}

TEST(TableRules, takeTheInertiasOfChangeTcp) {
  for (const double moment : {0.0, 1e9, 1.000001e9, -0.001, kNan}) {
    const int of_block = errorWith<ChangeTcpGoal>([&](auto& g) { g.moment_of_inertia[1] = moment; });
    tables::Load load;
    load.inertia[1] = moment * 1e-6;
    const auto refusal = tables::TableStore().writeLoad(1, load);
    EXPECT_EQ(refusal ? refusal->error_id : 0, of_block) << moment;
  }
}

TEST(TableRules, takeTheWeightsOfChangeLoadWhereTheArmIsNotKnown) {
  using Row = std::pair<std::string, double>;
  for (const auto& [text, weight] :
       {Row{"0", 0}, Row{"14", 14}, Row{"14.001", 14.001}, Row{"-1", -1}, Row{"nan", kNan}}) {
    const int of_block = errorWith<ChangeLoadGoal>([kg = weight](auto& g) { g.weight = kg; });
    EXPECT_EQ(tables::readLists({{}, {}, {"1=" + text}}, {}).has_value(), of_block == 0) << text;
  }
}

}  // namespace
}  // namespace cobot_command::testing
