// What is wrong with the file of a cell is told so that it can be shown, whatever bytes the file has.
#include <array>
#include <string>
#include <vector>

#include "cell_texts.h"
#include "foreign_bytes.h"
#include "thorough.h"
#include <gmock/gmock.h>

namespace cobot_command::cell {
namespace {

using test_support::foreignTexts;
using test_support::IsHarmless;

void expectHarmlessFaults(const std::string& file, const std::string& name) {
  const auto cell = parseCell(file, name, readTestFile);
  if (cell) return;
  for (const Fault& fault : cell.error()) {
    for (const std::string& part :
         {describe(fault), fault.file, fault.field, fault.found, fault.allowed, fault.advice}) {
      EXPECT_THAT(part, IsHarmless());
    }
  }
}

TEST(ForeignText, ofACellFileIsHarmlessInItsFaults) {
  constexpr std::array<const char*, 9> kPlaces{"handover", "tm5-900", "namespace: RA",         "home: HOME",
                                               "path: T1", "to: T1",  "movement_command: PTP", "speed: 30",
                                               "stations:"};
  const std::vector<std::string> texts = foreignTexts();
  for (std::size_t first = 0; first < kPlaces.size(); ++first) {
    // When watched, each place has other ones.
    for (std::size_t i = first % testing::strideWhenWatched(); i < texts.size();
         i += testing::strideWhenWatched()) {
      const std::string& text = texts[i];
      const std::string whole = kPlaces.at(first);
      const std::size_t value = whole.find(": ") == std::string::npos ? 0 : whole.find(": ") + 2;
      expectHarmlessFaults(with(kExample, whole, whole.substr(0, value) + text), "cell.yaml");
      expectHarmlessFaults(with(kExample, whole, whole.substr(0, value) + '"' + text + '"'), "cell.yaml");
    }
  }
  for (const std::string& text : texts) expectHarmlessFaults(text, text);
}

}  // namespace
}  // namespace cobot_command::cell
