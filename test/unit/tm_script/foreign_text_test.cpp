// What is wrong with a script is told in a few lines that can be shown, whatever bytes the script has.
#include "foreign_bytes.h"
#include <gmock/gmock.h>

#include "cobot_command/tm_script/checker.h"

namespace cobot_command::tm_script {
namespace {

using test_support::foreignTexts;
using test_support::IsHarmless;

void expectHarmless(const std::string& text) {
  for (const Fault& fault : parse(text).faults) EXPECT_THAT(fault.reason, IsHarmless());
}

TEST(ForeignText, ofAScriptIsHarmlessInItsFaults) {
  for (const std::string& text : foreignTexts()) {
    for (std::string script :
         {"#", "# = 1", "int #", "f(#)", "a + # + b", "\"#", "/*#", "if #", "a[#]", "f(\"#\"", "'#"}) {
      script.replace(script.find('#'), 1, text);
      expectHarmless(script);
      EXPECT_THAT(faultOf(1, script).reason, IsHarmless());
    }
  }
}

TEST(ForeignText, ofALongLineIsCut) {
  expectHarmless("\"" + std::string(1000000, 'x') + "\" \"");
  EXPECT_LT(faultOf(1, std::string(1000000, 'x')).reason.size(), 1100U);
}

}  // namespace
}  // namespace cobot_command::tm_script
