// What is wrong with the file of a cell is told so that it can be shown, whatever bytes the file has.
#include <array>

#include "cell_texts.h"
#include "foreign_bytes.h"
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
  for (const std::string& text : foreignTexts()) {
    for (const char* const place : kPlaces) {
      const std::string whole = place;
      const std::size_t value = whole.find(": ") == std::string::npos ? 0 : whole.find(": ") + 2;
      expectHarmlessFaults(with(kExample, whole, whole.substr(0, value) + text), "cell.yaml");
      expectHarmlessFaults(with(kExample, whole, whole.substr(0, value) + '"' + text + '"'), "cell.yaml");
    }
    expectHarmlessFaults(text, text);
  }
}

}  // namespace
}  // namespace cobot_command::cell
