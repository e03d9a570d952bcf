#include "cobot_command/tables/table_text.h"

#include "table_support.h"
#include <gmock/gmock.h>

namespace cobot_command::testing {
namespace {

using namespace tables;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

Result<TableFile, TextFault> ofFile(const std::string& text) {
  return readFile(text, kPayload);
}
/// The fault of a tool in a list; empty when there is none.
std::string faultOfTool(const std::string& text) {
  const auto tables = readLists({{text}, {}, {}}, kPayload);
  return tables ? "" : describe(tables.error());
}
std::string faultOfFile(const std::string& text) {
  const auto tables = ofFile(text);
  return tables ? "" : describe(tables.error());
}

TEST(TableLists, takeNamesNumbersAndBoth) {
  const auto tables = readLists({{"1=gripper", "2=0,0,150,0,0,90", "3=gripper:1,2,3,4,5,6"},
                                 {"4=table", "5=400,0,100,0,0,90"},
                                 {"6=2.5"}},
                                kPayload);
  ASSERT_TRUE(tables) << describe(tables.error());
  const Entries& all = tables->entries();
  EXPECT_EQ(*all.tools[1], (Tool{"gripper", std::nullopt, 0}));
  EXPECT_EQ(*all.tools[2], (Tool{"", at(0, 0, 150, 0, 0, 90), 0}));
  EXPECT_EQ(*all.tools[3], (Tool{"gripper", at(1, 2, 3, 4, 5, 6), 0}));
  EXPECT_EQ(*all.frames[4], (Frame{"table", std::nullopt, 0}));
  EXPECT_EQ(*all.frames[5], (Frame{"", at(400, 0, 100, 0, 0, 90), 0}));
  EXPECT_EQ(*all.loads[6], weighing(2.5));
}

TEST(TableLists, takeTheLoadOfAToolAndTheReferenceOfAFrameBehindAnAtWhateverTheOrder) {
  const auto tables =
      readLists({{"1=gripper@3", "2=1,2,3,4,5,6@3"}, {"2=1,0,0,0,0,0@9", "9=table"}, {"3=1"}}, kPayload);
  ASSERT_TRUE(tables) << describe(tables.error());
  EXPECT_EQ(tables->entries().tools[1]->load, 3);
  EXPECT_EQ(tables->entries().tools[2]->load, 3);
  EXPECT_EQ(tables->entries().frames[2]->reference, 9);
}

TEST(TableLists, takeALoadWithInertiaInKgMm2AndCentreInMm) {
  const auto tables = readLists({{}, {}, {"1=2,2000,1000,500,0,0,80,0,0,90"}}, kPayload);
  ASSERT_TRUE(tables) << describe(tables.error());
  const Load load = *tables->load(1);
  EXPECT_EQ(load.mass, 2);
  EXPECT_THAT(load.inertia,
              ElementsAre(::testing::DoubleEq(2e-3), ::testing::DoubleEq(1e-3), ::testing::DoubleEq(5e-4)));
  EXPECT_TRUE(load.centre.isApprox(at(0, 0, 80, 0, 0, 90)));
}

TEST(TableLists, takeBlanksBetweenTheParts) {
  const auto tables = readLists({{" 1 = left gripper : 1 , +2,3,\t4,5 , 6 @ 2 "}, {}, {"2=1"}}, kPayload);
  ASSERT_TRUE(tables) << describe(tables.error());
  EXPECT_EQ(*tables->entries().tools[1], (Tool{"left gripper", at(1, 2, 3, 4, 5, 6), 2}));
}

TEST(TableLists, takeAnyNameInQuotes) {
  const auto tables =
      readLists({{R"(1="a ""b"", c:d@e#f=":1,2,3,4,5,6)", R"(2="150")", R"(3=" x ")"}, {}, {}}, kPayload);
  ASSERT_TRUE(tables) << describe(tables.error());
  EXPECT_EQ(tables->entries().tools[1]->name, "a \"b\", c:d@e#f=");
  EXPECT_TRUE(tables->entries().tools[1]->pose);
  EXPECT_EQ(tables->entries().tools[2]->name, "150");
  EXPECT_EQ(tables->entries().tools[3]->name, " x ");
}

TEST(TableLists, sayWhereAnEntryDoesNotGoOn) {
  EXPECT_EQ(faultOfTool(""),
            "entry 1 of tools, \"\": at character 1: expected the number of the entry, a whole number");
  EXPECT_THAT(faultOfTool("x=1"), HasSubstr("at character 1: "));
  EXPECT_THAT(faultOfTool("3"), HasSubstr("at character 2: expected = after the number of the entry"));
  EXPECT_THAT(faultOfTool("3="), HasSubstr("at character 3: expected a name, numbers, or both"));
  EXPECT_THAT(faultOfTool("3=1,2,x,4,5,6"), HasSubstr("at character 7: expected a number"));
  EXPECT_THAT(faultOfTool("3=1,2,3,4,5,6,"), HasSubstr("at character 15: expected a number"));
  EXPECT_THAT(faultOfTool("3=1,2,3,4,5,6 7"), HasSubstr("at character 15: expected the end of the entry"));
  EXPECT_THAT(faultOfTool("3=a:"), HasSubstr("at character 5: expected a number"));
  EXPECT_THAT(faultOfTool("3=a@"), HasSubstr("at character 5: expected the number after @"));
  EXPECT_THAT(faultOfTool("3=a,b"), HasSubstr("must be in \""));
  EXPECT_THAT(faultOfTool("3=a # b"), HasSubstr("must be in \"")) << "comments are for files";
  EXPECT_THAT(faultOfTool("3=\"a"), HasSubstr("not closed"));
  EXPECT_THAT(faultOfTool("3=\"\""), HasSubstr("the name is empty"));
  EXPECT_THAT(faultOfTool("3=:1,2,3,4,5,6"), HasSubstr("at character 3: expected a name"));
}

TEST(TableLists, takeNoNumbersForANameWhenOneIsMissing) {
  EXPECT_THAT(faultOfTool("3=150"), HasSubstr("there are 1 numbers; a tool has six"));
  EXPECT_THAT(faultOfTool("3=1,2,3,4,5"), HasSubstr("there are 5 numbers"));
  EXPECT_THAT(faultOfTool("3=-1,2,3,4,5,6,7"), HasSubstr("there are 7 numbers"));
}

TEST(TableLists, sayWhatIsWrongWithANumber) {
  EXPECT_THAT(faultOfTool("0=1,2,3,4,5,6"), HasSubstr("tool 0 cannot be set; allowed: 1 to 15"));
  EXPECT_THAT(faultOfTool("16=1,2,3,4,5,6"), HasSubstr("tool 16 cannot be set"));
  EXPECT_THAT(faultOfTool("1=1,nan,3,4,5,6"), HasSubstr("coordinate 2 of the pose is nan"));
  EXPECT_THAT(faultOfTool("1=1,2,3,4,5,100001"), HasSubstr("coordinate 6 of the pose is 100001"));
  EXPECT_THAT(faultOfTool("1=1,2,3,4,5,6@4"), HasSubstr("its load 4 is not configured"));
}

TEST(TableLists, sayWhichEntryIsThereTwice) {
  const auto tables = readLists({{"1=a", "2=b", "1=c"}, {}, {}}, kPayload);
  EXPECT_EQ(describe(tables.error()), "entry 3 of tools, \"1=c\": tool 1 is in entry 1 of tools already");
}

TEST(TableLists, refuseNamesAndReferencesOfLoads) {
  const auto fault = [](const std::string& text) {
    const auto tables = readLists({{}, {}, {text}}, kPayload);
    return tables ? "" : describe(tables.error());
  };
  EXPECT_THAT(fault("1=heavy"), HasSubstr("a load has no name"));
  EXPECT_THAT(fault("1=1@2"), HasSubstr("a load cannot refer to another entry"));
  EXPECT_THAT(fault("1=1,2,3,4"), HasSubstr("there are 4 numbers; a load has"));
  EXPECT_THAT(fault("1=5"), HasSubstr("its mass is 5 kg; allowed: 0 to 4 kg, the payload of tm5-900"));
  EXPECT_THAT(fault("1=1,-1,0,0,0,0,0,0,0,0"), HasSubstr("a moment of inertia is -1 kg mm^2"));
}

TEST(TableFile, hasOneEntryALineAndComments) {
  const auto file = ofFile(
      "# our cell\r\n"
      "\n"
      "  tool 3=gripper:0,0,150,0,0,0@1   # the left one\n"
      "frame\t4 = \"a # b\"\r\n"
      "load 1=2.5#kg\n"
      "end 3 # of them\n"
      "   # the end, without a line end after it");
  ASSERT_TRUE(file) << describe(file.error());
  const DataTables& tables = file->tables;
  EXPECT_EQ(*tables.entries().tools[3], (Tool{"gripper", at(0, 0, 150), 1}));
  EXPECT_EQ(tables.entries().frames[4]->name, "a # b");
  EXPECT_EQ(tables.load(1)->mass, 2.5);
  EXPECT_TRUE(file->has_end);
}

TEST(TableFile, withoutEntriesSaysThatItHasNone) {
  for (const char* text : {"", "\n", "\n\n# nothing\n"}) {
    EXPECT_THAT(faultOfFile(text), HasSubstr("there is no entry: the file is truncated. Restore it from a "
                                             "copy; or, if its entries (0) are complete, make \"end 0\""))
        << text;
  }
  EXPECT_TRUE(ofFile("end 0"));
  EXPECT_TRUE(ofFile("# nothing\nbegin\n\nend 0\n"));
}

TEST(TableFile, asOlderOnesWereIsTakenWithoutItsLastLineAndSaysSo) {
  const auto file = ofFile("# Tools, frames and loads of cobot_command\nload 1=2\n");
  ASSERT_TRUE(file) << describe(file.error());
  EXPECT_FALSE(file->has_end);
  EXPECT_EQ(file->tables.load(1)->mass, 2);
  EXPECT_THAT(faultOfFile("load 1=2\nload 2=1"),
              HasSubstr("line 2, \"load 2=1\": it ends in the middle of this line: the file is truncated"));
}

TEST(TableFile, ofWhichAnythingIsCutIsRefused) {
  Entries entries;
  entries.tools[3] = Tool{"gripper", at(0, 0, 150, 0, 0, 90), 1};
  entries.frames[5] = Frame{"table", std::nullopt, 0};
  entries.loads[1] = weighing(2.5);
  for (const DataTables& tables : {*DataTables::of(entries, kPayload), DataTables()}) {
    const std::string text = toFile(tables);
    ASSERT_TRUE(ofFile(text));
    for (std::size_t size = 0; size + 1 < text.size(); ++size) {
      EXPECT_FALSE(ofFile(text.substr(0, size))) << text.substr(0, size);
    }
    EXPECT_TRUE(ofFile(text.substr(0, text.size() - 1))) << "nothing is missing but the end of the last line";
  }
}

TEST(TableFile, ofWhichAnyLineIsLostIsRefused) {
  EXPECT_THAT(
      faultOfFile("begin\nload 1=2\nend 2\n"),
      HasSubstr(
          "line 3, \"end 2\": the number of entries before it is not this, but 1: the file is truncated"));
  EXPECT_THAT(faultOfFile("begin\nload 1=2\n"),
              HasSubstr("line 2, \"load 1=2\": after it the line \"end N\" is missing"));
  EXPECT_THAT(faultOfFile("begin\n"), HasSubstr("make \"end 0\" its last line"));
}

TEST(TableFile, hasItsBeginAndItsEndInTheirPlaces) {
  EXPECT_THAT(faultOfFile("load 1=2\nbegin\nend 1\n"), HasSubstr("\"begin\" must occur once, before all"));
  EXPECT_THAT(faultOfFile("begin\nbegin\nend 0\n"), HasSubstr("\"begin\" must occur once"));
  EXPECT_THAT(faultOfFile("begin 2\nend 0\n"), HasSubstr("nothing may follow \"begin\""));
  EXPECT_THAT(faultOfFile("end 0\nload 1=2\n"), HasSubstr("entries must be before the line \"end\""));
  EXPECT_THAT(faultOfFile("end 0\nend 0\n"), HasSubstr("only comments may follow the line \"end\""));
  for (const char* end : {"end\n", "end x\n", "end -1\n", "end 0 0\n", "end 99999999999999999999\n"}) {
    EXPECT_THAT(faultOfFile(end), HasSubstr("\"end\" must be followed by the number of the entries, here 0"))
        << end;
  }
}

TEST(TableFile, saysInWhichLineItIsWrong) {
  EXPECT_EQ(faultOfFile("load 1=2\ntol 3=gripper\n"),
            "line 2, \"tol 3=gripper\": a line begins with tool, frame, load, begin, end or #");
  EXPECT_THAT(faultOfFile("tool3=gripper"), HasSubstr("a line begins with tool"));
  EXPECT_THAT(faultOfFile("\n\ntool 3=1,2,x,4,5,6"),
              HasSubstr("line 3, \"tool 3=1,2,x,4,5,6\": at character 12:"));
  EXPECT_THAT(faultOfFile("load 1=2\nload 2=9\nend 2\n"),
              HasSubstr("line 2, \"load 2=9\": load 2: its mass is 9 kg"));
  EXPECT_THAT(faultOfFile("frame 2=1,0,0,0,0,0@1\nframe 1=1,0,0,0,0,0@3\nframe 3=x\n"), HasSubstr("line 2"));
  EXPECT_THAT(faultOfFile("tool 1=a\ntool 1=b\n"),
              HasSubstr("line 2, \"tool 1=b\": tool 1 is in line 1 already"));
}

TEST(TableFile, showsForeignTextWithoutHarm) {
  const std::string fault = faultOfFile("\x1B[2J" + std::string(1000, 'x'));
  EXPECT_EQ(fault.find('\x1B'), std::string::npos);
  EXPECT_LT(fault.size(), 300);
}

TEST(TableFile, isWrittenAsOneWouldTypeIt) {
  Entries entries;
  entries.tools[3] = Tool{"gripper", at(0, 0, 150, 0, 0, 90), 1};
  entries.tools[4] = Tool{"", at(0.5, -12.25, 1e5), 0};
  entries.tools[15] = Tool{"4 \"jaws\"", std::nullopt, 0};
  entries.frames[2] = Frame{"", at(400, 0, 100, 180), 5};
  entries.frames[5] = Frame{"table", std::nullopt, 0};
  entries.loads[1] = weighing(2.5);
  entries.loads[2] = Load{1, {2e-3, 1e-3, 5e-4}, at(0, 0, 80)};
  const std::string text = toFile(*DataTables::of(entries, kPayload));
  EXPECT_THAT(text, ::testing::StartsWith("# "));
  EXPECT_THAT(text, ::testing::EndsWith("tool 3=gripper:0,0,150,0,0,90@1\n"
                                        "tool 4=0.5,-12.25,100000,0,0,0\n"
                                        "tool 15=\"4 \"\"jaws\"\"\"\n"
                                        "frame 2=400,0,100,180,0,0@5\n"
                                        "frame 5=table\n"
                                        "load 1=2.5\n"
                                        "load 2=1,2000,1000,500,0,0,80,0,0,0\n"
                                        "end 7\n"));
}

TEST(TableFile, hasNoEntriesWhereNothingIsConfigured) {
  EXPECT_THAT(toFile(DataTables()), ::testing::EndsWith("\nbegin\nend 0\n"));
}

}  // namespace
}  // namespace cobot_command::testing
