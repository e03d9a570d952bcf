// Which path a robot takes next, and when it has done what was asked for.
#include "agent/itinerary.h"

#include <gmock/gmock.h>

namespace cobot_command::cell {
namespace {

using blocks::ProgramRequest;
using testing::HasSubstr;

/// From HOME to A and B and back, and from A to B.
RobotProgram triangle() {
  RobotProgram program;
  program.name = "R";
  program.stations = {"HOME", "A", "B"};
  program.paths = {
      {"OUT_A", 0, 1, {}}, {"BACK_A", 1, 0, {}}, {"OUT_B", 0, 2, {}}, {"BACK_B", 2, 0, {}}, {"ON", 1, 2, {}}};
  return program;
}

constexpr PathIndex kOutA = 0;
constexpr PathIndex kBackA = 1;
constexpr PathIndex kOutB = 2;
constexpr PathIndex kBackB = 3;
constexpr PathIndex kOn = 4;

class ItineraryTest : public testing::Test {
 protected:
  void go(PathIndex path) {
    ASSERT_EQ(itinerary.next(program.paths[path].from), path);
    itinerary.setOut();
    itinerary.reached(program.paths[path].to);
  }
  void begin(const ProgramRequest& request) {
    ASSERT_EQ(itinerary.begin(request, 0, std::nullopt), std::nullopt);
  }

  RobotProgram program = triangle();
  Itinerary itinerary{program};
};

TEST_F(ItineraryTest, takesTheWholeProgramFromHomeToHomeForACycle) {
  begin({{}, 2});
  go(kOutA);
  EXPECT_EQ(itinerary.cyclesDone(), 0);
  go(kBackA);
  EXPECT_EQ(itinerary.cyclesDone(), 1);
  EXPECT_FALSE(itinerary.isOver());
  go(kOutA);
  go(kBackA);
  EXPECT_TRUE(itinerary.isOver());
}

TEST_F(ItineraryTest, takesThePathsThatItWasToldInTheirOrder) {
  begin({{"OUT_A", "ON", "BACK_B"}, 2});
  for (int cycle = 1; cycle <= 2; ++cycle) {
    go(kOutA);
    go(kOn);
    EXPECT_EQ(itinerary.cyclesDone(), cycle - 1);
    go(kBackB);
    EXPECT_EQ(itinerary.cyclesDone(), cycle);
  }
  EXPECT_TRUE(itinerary.isOver());
}

TEST_F(ItineraryTest, isOverBehindTheLastPathThoughThatDoesNotLeadHome) {
  begin({{"OUT_A", "ON"}, 1});
  go(kOutA);
  EXPECT_FALSE(itinerary.isOver());
  go(kOn);
  EXPECT_TRUE(itinerary.isOver());
}

TEST_F(ItineraryTest, triesTheOtherPathsOfAStationByTurnsUntilItSetsOut) {
  begin({{}, 1});
  EXPECT_TRUE(itinerary.hasOthers(0));
  EXPECT_FALSE(itinerary.hasOthers(2));
  EXPECT_EQ(itinerary.next(0), kOutA);
  itinerary.tryAnother();
  EXPECT_EQ(itinerary.next(0), kOutB);
  itinerary.tryAnother();
  EXPECT_EQ(itinerary.next(0), kOutA);
  itinerary.tryAnother();
  itinerary.setOut();
  itinerary.reached(2);
  EXPECT_EQ(itinerary.next(2), kBackB);
  itinerary.setOut();
  itinerary.reached(0);
  EXPECT_TRUE(itinerary.isOver());
}

TEST_F(ItineraryTest, triesNoOtherPathThanItWasTold) {
  begin({{"OUT_B", "BACK_B"}, 1});
  EXPECT_FALSE(itinerary.hasOthers(0));
}

TEST_F(ItineraryTest, goesOnForEverWhenNobodySaysHowOften) {
  begin({{"OUT_A", "BACK_A"}, 0});
  for (int i = 0; i < 50; ++i) {
    go(kOutA);
    go(kBackA);
  }
  EXPECT_FALSE(itinerary.isOver());
  EXPECT_EQ(itinerary.cyclesDone(), 50);
}

TEST_F(ItineraryTest, endsWithTheCycleThatIsUnderWayWhenItIsToFinish) {
  begin({{}, 0});
  itinerary.setOut();
  itinerary.finish();
  EXPECT_FALSE(itinerary.isOver());
  itinerary.reached(1);
  EXPECT_FALSE(itinerary.isOver());
  go(kBackA);
  EXPECT_TRUE(itinerary.isOver());
}

TEST_F(ItineraryTest, endsAtOnceWhenItIsToFinishBetweenTwoCycles) {
  begin({{}, 5});
  go(kOutA);
  go(kBackA);
  itinerary.finish();
  EXPECT_TRUE(itinerary.isOver());
  EXPECT_EQ(itinerary.cyclesDone(), 1);
}

TEST_F(ItineraryTest, goesOnWithThePathThatItIsOnAlready) {
  ASSERT_EQ(itinerary.begin({{"ON", "BACK_B"}, 1}, 0, kOn), std::nullopt);
  itinerary.reached(2);
  EXPECT_FALSE(itinerary.isOver());
  go(kBackB);
  EXPECT_TRUE(itinerary.isOver());
}

TEST_F(ItineraryTest, cannotBeginWhereTheRobotIsNot) {
  EXPECT_THAT(*itinerary.begin({{"BACK_A"}, 1}, 0, std::nullopt),
              HasSubstr("is at HOME, but BACK_A starts at A"));
  EXPECT_THAT(*itinerary.begin({{"OUT_A"}, 1}, 0, kOn), HasSubstr("is on path ON, not on OUT_A"));
}

TEST(ARequestForPaths, isRefusedWhereTheyCannotBeGoneOneBehindTheOther) {
  const RobotProgram program = triangle();
  EXPECT_EQ(Itinerary::objectionTo(program, {{"OUT_A", "BACK_A"}, 3}), std::nullopt);
  EXPECT_EQ(Itinerary::objectionTo(program, {{}, 3}), std::nullopt);
  EXPECT_EQ(Itinerary::objectionTo(program, {{"OUT_A"}, 1}), std::nullopt);
  EXPECT_THAT(*Itinerary::objectionTo(program, {{"OUT_C"}, 1}),
              HasSubstr("no path \"OUT_C\"; it has OUT_A, BACK_A"));
  EXPECT_THAT(*Itinerary::objectionTo(program, {{"OUT_A", "BACK_B"}, 1}),
              HasSubstr("BACK_B starts at B, but OUT_A ends at A"));
  EXPECT_THAT(*Itinerary::objectionTo(program, {{"OUT_A"}, 2}), HasSubstr("must form a loop"));
  EXPECT_THAT(*Itinerary::objectionTo(program, {{"OUT_A"}, 0}), HasSubstr("must form a loop"));
}

}  // namespace
}  // namespace cobot_command::cell
