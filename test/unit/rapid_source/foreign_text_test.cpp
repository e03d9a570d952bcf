// What is quoted from a file is bounded and does no harm to a terminal.
#include "cobot_command/common/foreign_text.h"

#include "tree_text.h"
#include <gmock/gmock.h>

namespace cobot_command::rapid {
namespace {

TEST(RapidForeignText, isEscapedAndBoundedInFindings) {
  const std::string long_name(100000, 'n');
  for (const std::string& text :
       {inRoutine("a:=1\x1B[31m;"), inRoutine("s:=\"\\\x1B\x07\";"), inRoutine(long_name + ";"),
        inRoutine("a:=" + std::string(100000, '1') + "x;"), std::string("MODULE m ENDMODULE \"\x1B[2J\""),
        inRoutine("GOTO \"\x07\";"), "MODULE m(" + long_name + ") ENDMODULE",
        "MODULE m\nPERS num " + long_name + ";\nENDMODULE", inRoutine("a:=1 \xC2\xA0\xE2\x80\xAE;")}) {
    const Source source = readSource(text);
    ASSERT_FALSE(source.findings().empty());
    for (const Finding& finding : source.findings()) {
      EXPECT_LT(finding.text.size(), 200U);
      EXPECT_EQ(finding.text, escaped(finding.text));
    }
  }
}

TEST(RapidForeignText, isEscapedInTheNameOfTheFile) {
  const Source source = readSource(inRoutine("a:=1"));
  const std::string line = describe(source, source.findings().front(), "\x1B[31m.mod");
  EXPECT_EQ(line, escaped(line));
  EXPECT_EQ(line.rfind("\\x1B[31m.mod:3:5", 0), 0U);
}

TEST(RapidForeignText, isBoundedInTheReasonOfAnUnreadableFile) {
  const Source source = Source::unreadable(std::string(1000, '\x1B'));
  EXPECT_LT(source.findings().front().text.size(), 500U);
}

}  // namespace
}  // namespace cobot_command::rapid
