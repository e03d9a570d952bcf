// The program rapid as a user calls it, through the shell.
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>

#include "own_folder.h"
#include "source_tree.h"
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>
#include <sys/stat.h>
#include <sys/wait.h>

namespace {

using cobot_command::ros_adapter::OwnFolder;
using cobot_command::test_support::inSourceTree;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

const std::string kLoose = "module m proc p() a:=1; endproc endmodule";
const std::string kCanonical = "MODULE m\n\n  PROC p()\n    a:=1;\n  ENDPROC\nENDMODULE\n";

struct Outcome {
  int status = -1;
  std::string output;  ///< of standard output and standard error
};

/// `rapid ARGUMENTS`, a command line of the shell.
Outcome run(const std::string& arguments, const std::string& before = "") {
  Outcome outcome;
  FILE* pipe = popen((before + "'" RAPID "' " + arguments + " 2>&1").c_str(), "r");
  if (pipe == nullptr) return outcome;
  char block[4096];
  for (std::size_t size = 0; (size = fread(block, 1, sizeof(block), pipe)) > 0;) {
    outcome.output.append(block, size);
  }
  const int status = pclose(pipe);
  outcome.status = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  return outcome;
}

mode_t modeOf(const std::string& file) {
  struct stat about {};
  return stat(file.c_str(), &about) == 0 ? about.st_mode & 07777U : 0;
}

TEST(Rapid, printsTheCanonicalForm) {
  const Outcome outcome = run("format " + inSourceTree("test/data/rapid/16_format_in.mod") + " | diff - " +
                              inSourceTree("test/data/rapid/16_format_out.mod"));
  EXPECT_EQ(outcome.status, 0);
  EXPECT_THAT(outcome.output, IsEmpty());
}

TEST(Rapid, formatsStandardInput) {
  const Outcome outcome = run("format -", "printf '" + kLoose + "' | ");
  EXPECT_EQ(outcome.status, 0);
  EXPECT_EQ(outcome.output, kCanonical);
}

TEST(Rapid, leavesTheFileUnlessItIsAskedToWrite) {
  const OwnFolder folder;
  const std::string file = folder.file("a.mod", kLoose);
  EXPECT_EQ(run("format " + file).output, kCanonical);
  EXPECT_EQ(folder.content("a.mod"), kLoose);
}

TEST(Rapid, replacesTheFileAndKeepsItsMode) {
  const OwnFolder folder;
  const std::string file = folder.file("a.mod", kLoose);
  ASSERT_EQ(chmod(file.c_str(), 0640), 0);
  const Outcome outcome = run("format --write " + file);
  EXPECT_EQ(outcome.status, 0);
  EXPECT_THAT(outcome.output, IsEmpty());
  EXPECT_EQ(folder.content("a.mod"), kCanonical);
  EXPECT_EQ(modeOf(file), 0640U);
  EXPECT_EQ(folder.count(), 1);
}

TEST(Rapid, writesThroughALink) {
  const OwnFolder folder;
  const std::string file = folder.file("a.mod", kLoose);
  std::filesystem::create_symlink(file, folder.file("link.mod"));
  EXPECT_EQ(run("format --write " + folder.file("link.mod")).status, 0);
  EXPECT_TRUE(std::filesystem::is_symlink(folder.file("link.mod")));
  EXPECT_EQ(folder.content("a.mod"), kCanonical);
}

TEST(Rapid, leavesACanonicalFileUntouched) {
  const OwnFolder folder;
  const std::string file = folder.file("a.mod", kCanonical);
  const auto before = std::filesystem::last_write_time(file);
  struct stat about {};
  ASSERT_EQ(stat(file.c_str(), &about), 0);
  EXPECT_EQ(run("format --write " + file).status, 0);
  struct stat again {};
  ASSERT_EQ(stat(file.c_str(), &again), 0);
  EXPECT_EQ(std::filesystem::last_write_time(file), before);
  EXPECT_EQ(again.st_ino, about.st_ino);
}

TEST(Rapid, keepsTheEncodingAndTheLineEnds) {
  const OwnFolder folder;
  const std::string file = folder.file("a.mod",
                                       "module m ! gr\xFC\xDF"
                                       "e\r\nendmodule");
  EXPECT_EQ(run("format --write " + file).status, 0);
  EXPECT_EQ(folder.content("a.mod"),
            "MODULE m ! gr\xFC\xDF"
            "e\r\nENDMODULE\r\n");
}

TEST(Rapid, leavesTheOldFileIfTheNewOneCannotBeWritten) {
  const OwnFolder folder;
  const std::string file = folder.file("a.mod", kLoose);
  // The limit lets no byte be written; the signal that comes with it is ignored, as on a full disk.
  const Outcome outcome = run("format --write " + file, "trap '' XFSZ; ulimit -f 0; ");
  EXPECT_EQ(outcome.status, 1);
  EXPECT_THAT(outcome.output, HasSubstr("a.mod cannot be written: "));
  EXPECT_EQ(folder.content("a.mod"), kLoose);
  EXPECT_EQ(folder.count(), 1);
}

TEST(Rapid, reportsWhereAFileIsNotCanonical) {
  const OwnFolder folder;
  const std::string loose = folder.file("a.mod", "MODULE m\n  VAR num  a;\nENDMODULE\n");
  const Outcome outcome = run("format --check " + loose);
  EXPECT_EQ(outcome.status, 1);
  EXPECT_THAT(outcome.output,
              HasSubstr("a.mod:2:11: not in canonical form; rapid format --write makes it so"));
  const Outcome canonical = run("format --check " + folder.file("b.mod", kCanonical));
  EXPECT_EQ(canonical.status, 0);
  EXPECT_THAT(canonical.output, IsEmpty());
}

TEST(Rapid, showsTheLinesOfErrorsAndWritesNothing) {
  const OwnFolder folder;
  const std::string broken = "MODULE m\n\tPROC p()\n\ta:=1\nENDPROC\nENDMODULE\n";
  const std::string file = folder.file("a.mod", broken);
  const Outcome outcome = run("format --write " + file);
  EXPECT_EQ(outcome.status, 1);
  EXPECT_THAT(outcome.output, HasSubstr("a.mod:3:6: error E202: ';' is missing\n\\ta:=1\n      ^\n"));
  EXPECT_EQ(folder.content("a.mod"), broken);
}

TEST(Rapid, showsTheSurroundingsOfAnErrorInALongLine) {
  const OwnFolder folder;
  const std::string file =
      folder.file("a.mod", "MODULE m VAR num a:=[" + std::string(5000, '1') + "x]; ENDMODULE");
  const Outcome outcome = run("format " + file);
  EXPECT_EQ(outcome.status, 1);
  EXPECT_THAT(outcome.output, HasSubstr("a.mod:1:22: error E106: '1111"));
  EXPECT_LT(outcome.output.size(), 500U);
}

TEST(Rapid, readsTheDialectThatIsNamed) {
  const OwnFolder folder;
  const std::string file = folder.file("a.mod", "MODULE m\n  TASK PERS num a:=1;\nENDMODULE\n");
  EXPECT_EQ(run("format --check " + file).status, 0);
  const Outcome outcome = run("format --check --dialect s4c " + file);
  EXPECT_EQ(outcome.status, 1);
  EXPECT_THAT(outcome.output, HasSubstr("E801: TASK PERS is not in s4c"));
}

TEST(Rapid, refusesFilesThatCannotBeRead) {
  EXPECT_THAT(run("format /nowhere/a.mod").output,
              HasSubstr("/nowhere/a.mod:1:1: error E901: cannot be read: No such file or directory"));
  EXPECT_THAT(run("format /tmp").output, HasSubstr("E901: cannot be read: Is a directory"));
  EXPECT_THAT(run("format /dev/zero").output, HasSubstr("E904: longer than 16 MiB"));
  EXPECT_EQ(run("format /dev/zero").status, 1);
}

TEST(Rapid, endsWithTwoOnBadUsage) {
  for (const char* arguments : {"", "frobnicate", "format", "format --nothing x", "format --dialect abb x",
                                "format --write --check x", "format --write -", "format x y"}) {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.status, 2) << arguments;
    EXPECT_FALSE(outcome.output.empty()) << arguments;
  }
  EXPECT_THAT(run("format --dialect abb x").output, HasSubstr("allowed: irc5 or s4c"));
}

TEST(Rapid, explainsItself) {
  EXPECT_EQ(run("--help").status, 0);
  EXPECT_THAT(run("format --help").output, HasSubstr("--check"));
  EXPECT_THAT(run("--version").output, HasSubstr("rapid (cobot_command)"));
}

TEST(Rapid, reportsThatItsAnswerCannotBeWritten) {
  EXPECT_EQ(run("format " + inSourceTree("test/data/rapid/16_format_in.mod") + " >/dev/full").status, 3);
}

TEST(RapidCheck, reportsFindingsAsACompilerAndEndsWithOne) {
  const OwnFolder folder;
  const std::string file = folder.file("a.mod", "MODULE m\nPROC main()\nMovL p,v100;\nENDPROC\nENDMODULE\n");
  const Outcome outcome = run("check " + file);
  EXPECT_EQ(outcome.status, 1);
  EXPECT_EQ(outcome.output,
            file + ":3:1: error E501: there is no procedure 'MovL'; did you mean MoveL?\nMovL p,v100;\n^\n");
}

TEST(RapidCheck, isQuietAboutAProgramWithoutFindings) {
  const std::string programs = inSourceTree("test/data/rapid/programs/");
  const Outcome outcome = run("check --signals " + programs + "sorting.yaml " + programs +
                              "sorting_main.mod " + programs + "sorting_bins.mod");
  EXPECT_EQ(outcome.status, 0);
  EXPECT_THAT(outcome.output, IsEmpty());
}

TEST(RapidCheck, warnsOfOldConfigurationsOfRobotAAlone) {
  const std::string config = inSourceTree("config/rapid/");
  const std::string arguments = "--signals " + config + "robot_a.yaml " + config + "robot_a.mod";
  EXPECT_EQ(run("check " + arguments + " | grep -c 'warning W322'").output, "4\n");
  EXPECT_EQ(run("check " + arguments + " | grep -c ': error'").output, "0\n");
  EXPECT_EQ(run("check " + arguments).status, 0);
  EXPECT_EQ(run("check --strict " + arguments).status, 1);
}

TEST(RapidCheck, writesJson) {
  const OwnFolder folder;
  const std::string file = folder.file("a.mod", "MODULE m\nPROC main()\na:=1;\nENDPROC\nENDMODULE\n");
  const Outcome outcome = run("check --json " + file);
  EXPECT_EQ(outcome.status, 1);
  const auto rows = nlohmann::json::parse(outcome.output);
  EXPECT_EQ(rows, nlohmann::json::array({{{"file", file},
                                          {"id", "E401"},
                                          {"severity", "error"},
                                          {"line", 3},
                                          {"column", 1},
                                          {"text", "'a' is not declared"},
                                          {"end_line", 3},
                                          {"end_column", 2}}}));
  EXPECT_EQ(run("check --json --library -", "printf 'MODULE m ENDMODULE' | ").output, "[]\n");
}

TEST(RapidCheck, reportsASignalFileThatIsWrong) {
  const OwnFolder folder;
  const std::string signals = folder.file("s.yaml", "a: {type: di, virtual: true}\nb: {type: dx}\n");
  const Outcome outcome =
      run("check --library --signals " + signals + " -", "printf 'MODULE m ENDMODULE' | ");
  EXPECT_EQ(outcome.status, 1);
  EXPECT_THAT(outcome.output, HasSubstr(signals + ":2:11: error E905: signal file: type is something else"));
  EXPECT_THAT(
      run("check --library --signals " + folder.file("none") + " -", "printf 'MODULE m ENDMODULE' | ").output,
      HasSubstr("none:1:1: error E905: signal file: cannot be read: No such file or directory"));
}

TEST(RapidCheck, passesOverWhatIsSkipped) {
  const std::string text = "printf 'MODULE m PROC main() ActUnit a; Foo 1; ENDPROC ENDMODULE' | ";
  EXPECT_EQ(run("check -", text).status, 1);
  EXPECT_EQ(run("check --skip ActUnit,foo -", text).status, 0);
  EXPECT_EQ(run("check --skip ActUnit,,foo -", text).status, 2);
}

TEST(RapidCheck, refusesWhatIsNoOption) {
  EXPECT_EQ(run("check").status, 2);
  EXPECT_EQ(run("check --arm tm5-900 a.mod").status, 2);
  EXPECT_EQ(run("check --dialect s5 a.mod").status, 2);
  EXPECT_THAT(run("check /nowhere/a.mod").output, HasSubstr("E901: cannot be read"));
}

}  // namespace
