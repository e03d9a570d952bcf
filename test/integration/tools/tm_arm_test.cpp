// The program tm_arm as its caller sees it: standard output and exit code.
#include <array>
#include <cstdio>
#include <stdexcept>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <sys/wait.h>

namespace {

using nlohmann::json;
using testing::DoubleNear;
using ::testing::HasSubstr;
using testing::Pointwise;

struct Outcome {
  std::string output;
  int exit_code = -1;
};

/// Runs `tm_arm <arguments>` with `input` (without quotes) as its standard input.
Outcome tmArm(const std::string& arguments, const std::string& input = "") {
  const std::string command = "printf '" + input + "' | " TM_ARM " " + arguments + " 2>&1";
  FILE* pipe = popen(command.c_str(), "r");
  if (pipe == nullptr) throw std::runtime_error("cannot run " + command);
  Outcome outcome;
  std::array<char, 4096> buffer{};
  while (const std::size_t size = fread(buffer.data(), 1, buffer.size(), pipe)) {
    outcome.output.append(buffer.data(), size);
  }
  outcome.exit_code = WEXITSTATUS(pclose(pipe));
  return outcome;
}

std::vector<std::string> linesOf(const std::string& text) {
  std::vector<std::string> lines;
  std::size_t from = 0;
  for (std::size_t to = 0; (to = text.find('\n', from)) != std::string::npos; from = to + 1) {
    lines.push_back(text.substr(from, to - from));
  }
  return lines;
}

TEST(TmArm, fkGivesThePoseAndItsBitsInJson) {
  const Outcome outcome = tmArm("--model tm5-700 --json fk 0 0 90 0 90 0");
  EXPECT_EQ(outcome.exit_code, 0);
  const json answer = json::parse(outcome.output);
  EXPECT_EQ(answer.size(), 2U);
  EXPECT_THAT(answer.at("pose").get<std::vector<double>>(),
              Pointwise(DoubleNear(1e-9), {417.5, -122.3, 361.05, 180., 0., 90.}));
  EXPECT_EQ(answer.at("pose_bits"), json({0, 2, 4}));
}

TEST(TmArm, ikGivesAllBranchesWithTheirBitsInJson) {
  const Outcome outcome = tmArm("--model tm5-700 ik 417.5 -122.3 361.05 180 0 90 --json");
  EXPECT_EQ(outcome.exit_code, 0);
  const json answer = json::parse(outcome.output);
  ASSERT_EQ(answer.size(), 8U);
  for (const json& branch : answer) {
    EXPECT_EQ(branch.size(), 3U);
    EXPECT_EQ(branch.at("joints_deg").size(), 6U);
  }
  EXPECT_EQ(answer[0].at("pose_bits"), json({0, 2, 4}));
  EXPECT_EQ(answer[0].at("within_limits"), true);
  EXPECT_THAT(answer[0].at("joints_deg").get<std::vector<double>>(),
              Pointwise(DoubleNear(1e-9), {0., 0., 90., 0., 90., 0.}));
}

TEST(TmArm, ikTellsWhichBranchesAreOutsideTheLimits) {
  const json pose = json::parse(tmArm("--model tm5-900 --json fk 30 20 160 10 80 -45").output).at("pose");
  std::string numbers;
  for (const json& number : pose) numbers += number.dump() + " ";
  EXPECT_THAT(tmArm("--model tm5-900 ik " + numbers).output, HasSubstr("J3 outside"));
  int outside = 0;
  for (const json& branch : json::parse(tmArm("--model tm5-900 --json ik " + numbers).output)) {
    if (!branch.at("within_limits")) ++outside;
  }
  EXPECT_GT(outside, 0);
}

TEST(TmArm, writesAnAlignedTableForPeople) {
  const Outcome ik = tmArm("--model tm5-900 ik 517.5 -122.3 461.05 180 0 90");
  const auto rows = linesOf(ik.output);
  ASSERT_EQ(rows.size(), 9U);
  for (const std::string& row : rows) EXPECT_EQ(row.size(), std::string(rows[0]).size());
  EXPECT_THAT(rows[1], HasSubstr("0,2,4   RIGHTY ABOVE NOFLIP     0.0000     0.0000    90.0000"));
  const Outcome fk = tmArm("--model tm5-900 fk 0 0 90 0 90 0");
  EXPECT_THAT(fk.output, HasSubstr("517.5000 -122.3000  461.0500  180.0000    0.0000   90.0000  0,2,4"));
}

TEST(TmArm, takesNegativeNumbersInEveryNotation) {
  const Outcome outcome = tmArm("--model tm12 --json fk -90 -.5 -1e1 -0.0 +90 -2.5e-1");
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.output, tmArm("--model tm12 --json fk -- -90.0 -0.5 -10 0 90 -0.25").output);
}

TEST(TmArm, answersALineOfStandardInputWithALine) {
  const Outcome outcome = tmArm("--model tm5-900 --json fk -", "0 0 90 0 90 0\\n0 0 0 0 0 0\\n");
  EXPECT_EQ(outcome.exit_code, 0);
  const auto lines = linesOf(outcome.output);
  ASSERT_EQ(lines.size(), 2U);
  EXPECT_EQ(json::parse(lines[0]).at("pose_bits"), json({0, 2, 4}));
  EXPECT_EQ(json::parse(lines[1]).at("pose_bits"), json({1, 3, 5}));
}

TEST(TmArm, goesOnAfterABadLineAndSaysSoAtTheEnd) {
  const Outcome outcome = tmArm("--model tm5-900 --json fk -", "zero\\n0 0 0 0 0 0\\n");
  EXPECT_EQ(outcome.exit_code, 2);
  const auto lines = linesOf(outcome.output);
  ASSERT_EQ(lines.size(), 3U);  // the complaint, the empty answer, the good answer
  EXPECT_THAT(outcome.output, HasSubstr("found \"zero\""));
  EXPECT_TRUE(json::accept(lines.back()));
}

TEST(TmArm, saysWhyAPoseIsOutOfReachAndExitsWith1) {
  const Outcome outcome = tmArm("--model tm5-900 ik 4170 0 500 180 0 90");
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_THAT(outcome.output, HasSubstr("at most 954.37"));
  const Outcome in_json = tmArm("--model tm5-900 --json ik 4170 0 500 180 0 90");
  EXPECT_EQ(in_json.exit_code, 1);
  EXPECT_EQ(in_json.output, "[]\n");
  EXPECT_EQ(tmArm("--model tm5-900 --json ik -", "4170 0 500 180 0 90\\n").exit_code, 1);
}

TEST(TmArm, namesTheSubcommandThatItDoesNotHave) {
  EXPECT_THAT(tmArm("--model tm12 jump").output,
              HasSubstr("there is no subcommand \"jump\"; allowed: fk, ik, urdf"));
  EXPECT_THAT(tmArm("--model tm12").output, HasSubstr("no subcommand is given; allowed: fk, ik, urdf"));
  EXPECT_THAT(tmArm("--model tm12 --speed 3 urdf").output, HasSubstr("--speed"));
  EXPECT_EQ(tmArm("--model tm12 --speed 3 urdf").exit_code, 2);
  EXPECT_EQ(tmArm("--model tm12 urdf jump").exit_code, 2);
}

TEST(TmArm, refusesAPrefixThatTfWouldNotTake) {
  for (const char* prefix : {"/x", "'a b'"}) {
    const Outcome outcome = tmArm(std::string("--model tm12 urdf --prefix ") + prefix);
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_THAT(outcome.output, HasSubstr("Allowed are letters, digits"));
  }
}

TEST(TmArm, exitsWith2OnBadUsage) {
  for (const char* arguments :
       {"", "fk 0 0 0 0 0 0", "--model ur5 fk 0 0 0 0 0 0", "--model tm12", "--model tm12 jump",
        "--model tm12 fk", "--model tm12 fk 0 0 0 0 0", "--model tm12 fk 0 0 0 0 0 0 0",
        "--model tm12 fk 0 0 0 0 0 zero", "--model tm12 fk 0 0 0 0 0 nan", "--model tm12 fk 0 0 0 0 0 1e999",
        "--model tm12 fk 0 0 0 0 0 -inf", "--model tm12 fk 0,0,0,0,0,0", "--model tm12 --speed 3 fk -",
        "--model tm12 fk 0 0 0 0 0 ''"}) {
    const Outcome outcome = tmArm(arguments);
    EXPECT_EQ(outcome.exit_code, 2) << arguments;
    EXPECT_FALSE(outcome.output.empty()) << arguments;
  }
}

TEST(TmArm, printsTheUrdfOfAModelWithAPrefixIfWanted) {
  const Outcome plain = tmArm("--model tm14s urdf");
  EXPECT_EQ(plain.exit_code, 0);
  EXPECT_THAT(plain.output, HasSubstr("<robot name=\"tm14s\">"));
  EXPECT_THAT(plain.output, HasSubstr("<joint name=\"elbow_joint\""));
  const Outcome prefixed = tmArm("--model tm14s urdf --prefix left_");
  EXPECT_EQ(prefixed.exit_code, 0);
  EXPECT_THAT(prefixed.output, HasSubstr("<joint name=\"left_elbow_joint\""));
  EXPECT_EQ(tmArm("--model tm14s urdf --prefix ''").output, plain.output);
}

TEST(TmArm, explainsItself) {
  const Outcome outcome = tmArm("--help");
  EXPECT_EQ(outcome.exit_code, 0);
  for (const char* word : {"--model", "--json", "fk", "ik", "urdf", "standard input", "Exit code"}) {
    EXPECT_THAT(outcome.output, HasSubstr(word));
  }
  EXPECT_EQ(tmArm("fk --help").exit_code, 0);
}

TEST(TmArm, tellsWhenItsAnswerCannotBeWritten) {
  for (const char* arguments :
       {"--model tm5-900 fk 0 0 90 0 90 0 >/dev/full", "--model tm5-900 urdf >/dev/full",
        "--model tm5-900 fk - >/dev/full", "--help >/dev/full"}) {
    const Outcome outcome = tmArm(arguments, "0 0 90 0 90 0\\n0 0 90 0 90 0\\n");
    EXPECT_EQ(outcome.exit_code, 3) << arguments;
  }
}

}  // namespace
