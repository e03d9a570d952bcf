// What is wrong with tables is told so that it can be shown, whatever bytes parameters, files and clients
// have.
#include "foreign_bytes.h"
#include "table_support.h"
#include <gmock/gmock.h>

#include "cobot_command/tables/table_text.h"

namespace cobot_command::testing {
namespace {

using namespace tables;

TEST(ForeignText, ofListsAndFilesIsHarmlessInTheirFaults) {
  for (const std::string& text : test_support::foreignTexts()) {
    for (std::string entry : {"#", "1=#", "1=a:#", "1=\"#", "#=a", "1=a@#"}) {
      entry.replace(entry.find('#'), 1, text);
      for (const TableLists& lists :
           {TableLists{{entry}, {}, {}}, TableLists{{}, {entry}, {}}, TableLists{{}, {}, {entry}}}) {
        const auto tables = readLists(lists, kPayload);
        if (!tables) {
          EXPECT_THAT(describe(tables.error()), test_support::IsHarmless());
        }
      }
      for (const std::string& file :
           {entry, "tool " + entry + "\nend 1\n", "load " + entry + '\n', "end " + entry}) {
        const auto tables = readFile(file, kPayload);
        if (!tables) {
          EXPECT_THAT(describe(tables.error()), test_support::IsHarmless());
        }
      }
    }
  }
}

TEST(ForeignText, ofWritesIsHarmlessInTheirRefusals) {
  for (const std::string& text : test_support::foreignTexts()) {
    DataTables tables;
    const std::string long_text = text + std::string(300, 'x');
    for (const std::string& name : {text, long_text}) {
      if (const auto refused = tables.writeTool(1, Tool{name, std::nullopt, 9}, kPayload)) {
        EXPECT_THAT(describe(*refused), test_support::IsHarmless());
      }
      if (const auto refused = tables.writeFrame(1, Frame{name, std::nullopt, 9}, kPayload)) {
        EXPECT_THAT(describe(*refused), test_support::IsHarmless());
      }
    }
  }
}

}  // namespace
}  // namespace cobot_command::testing
