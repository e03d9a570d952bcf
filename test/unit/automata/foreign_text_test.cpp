// What is wrong with a file of another program is told so that it can be shown, whatever bytes it has.
#include "foreign_bytes.h"
#include <gmock/gmock.h>

#include "cobot_command/automata/formats.h"

namespace cobot_command::automata {
namespace {

using test_support::foreignTexts;
using test_support::IsHarmless;

TEST(ForeignText, ofAProblemIsHarmlessInItsFault) {
  for (const std::string& text : foreignTexts()) {
    for (std::string file :
         {"#", "{\"#\": 1}", "{\"format\": \"#\"}", "{\"format\": \"cobot-automata\", \"version\": \"#\"}",
          "{\"format\": \"cobot-automata\", \"version\": 1, \"problems\": [{\"name\": \"#\"}]}",
          "{\"format\": \"cobot-automata\", \"version\": 1, \"problems\": [{\"events\": [{\"name\": \"#\"}, "
          "{\"name\": \"#\"}], "
          "\"automata\": [{\"kind\": \"#\", \"states\": [\"#\"]}]}]}"}) {
      for (std::size_t at = 0; (at = file.find('#', at)) != std::string::npos; at += text.size()) {
        file.replace(at, 1, text);
      }
      const auto problems = problemsFromJson(file);
      if (!problems) {
        EXPECT_THAT(problems.error(), IsHarmless());
      }
    }
    for (std::string file :
         {"<#>", "<#/>", "<Module Name=\"#\"/>", "<Module><#/></Module>",
          "<Module Name=\"a\"><EventDeclList><EventDecl Kind=\"#\" Name=\"#\"/></EventDeclList></Module>"}) {
      for (std::size_t at = 0; (at = file.find('#', at)) != std::string::npos; at += text.size()) {
        file.replace(at, 1, text);
      }
      const auto problem = problemFromWmod(file);
      if (!problem) {
        EXPECT_THAT(problem.error(), IsHarmless());
      }
    }
  }
}

}  // namespace
}  // namespace cobot_command::automata
