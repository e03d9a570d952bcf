#include "cobot_command/rapid/checks/signal_file.h"

#include <gmock/gmock.h>

#include "cobot_command/common/foreign_text.h"

namespace cobot_command::rapid {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::SizeIs;

/// "2: signal file: ..."
std::string faultOf(const std::string& text) {
  const auto signals = readSignalFile(text);
  return signals ? "" : std::to_string(signals.error().line) + ": " + signals.error().text;
}

TEST(RapidSignalFile, namesEachInputAndOutput) {
  const auto signals = readSignalFile(
      "do_Gripper: {type: do, module: EndModule, index: 3, initial: 1}\n"
      "gi_part: {type: gi, module: ControlBox, bits: [4, 6, 5], inverted: true}\n"
      "ai_force: {type: ai, module: ControlBox, index: 1}\n"
      "go_code: {type: go, virtual: true, bits: 4, initial: 15}\n"
      "di_start: {type: di, virtual: true}\n");
  ASSERT_TRUE(signals) << signals.error().text;
  ASSERT_THAT(*signals, SizeIs(5));
  const Signal& gripper = signals->front();
  EXPECT_EQ(gripper.name, "do_Gripper");
  EXPECT_EQ(gripper.folded, "do_gripper");
  EXPECT_EQ(gripper.type, SignalType::Do);
  EXPECT_EQ(gripper.module, IoModule::EndModule);
  EXPECT_THAT(gripper.indices, ElementsAre(3));
  EXPECT_EQ(gripper.initial, 1);
  EXPECT_THAT((*signals)[1].indices, ElementsAre(4, 6, 5));
  EXPECT_TRUE((*signals)[1].is_inverted);
  EXPECT_TRUE((*signals)[3].is_virtual);
  EXPECT_THAT((*signals)[3].indices, SizeIs(4));
}

TEST(RapidSignalFile, mayBeEmpty) {
  const auto signals = readSignalFile("# none yet\n");
  ASSERT_TRUE(signals);
  EXPECT_THAT(*signals, IsEmpty());
}

TEST(RapidSignalFile, isRefusedWithTheLineAndTheReason) {
  const std::string good = "a: {type: di, module: ControlBox, index: 0}\n";
  const auto second = [&](const std::string& line) { return faultOf(good + line); };
  EXPECT_EQ(second("b: {type: di, module: ControlBox, index: 0}"),
            "2: signal file: di at ControlBox 0 is used twice");
  EXPECT_EQ(second("b: {type: gi, module: ControlBox, bits: [1, 0]}"),
            "2: signal file: di at ControlBox 0 is used twice");
  EXPECT_EQ(second("b: {type: di, module: ControlBox, index: 16}"),
            "2: signal file: index of di at ControlBox is from 0 to 15");
  EXPECT_EQ(second("b: {type: do, module: EndModule, index: 4}"),
            "2: signal file: index of do at EndModule is from 0 to 3");
  EXPECT_EQ(second("b: {type: ai, module: EndModule, index: 1}"),
            "2: signal file: index of ai at EndModule is from 0 to 0");
  EXPECT_EQ(second("b: {type: ao, module: EndModule, index: 0}"),
            "2: signal file: there is no ao at EndModule");
  EXPECT_EQ(second("b: {type: di, module: ControlBox, index: 0.5}"),
            "2: signal file: index of di at ControlBox is from 0 to 15");
  EXPECT_EQ(second("b: {type: dx, virtual: true}"),
            "2: signal file: type is something else; it must be one of: di, do, gi, go, ai, ao");
  EXPECT_EQ(second("b: {type: di, virtual: true, index: 1}"),
            "2: signal file: a virtual signal has no index");
  EXPECT_EQ(second("b: {type: di, index: 1}"), "2: signal file: module is missing");
  EXPECT_EQ(second("b: {type: go, module: ControlBox, index: 1}"),
            "2: signal file: a group has bits, no index");
  EXPECT_EQ(second("b: {type: di, module: ControlBox, bits: [1]}"), "2: signal file: bits are for gi and go");
  EXPECT_EQ(second("b: {type: go, virtual: true, bits: 17}"), "2: signal file: a group has 1 to 16 bits");
  EXPECT_EQ(second("b: {type: do, virtual: true, initial: 2}"),
            "2: signal file: initial is from 0 to 1, a whole number");
  EXPECT_EQ(second("b: {type: ao, virtual: true, initial: 11}"), "2: signal file: initial is from -10 to 10");
  EXPECT_EQ(second("b: {type: ai, virtual: true, inverted: true}"),
            "2: signal file: an analog signal is not inverted");
  EXPECT_EQ(second("A: {type: di, virtual: true}"),
            "2: signal file: 'A' is there twice; case does not count");
  EXPECT_EQ(second("1b: {type: di, virtual: true}"), "2: signal file: '1b' is no name of RAPID");
  EXPECT_EQ(second("for: {type: di, virtual: true}"), "2: signal file: 'for' is no name of RAPID");
  EXPECT_EQ(second("MoveL: {type: di, virtual: true}"),
            "2: signal file: 'MoveL' is a predefined name of RAPID");
  EXPECT_EQ(faultOf("a: [1"), "1: signal file: not YAML: end of sequence flow not found");
  EXPECT_EQ(faultOf("- a"), "1: signal file: it must be a map from names to signals");
}

TEST(RapidSignalFile, quotesForeignTextBounded) {
  const std::string text = faultOf("\"" + std::string(1000, 'a') + "\\e[31m\": {type: di, virtual: true}");
  EXPECT_LT(text.size(), 200U);
  EXPECT_EQ(text, escaped(text));
}

}  // namespace
}  // namespace cobot_command::rapid
