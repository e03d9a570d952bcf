// doc/cell.md shows the parameters of a cell as they are.
#include "settings_page.h"
#include <gmock/gmock.h>

#include "cobot_command/cell/program/parameters.h"

namespace cobot_command::cell {
namespace {

std::string tableOfParameters() {
  Parameters parameters;
  std::string table = "| parameter | default | values | meaning |\n|---|---|---|---|\n";
  for (const Setting& row : parameterTable(parameters)) {
    const SettingKind& kind = row.kind;
    const std::string values =
        kind.range.empty() ? allowedBy(kind) : test_support::withUnit(kind.range, kind.unit);
    table += "| `" + row.name + "` | " + test_support::withUnit(kind.show(), kind.unit) + " | " + values +
             " | " + row.meaning + " |\n";
  }
  return table;
}

TEST(ParameterPage, hasTheTableOfParameters) {
  EXPECT_THAT(test_support::pageAt("doc/cell.md"), testing::HasSubstr(tableOfParameters()))
      << "doc/cell.md has to have:\n"
      << tableOfParameters();
}

}  // namespace
}  // namespace cobot_command::cell
