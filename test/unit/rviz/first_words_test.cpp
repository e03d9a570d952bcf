#include "preview/first_words.h"

#include <gtest/gtest.h>

namespace cobot_command::rviz_plugin {
namespace {

TEST(FirstWords, areTheFirstSentence) {
  EXPECT_EQ(firstWords("Target unreachable: no posture reaches the point"), "Target unreachable");
  EXPECT_EQ(firstWords("It is too far. Come closer"), "It is too far");
}

TEST(FirstWords, areAtMostEightyCharactersWhichMayHaveSeveralBytesEach) {
  std::string eighty;
  for (int i = 0; i < 80; ++i) eighty += "ü";
  EXPECT_EQ(firstWords(eighty), eighty);
  EXPECT_EQ(firstWords(eighty + "ß"), eighty + " ...");
}

}  // namespace
}  // namespace cobot_command::rviz_plugin
