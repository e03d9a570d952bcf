#include "cobot_command/rapid/source/encoding.h"

#include "tree_text.h"
#include <gmock/gmock.h>

#include "cobot_command/rapid/source/limits.h"
#include "cobot_command/rapid/source/source.h"

namespace cobot_command::rapid {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

const std::string kText =
    "MODULE m\n  ! gr\xC3\xBC\xC3\x9F"
    "e\nENDMODULE\n";

TEST(RapidEncoding, readsUtf8WithAndWithoutMark) {
  EXPECT_EQ(readSource(kText).encoding(), Encoding::Utf8);
  const Source marked = readSource("\xEF\xBB\xBF" + kText);
  EXPECT_EQ(marked.encoding(), Encoding::Utf8WithMark);
  EXPECT_EQ(marked.text(), kText);
}

TEST(RapidEncoding, readsIso8859WhereBytesAreNotUtf8) {
  const Source source = readSource(
      "MODULE m\n  ! gr\xFC\xDF"
      "e\nENDMODULE\n");
  EXPECT_EQ(source.encoding(), Encoding::Iso8859);
  EXPECT_EQ(source.text(), kText);
  EXPECT_THAT(source.findings(), IsEmpty());
}

TEST(RapidEncoding, readsUtf16InBothOrders) {
  for (const Encoding encoding : {Encoding::Utf16Little, Encoding::Utf16Big}) {
    const Source source = readSource(encoded(kText, encoding));
    EXPECT_EQ(source.encoding(), encoding);
    EXPECT_EQ(source.text(), kText);
    EXPECT_THAT(source.findings(), IsEmpty());
  }
}

TEST(RapidEncoding, writesTheBytesThatItHasRead) {
  const std::string beyond = kText + "! \xF0\x9F\xA6\xBE\xE2\x82\xAC\n";
  for (const Encoding encoding :
       {Encoding::Utf8, Encoding::Utf8WithMark, Encoding::Utf16Little, Encoding::Utf16Big}) {
    const std::string bytes = encoded(beyond, encoding);
    EXPECT_EQ(encoded(readSource(bytes).text(), encoding), bytes);
  }
  const std::string latin = encoded(kText, Encoding::Iso8859);
  EXPECT_EQ(encoded(readSource(latin).text(), Encoding::Iso8859), latin);
}

TEST(RapidEncoding, refusesADamagedFileWithByteOrderMark) {
  const std::string lone_surrogate("\xFF\xFE\x00\xD8", 4);
  for (const std::string& bytes :
       {std::string("\xEF\xBB\xBF\xFF"), std::string("\xFF\xFE\x41"), lone_surrogate}) {
    const Source source = readSource(bytes);
    EXPECT_THAT(idsAndPlaces(source), ElementsAre("E901 1:1"));
    EXPECT_THAT(source.findings().front().text, HasSubstr("cannot be read: it begins as UTF-"));
  }
}

TEST(RapidEncoding, refusesEncodedModules) {
  EXPECT_THAT(findingsOf(std::string("MODULE m\0 ENDMODULE", 19)), ElementsAre("E902 1:1"));
  EXPECT_THAT(findingsOf(std::string(4096, ' ') + std::string(1, '\0')), ElementsAre("E902 1:1"));
  EXPECT_THAT(findingsOf("\x01\x02\x03 some other letters that follow"), ElementsAre("E902 1:1"));
  EXPECT_THAT(findingsOf(encoded(std::string("a\0", 2), Encoding::Utf16Big)), ElementsAre("E902 1:1"));
}

TEST(RapidEncoding, readsATextWithFewControlCharacters) {
  EXPECT_THAT(findingsOf("MODULE m\f\n! one \x01 in twenty characters or more\nENDMODULE"), IsEmpty());
}

TEST(RapidEncoding, refusesALongFile) {
  std::string bytes(kMostFileBytes, ' ');
  EXPECT_THAT(findingsOf(bytes), IsEmpty());
  bytes += ' ';
  EXPECT_THAT(findingsOf(bytes), ElementsAre("E904 1:1"));
}

TEST(RapidEncoding, hasATreeWithoutText) {
  const Source source = Source::unreadable("no such file");
  EXPECT_THAT(idsAndPlaces(source), ElementsAre("E901 1:1"));
  EXPECT_EQ(source.findings().front().text, "cannot be read: no such file");
  EXPECT_TRUE(source.isBroken());
  EXPECT_EQ(treeText(source, Tree::kRoot), "File");
}

TEST(RapidEncoding, keepsTheLineEndsOfTheFirstLine) {
  EXPECT_EQ(readSource("a\nb\r\n").lineEnd(), LineEnd::Lf);
  EXPECT_EQ(readSource("a\r\nb\n").lineEnd(), LineEnd::CrLf);
  EXPECT_EQ(readSource("a\rb\n").lineEnd(), LineEnd::Cr);
  EXPECT_EQ(readSource("a").lineEnd(), LineEnd::Lf);
}

}  // namespace
}  // namespace cobot_command::rapid
