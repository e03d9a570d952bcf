// The program as a user calls it, through the shell.
#include <cstdio>
#include <cstdlib>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>
#include <sys/wait.h>
#include <unistd.h>

namespace {

using nlohmann::json;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

struct Outcome {
  int status = -1;
  std::string output;

  [[nodiscard]] std::vector<json> lines() const {
    std::vector<json> parsed;
    for (std::size_t begin = 0; begin < output.size(); begin = output.find('\n', begin) + 1) {
      parsed.push_back(json::parse(output.substr(begin, output.find('\n', begin) - begin)));
    }
    return parsed;
  }
};

/// `tm_frame ARGUMENTS`, with the bytes that printf makes of the input (no quotes in it) on standard input.
Outcome run(const std::string& arguments, const std::string& input = "") {
  const std::string command = "printf '" + input + "' | '" TM_FRAME "' " + arguments + " 2>&1";
  Outcome outcome;
  FILE* pipe = popen(command.c_str(), "r");
  if (pipe == nullptr) return outcome;
  char block[4096];
  for (std::size_t size = 0; (size = fread(block, 1, sizeof(block), pipe)) > 0;) {
    outcome.output.append(block, size);
  }
  const int status = pclose(pipe);
  outcome.status = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  return outcome;
}

TEST(TmFrame, encodesAFrame) {
  const Outcome outcome = run("encode TMSCT '10,OK'");
  EXPECT_EQ(outcome.status, 0);
  EXPECT_EQ(outcome.output, "$TMSCT,5,10,OK,*6D\r\n");
}

TEST(TmFrame, encodesEmptyDataAndDataThatLooksLikeAnOption) {
  EXPECT_EQ(run("encode TMSTA ''").output, "$TMSTA,0,,*43\r\n");
  EXPECT_EQ(run("encode -- TMSTA -1").output, "$TMSTA,2,-1,*5D\r\n");
}

TEST(TmFrame, decodesWhatItEncoded) {
  const Outcome outcome = run("encode TMSCT '10,OK' | '" TM_FRAME "' decode");
  EXPECT_EQ(outcome.status, 0);
  ASSERT_THAT(outcome.lines(), SizeIs(1));
  EXPECT_EQ(outcome.lines()[0],
            json::parse(R"({"header":"TMSCT","data":"10,OK","valid":true,"meaning":"script 10 accepted"})"));
}

TEST(TmFrame, tellsEveryFaultAndGoesOn) {
  const Outcome outcome =
      run("decode", "noise$TMSCT,5,10,OK,*00\\r\\n$TMSCT,-5,$TMSCT,5,10,OK,*6D\\r\\n$TMSCT,5,10");
  EXPECT_EQ(outcome.status, 1);
  const auto lines = outcome.lines();
  ASSERT_THAT(lines, SizeIs(5));
  EXPECT_EQ(lines[0]["fault"], "garbage");
  EXPECT_EQ(lines[0]["bytes"], "noise");
  EXPECT_EQ(lines[1]["fault"], "checksum");
  EXPECT_EQ(lines[2]["fault"], "length");
  EXPECT_EQ(lines[3]["valid"], true);
  EXPECT_EQ(lines[4]["fault"], "incomplete");
  EXPECT_EQ(lines[4]["valid"], false);
}

TEST(TmFrame, decodesEachLineOfHexOnItsOwn) {
  const Outcome outcome =
      run("decode --hex",
          "24544D5343542C352C31302C4F4B2C2A36440D0A\\n24 54 4d\\n24544d5343542c352c31302c4f4b2c2a36440d0a");
  EXPECT_EQ(outcome.status, 1);
  const auto lines = outcome.lines();
  ASSERT_THAT(lines, SizeIs(3));
  EXPECT_EQ(lines[0]["data"], "10,OK");
  EXPECT_EQ(lines[1]["fault"], "incomplete");
  EXPECT_EQ(lines[2]["data"], "10,OK");
}

TEST(TmFrame, readsAFrameOfTheFlightRecorderAsTheOneWhoGotIt) {
  const std::string ok = "24544D5343542C352C31302C4F4B2C2A36440D0A";  // $TMSCT,5,10,OK,*6D
  const auto received = run("decode --hex --trace-of controller", ok);
  EXPECT_EQ(received.status, 0);
  ASSERT_THAT(received.lines(), SizeIs(1));
  EXPECT_EQ(
      received.lines()[0],
      json::parse(R"({"valid":true,"meaning":"script 10 accepted","text":"$TMSCT,5,10,OK,*6D\\r\\n"})"));
  EXPECT_EQ(run("decode --hex --trace-of client", ok).lines()[0]["meaning"], "run script 10: OK");
  EXPECT_EQ(run("decode --hex --trace-of status", ok).lines()[0]["valid"], false);
}

TEST(TmFrame, answersEachLineOfAFlightRecorderWithOneLine) {
  const std::string question = "24544D5354412C322C30302C2A34310D0A";
  const auto outcome =
      run("decode --hex --trace-of client", question + "\n\n" + question + question + "\n2454\n" + question);
  EXPECT_EQ(outcome.status, 1);
  const auto lines = outcome.lines();
  ASSERT_THAT(lines, SizeIs(5));
  EXPECT_EQ(lines[0]["meaning"], "in a Listen node?");
  EXPECT_EQ(lines[1]["meaning"], "no bytes");
  EXPECT_EQ(lines[2]["meaning"], "more than one frame");
  EXPECT_EQ(lines[3]["valid"], false);
  EXPECT_EQ(lines[4]["valid"], true);
}

TEST(TmFrame, givesBytesThatAreNoTextInHexadecimal) {
  const auto lines = run("decode", "$TMSTA,5,90,d\\310,*CF\\r\\n").lines();
  ASSERT_THAT(lines, SizeIs(1));
  EXPECT_EQ(lines[0]["data"], "90,d\\xC8");
  EXPECT_EQ(lines[0]["data_hex"], "39302c64c8");
}

TEST(TmFrame, takesAnEmptyLengthWhenAsked) {
  const char* frame = "$TMSCT,,1,ScriptExit(),*62\\r\\n";
  EXPECT_EQ(run("decode", frame).status, 1);
  EXPECT_EQ(run("decode --accept-empty-length", frame).status, 0);
}

TEST(TmFrame, readsAFileAsItReadsStandardInput) {
  char name[] = "/tmp/tm_frame_test_XXXXXX";
  const int file = mkstemp(name);
  ASSERT_GE(file, 0);
  const std::string frame = "$TMSCT,5,10,OK,*6D\r\n";
  ASSERT_EQ(write(file, frame.data(), frame.size()), static_cast<ssize_t>(frame.size()));
  close(file);
  EXPECT_EQ(run(std::string("decode ") + name, "noise").output,
            run("decode", "$TMSCT,5,10,OK,*6D\\r\\n").output);
  EXPECT_EQ(run("decode -", "$TMSCT,5,10,OK,*6D\\r\\n").output,
            run("decode", "$TMSCT,5,10,OK,*6D\\r\\n").output);
  const Outcome hex = run(std::string("decode --hex ") + name);
  EXPECT_EQ(hex.status, 2);
  EXPECT_THAT(hex.output, HasSubstr("line 1: expected pairs of hexadecimal digits"));
  unlink(name);
  EXPECT_EQ(run(std::string("decode ") + name).status, 2);
  EXPECT_THAT(run(std::string("decode ") + name).output,
              HasSubstr("cannot be read: No such file or directory"));
  EXPECT_THAT(run("decode /tmp").output, HasSubstr("/tmp cannot be read: it is a folder"));
  EXPECT_THAT(run("decode ''").output, HasSubstr("the name is empty"));
  EXPECT_EQ(run("decode </tmp").status, 2);
  EXPECT_EQ(run("decode --hex </tmp").status, 2);
}

TEST(TmFrame, saysNothingAboutNothing) {
  const Outcome outcome = run("decode");
  EXPECT_EQ(outcome.status, 0);
  EXPECT_THAT(outcome.output, IsEmpty());
}

TEST(TmFrame, endsWithTwoOnBadUsage) {
  for (const char* arguments : {"", "frobnicate", "encode", "encode TMSCT", "encode 'TM$' x", "encode '' x",
                                "encode ABCDEFGHIJKLMNOPQ x", "decode extra", "decode --nothing",
                                "decode --trace-of client", "decode --hex --trace-of me"}) {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.status, 2) << arguments;
    EXPECT_FALSE(outcome.output.empty()) << arguments;
  }
  EXPECT_THAT(run("frobnicate").output,
              HasSubstr("there is no subcommand \"frobnicate\"; allowed: encode, decode"));
  EXPECT_THAT(run("").output, HasSubstr("no subcommand is given; allowed: encode, decode"));
  const Outcome outcome = run("decode --hex", "24\\nxyz");
  EXPECT_EQ(outcome.status, 2);
  EXPECT_THAT(outcome.output, HasSubstr("line 2"));
}

TEST(TmFrame, explainsItself) {
  const Outcome outcome = run("--help");
  EXPECT_EQ(outcome.status, 0);
  EXPECT_THAT(outcome.output, HasSubstr("decode"));
  EXPECT_EQ(run("decode --help").status, 0);
}

TEST(TmFrame, tellsWhenItsAnswerCannotBeWritten) {
  EXPECT_EQ(run("encode TMSCT '10,OK' >/dev/full").status, 3);
  EXPECT_EQ(run("decode >/dev/full", "$TMSCT,5,10,OK,*6D\\r\\n").status, 3);
  EXPECT_EQ(run("decode --hex >/dev/full", "24\\n24\\n").status, 3);
}

}  // namespace
