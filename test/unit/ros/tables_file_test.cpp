// The file that keeps the tables, and the parameters that name it.

#include "tables/tables_file.h"

#include <string>
#include <system_error>

#include "own_folder.h"
#include <gmock/gmock.h>

#include "cobot_command/ros/command/command_parameters.h"

namespace cobot_command::ros_adapter {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// As the system says it, in the language of the process.
std::string noSuchFile() {
  return std::make_error_code(std::errc::no_such_file_or_directory).message();
}

TEST(TablesFile, isNothingBeforeItIsThere) {
  const OwnFolder folder;
  const auto read = readTablesFile(folder.file("tables"));
  ASSERT_TRUE(read);
  EXPECT_FALSE(*read);
}

TEST(TablesFile, isReplacedAsAWholeAndLeavesNothingBeside) {
  const OwnFolder folder;
  const std::string path = folder.file("tables");
  EXPECT_EQ(writeTablesFile(path, "a long text of before"), std::nullopt);
  EXPECT_EQ(writeTablesFile(path, "new"), std::nullopt);
  EXPECT_EQ(**readTablesFile(path), "new");
  EXPECT_EQ(folder.count(), 1);
}

TEST(TablesFile, keepsItsRightsAndWhatALinkLeadsTo) {
  namespace fs = std::filesystem;
  const OwnFolder folder;
  const std::string path = folder.file("tables", "old");
  fs::permissions(path, fs::perms::owner_read | fs::perms::owner_write);
  fs::create_symlink(path, folder.file("link"));
  EXPECT_EQ(writeTablesFile(folder.file("link"), "new"), std::nullopt);
  EXPECT_TRUE(fs::is_symlink(folder.file("link")));
  EXPECT_EQ(folder.content("tables"), "new");
  EXPECT_EQ(fs::status(path).permissions(), fs::perms::owner_read | fs::perms::owner_write);
}

TEST(TablesFile, staysAsItIsWhenItCannotBeWritten) {
  const OwnFolder folder;
  const std::string path = folder.file("tables", "old");
  std::filesystem::create_directory(folder.file("tables.new"));  // in the way of the new one
  EXPECT_THAT(*writeTablesFile(path, "new"), HasSubstr("tables.new cannot be written: "));
  EXPECT_THAT(*whyNotWritable(path), HasSubstr("tables.new cannot be written: "));
  EXPECT_EQ(folder.content("tables"), "old");
}

TEST(TablesFile, canNotBeInAFolderThatIsNotThere) {
  const OwnFolder folder;
  EXPECT_THAT(*whyNotWritable(folder.file("no/tables")), HasSubstr(noSuchFile()));
  EXPECT_EQ(whyNotWritable(folder.file("tables")), std::nullopt);
  EXPECT_EQ(folder.count(), 0) << "it was only tried";
}

TEST(TablesFile, sayWhatThereIsInItsPlace) {
  const OwnFolder folder;
  std::filesystem::create_directory(folder.file("tables"));
  EXPECT_EQ(readTablesFile(folder.file("tables")).error(), "it is a folder");
  std::filesystem::create_symlink(folder.file("gone"), folder.file("link"));
  EXPECT_EQ(readTablesFile(folder.file("link")).error(), "it is a link to a file that does not exist");
  EXPECT_THAT(readTablesFile(folder.file("large", std::string(2000000, '#'))).error(), HasSubstr("larger"));
}

GivenParameters given(GivenValues values) {
  values.emplace("robot_model", Given{"tm5-900"});
  return {"/node", std::move(values), std::nullopt};
}
std::string refusal(GivenValues values) {
  const auto parameters = readCommandParameters(given(std::move(values)));
  return parameters ? "" : parameters.error().message;
}

const GivenValues kLists{{"tools", {GivenList{{"3=gripper:0,0,150,0,0,0@1"}}}},
                         {"frames", {GivenList{{"2=1,0,0,0,0,0@4"}, {"4=table"}}}},
                         {"loads", {GivenList{{"1=2.5"}}}}};

TEST(TableParameters, areListsOfEntries) {
  const auto parameters = readCommandParameters(given(kLists));
  ASSERT_TRUE(parameters) << parameters.error().message;
  const tables::Entries& all = parameters->tables.tables.entries();
  EXPECT_EQ(all.tools[3]->name, "gripper");
  EXPECT_EQ(all.frames[2]->reference, 4);
  EXPECT_EQ(all.loads[1]->mass, 2.5);
  EXPECT_THAT(parameters->warnings, IsEmpty());
}

TEST(TableParameters, areRefusedWithTheEntryAndTheReason) {
  EXPECT_THAT(refusal({{"tools", {GivenList{{"1=a"}, {"2=1,2,x"}}}}}),
              HasSubstr("parameter /node/tools holds \"2=1,2,x\": at character 7: expected a number; "
                        "allowed: a list of texts N=NAME, "));
  EXPECT_THAT(
      refusal({{"frames", {GivenList{{"1=1,0,0,0,0,0@2"}}}}}),
      HasSubstr("parameter /node/frames holds \"1=1,0,0,0,0,0@2\": frame 1: its reference, frame 2, is "
                "not configured"));
  EXPECT_THAT(
      refusal({{"loads", {GivenList{{"1=5"}}}}}),
      HasSubstr("parameter /node/loads holds \"1=5\": load 1: its mass is 5 kg; allowed: 0 to 4 kg, the "
                "payload of tm5-900"));
}

TEST(TableParameters, areOfTheFirstStartUntilThereIsAFile) {
  const OwnFolder folder;
  GivenValues values = kLists;
  values.emplace("tables_file", Given{folder.file("tables")});
  const auto first = readCommandParameters(given(values));
  ASSERT_TRUE(first) << first.error().message;
  EXPECT_TRUE(first->tables.tables.entries().tools[3]);
  EXPECT_EQ(folder.count(), 0) << "the first write makes it";
  folder.file("tables", "tool 5=other\nend 1\n");
  const auto second = readCommandParameters(given(values));
  ASSERT_TRUE(second) << second.error().message;
  EXPECT_FALSE(second->tables.tables.entries().tools[3]);
  EXPECT_TRUE(second->tables.tables.entries().tools[5]);
  EXPECT_THAT(second->warnings,
              ElementsAre(HasSubstr("and the parameters ~tools, ~frames and ~loads differ")));
}

TEST(TableParameters, areNotWarnedOfWhenTheFileHasTheSame) {
  const OwnFolder folder;
  GivenValues values = kLists;
  const std::string path = folder.file(
      "tables", "load 1=2.5\ntool 3=gripper:0,0,150,0,0,0@1\nframe 4=table\nframe 2=1,0,0,0,0,0@4\nend 4");
  values.emplace("tables_file", Given{path});
  const auto parameters = readCommandParameters(given(values));
  ASSERT_TRUE(parameters) << parameters.error().message;
  EXPECT_THAT(parameters->warnings, IsEmpty());
}

TEST(TableParameters, takeAFileWithoutItsLastLineOnceAndWriteItAnew) {
  const OwnFolder folder;
  const std::string path = folder.file("tables", "load 1=2.5\ntool 3=gripper@1\n");
  const GivenValues values{{"tables_file", Given{path}}};
  const auto first = readCommandParameters(given(values));
  ASSERT_TRUE(first) << first.error().message;
  EXPECT_THAT(first->warnings, ElementsAre(AllOf(HasSubstr(path), HasSubstr("rewritten with that line"))));
  EXPECT_THAT(**readTablesFile(path), EndsWith("begin\ntool 3=gripper@1\nload 1=2.5\nend 2\n"));
  const auto second = readCommandParameters(given(values));
  ASSERT_TRUE(second) << second.error().message;
  EXPECT_THAT(second->warnings, IsEmpty());
  EXPECT_EQ(second->tables.tables.entries().tools[3]->name, "gripper");
}

TEST(TableParameters, areRefusedWithAFileOfWhichAnythingIsMissing) {
  const OwnFolder folder;
  const auto with = [&](const std::string& text) {
    return refusal({{"tables_file", Given{folder.file("tables", text)}}});
  };
  EXPECT_THAT(with(""),
              AllOf(HasSubstr("tables_file is "), HasSubstr("there is no entry: the file is truncated")));
  EXPECT_THAT(with("begin\ntool 3=gripper\n"),
              HasSubstr("the line \"end N\" is missing: the file is truncated"));
  EXPECT_EQ(**readTablesFile(folder.file("tables")), "begin\ntool 3=gripper\n") << "it stays as it is";
}

TEST(TableParameters, nameAFileThatCanBeReadAndWritten) {
  const OwnFolder folder;
  const auto file = [](const std::string& path) { return refusal({{"tables_file", Given{path}}}); };
  EXPECT_THAT(file("tables"), HasSubstr("tables_file is the text \"tables\"; allowed: an absolute path"));
  EXPECT_THAT(file("/tmp/"), HasSubstr("allowed: an absolute path"));
  EXPECT_THAT(file(folder.file("no/tables")), HasSubstr("no/tables: "));
  EXPECT_THAT(file(folder.file("no/tables")), HasSubstr("cannot be written: " + noSuchFile() + "; allowed"));
  EXPECT_THAT(file(folder.file("wrong", "load 1=2\ntool 1=1,2\n")),
              HasSubstr("wrong: line 2, \"tool 1=1,2\": there are 2 numbers; a tool has six"));
  std::filesystem::create_directory(folder.file("folder"));
  EXPECT_THAT(file(folder.file("folder")), HasSubstr("folder: it is a folder; allowed: a tables file"));
}

}  // namespace
}  // namespace cobot_command::ros_adapter
