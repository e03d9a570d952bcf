#include "cobot_command/common/foreign_text.h"

#include <algorithm>

#include "foreign_bytes.h"
#include <gmock/gmock.h>
#ifdef COBOT_HAS_RAPIDCHECK
#include <rapidcheck/gtest.h>
#endif

namespace cobot_command {
namespace {

#ifdef COBOT_HAS_RAPIDCHECK
using Bytes = std::string;

rc::Gen<Bytes> anyBytes() {
  const auto piece = rc::gen::oneOf(
      rc::gen::element<Bytes>("\xE9\x81\x94", "\xF0\x9F\xA4\x96", "\xC2\x85", "\xE2\x80\xA8", "\xE2\x80\xAE",
                              "\xC0\xAF", "\xED\xA0\x80", "\xF4\x90\x80\x80", "\r\n", "\x1B[2J", "..."),
      rc::gen::map(rc::gen::arbitrary<char>(), [](char c) { return Bytes(1, c); }));
  return rc::gen::map(rc::gen::container<std::vector<Bytes>>(piece), [](const std::vector<Bytes>& pieces) {
    Bytes all;
    for (const Bytes& one : pieces) all += one;
    return all;
  });
}

bool hasControlCharacters(const Bytes& text) {
  return std::any_of(text.begin(), text.end(),
                     [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7F; });
}

RC_GTEST_PROP(ForeignTextProperty, isBoundedAndUtf8AndHasNoControlCharacters, ()) {
  const Bytes bytes = *anyBytes();
  const auto limit = *rc::gen::inRange<std::size_t>(0, 100);
  const std::string text = foreignText(bytes, limit);
  RC_ASSERT(text.size() <= limit + 3);
  RC_ASSERT(isUtf8(text));
  RC_ASSERT(!hasControlCharacters(text));
}

RC_GTEST_PROP(ForeignTextProperty, isTheBeginningOfTheWholeEscapedText, ()) {
  const Bytes bytes = *anyBytes();
  const auto limit = *rc::gen::inRange<std::size_t>(0, 100);
  const std::string text = foreignText(bytes, limit);
  const std::string whole = escaped(bytes);
  if (whole.size() <= limit) {
    RC_ASSERT(text == whole);
  } else {
    RC_ASSERT(text.substr(text.size() - 3) == "...");
    RC_ASSERT(whole.compare(0, text.size() - 3, text, 0, text.size() - 3) == 0);
  }
}

RC_GTEST_PROP(EscapedProperty, isUtf8WithoutControlCharactersAndEscapedForGood, ()) {
  const Bytes bytes = *anyBytes();
  const std::string text = escaped(bytes);
  RC_ASSERT(isUtf8(text));
  RC_ASSERT(!hasControlCharacters(text));
  RC_ASSERT(escaped(text) == text);
  RC_ASSERT(text.size() <= 4 * bytes.size());
}

RC_GTEST_PROP(ForPeopleProperty, isWhatIsEscaped, ()) {
  const Bytes bytes = *anyBytes();
  RC_ASSERT(forPeople(bytes) == escaped(bytes));
}
#endif

TEST(ForPeople, doesNoHarmWhateverTheBytesAre) {
  for (const std::string& bytes : test_support::foreignTexts()) {
    EXPECT_THAT(forPeople(bytes), test_support::IsHarmless());
    EXPECT_THAT(foreignText(bytes), test_support::IsHarmless());
  }
}

TEST(Escaped, leavesTextAlone) {
  EXPECT_EQ(escaped("1,ChangeBase(\"\u9054\u660e\")"), "1,ChangeBase(\"\u9054\u660e\")");
}

TEST(Escaped, showsControlCharacters) {
  EXPECT_EQ(escaped(std::string_view("a\r\n\t\0\x1B\x7F", 7)), "a\\r\\n\\t\\x00\\x1B\\x7F");
}

TEST(Escaped, showsBytesThatAreNotUtf8) {
  EXPECT_EQ(escaped("\xC8 \xE9\x81 \xC0\xAF"), "\\xC8 \\xE9\\x81 \\xC0\\xAF");
}

TEST(Escaped, showsWhatSteersALineOrItsDirection) {
  EXPECT_EQ(escaped("a\u0085b\u2028c\u202Ed\uFEFF"),
            "a\\xC2\\x85b\\xE2\\x80\\xA8c\\xE2\\x80\\xAEd\\xEF\\xBB\\xBF");
}

TEST(ForeignText, isCutBetweenCharactersAndSaysSo) {
  EXPECT_EQ(foreignText("abcdef", 6), "abcdef");
  EXPECT_EQ(foreignText("abcdefg", 6), "abcdef...");
  EXPECT_EQ(foreignText("ab\u9054", 4), "ab...");
  EXPECT_EQ(foreignText("abc\n", 4), "abc...");
  EXPECT_EQ(foreignText(std::string(1000000, 'x')).size(), kForeignTextLimit + 3);
}

TEST(Utf8, isToldFromOtherBytes) {
  EXPECT_TRUE(isUtf8(""));
  EXPECT_TRUE(isUtf8("\u9054\u660e"));
  EXPECT_FALSE(isUtf8("\xC0\xAF"));
  EXPECT_FALSE(isUtf8("\xED\xA0\x80"));
  EXPECT_FALSE(isUtf8("abc\xE9\x81"));
}

}  // namespace
}  // namespace cobot_command
