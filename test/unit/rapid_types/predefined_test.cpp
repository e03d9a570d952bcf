#include "cobot_command/rapid/types/predefined.h"

#include <fstream>
#include <iterator>

#include "source_tree.h"
#include <gmock/gmock.h>

#include "cobot_command/rapid/source/literals.h"

namespace cobot_command::rapid {
namespace {

using ::testing::IsEmpty;

TEST(RapidPredefined, isReadWithoutFindings) {
  EXPECT_THAT(predefinedData().findings(), IsEmpty());
  EXPECT_THAT(catalogue().findings(), IsEmpty());
}

TEST(RapidPredefined, hasTheCatalogueByteForByte) {
  std::ifstream file(test_support::inSourceTree("src/rapid/types/catalogue.rapid"));
  const std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  EXPECT_EQ(catalogue().text(), text);
}

TEST(RapidPredefined, findsRoutinesTypesAndDataByTheirNames) {
  EXPECT_EQ(predefinedNames().find("movel").written, "MoveL");
  EXPECT_EQ(predefinedNames().find("v100").written, "v100");
  EXPECT_EQ(predefinedNames().find("err_divzero").written, "ERR_DIVZERO");
  EXPECT_EQ(predefinedNames().findType("robtarget").written, "robtarget");
  EXPECT_EQ(predefinedNames().findType("triggdata").written, "triggdata");
  EXPECT_EQ(predefinedNames().find("robtarget").written, "");
  EXPECT_EQ(predefinedNames().find("nothing").written, "");
}

TEST(RapidPredefined, knowsTheNamesThatAreRefusedWithReasonAndWayAround) {
  EXPECT_EQ(refusals().size(), 72U);
  EXPECT_EQ(refusals().front().name, "ActUnit");
  EXPECT_EQ(refusals().front().reason, "the arm has six axes and no others");
  EXPECT_EQ(refusals().front().way_around, "leave external axes 9E9, or --skip");
  EXPECT_EQ(refusals().back().name, "TUNE_TI");
  for (const Refusal& refusal : refusals()) {
    EXPECT_FALSE(refusal.reason.empty()) << refusal.name;
    EXPECT_FALSE(refusal.way_around.empty()) << refusal.name;
  }
  EXPECT_EQ(predefinedNames().find("softact").written, "SoftAct");
}

TEST(RapidPredefined, tellsApartWhatIsBuiltAndWhatEachDialectHas) {
  EXPECT_FALSE(isNotBuilt(predefinedNames().find("tpshow").node));
  EXPECT_TRUE(isNotBuilt(predefinedNames().find("movejdo").node));
  EXPECT_TRUE(isNotBuilt(predefinedNames().find("bitcheck").node));
  for (const char* name : {"z0", "calcrobt", "bitcheck", "gettaskname"}) {
    EXPECT_TRUE(isOfIrc5Alone(name)) << name;
  }
  for (const char* name : {"z1", "movel", "readbin", "mine"}) EXPECT_FALSE(isOfIrc5Alone(name)) << name;
}

TEST(RapidPredefined, declaresEachNameOnce) {
  for (const Source* source : {&predefinedData(), &catalogue()}) {
    const Tree& tree = source->tree();
    for (const NodeIndex node : tree.children(tree.childOf(Tree::kRoot, NodeKind::Module))) {
      const std::string_view name = source->nameOf(node);
      if (name.empty()) continue;
      const DeclaredName data = predefinedNames().find(name);
      const DeclaredName type = predefinedNames().findType(name);
      EXPECT_TRUE(data.node == node || type.node == node) << name;
    }
  }
}

TEST(RapidPredefined, hasTheValuesOfTheContract) {
  const Tree& tree = predefinedData().tree();
  const auto value_of = [&](const char* name) {
    const Span span = predefinedData().spanOf(tree.expressionOf(predefinedNames().find(name).node));
    return std::string(predefinedData().text().substr(span.begin, span.end - span.begin));
  };
  EXPECT_EQ(value_of("v5"), "[5,500,5000,1000]");
  EXPECT_EQ(value_of("vmax"), "[5000,500,5000,1000]");
  EXPECT_EQ(value_of("fine"), "[TRUE,0,0,0,0,0,0]");
  EXPECT_EQ(value_of("z50"), "[FALSE,50,75,75,7.5,75,7.5]");
  EXPECT_EQ(value_of("tool0"), "[TRUE,[[0,0,0],[1,0,0,0]],[0.001,[0,0,0.001],[1,0,0,0],0,0,0]]");
  EXPECT_EQ(value_of("pi"), "3.1415926");
  EXPECT_EQ(value_of("err_divzero"), "1001");
}

}  // namespace
}  // namespace cobot_command::rapid
