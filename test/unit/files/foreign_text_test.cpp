// What is wrong with a file is told so that it can be shown, whatever bytes the file, and its name, have.
#include "cobot_command/common/foreign_text.h"

#include "foreign_bytes.h"
#include <gmock/gmock.h>

#include "cobot_command/files/steps/steps_file.h"

namespace cobot_command::files {
namespace {

using test_support::foreignTexts;
using test_support::IsHarmless;

TEST(ForeignText, ofAFileOfStepsIsHarmlessInItsFaults) {
  for (const std::string& text : foreignTexts()) {
    for (std::string file :
         {"#", "#: 1", "dwell: #", "dwell: \"#\"", "dwell: 1\nsteps:\n  - {movement_command: \"#\"}",
          "dwell: 1\nsteps:\n  - {\"#\": 1}", "dwell: 1\nsteps:\n  - {name: \"#\", name: 1}",
          "dwell: 1\nsteps:\n  - *#", "steps: [!# 1]"}) {
      file.replace(file.find('#'), 1, text);
      const auto steps = readSteps(file, foreignText(text));
      if (steps) continue;
      EXPECT_THAT(describe(steps.error()), IsHarmless());
      for (const std::string& part : {steps.error().finding.field, steps.error().finding.found,
                                      steps.error().finding.allowed, steps.error().finding.advice}) {
        EXPECT_THAT(part, IsHarmless());
      }
    }
  }
}

}  // namespace
}  // namespace cobot_command::files
