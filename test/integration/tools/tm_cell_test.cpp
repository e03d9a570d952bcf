// The program tm_cell as its caller sees it: standard output, files and exit code.
#include <fstream>
#include <string>

#include "tm_cell_program.h"
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>
#include <sys/stat.h>

#include "cobot_command/common/sha256.h"

namespace cobot_command::test_support {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

TEST_F(TmCell, buildsTheCellsOfTheDemosAndVerifiesThem) {
  for (const char* cell : {"handover", "head_on", "iris", "corridor", "pallet"}) {
    const std::string artifact = built(cell);
    const Outcome verified = tmCell("verify " + artifact + " --cell " + cellFile(cell));
    EXPECT_EQ(verified.exit_code, 0) << verified.output;
  }
}

TEST_F(TmCell, refusesAnArtifactOfAnotherCell) {
  const Outcome verified = tmCell("verify " + built("handover") + " --cell " + cellFile("head_on"));
  EXPECT_EQ(verified.exit_code, 1);
  EXPECT_THAT(verified.output, HasSubstr("was not made from"));
}

/// With a checksum that is right: it says nothing of who made it.
TEST_F(TmCell, refusesAnArtifactThatWasChanged) {
  const std::string artifact = built("handover");
  std::string text = textIn(artifact);
  text.resize(text.rfind('\n', text.size() - 2) + 1);
  const std::string line = R"(PTP(\"JPP\",0,45)";
  const auto at = text.find(line);
  ASSERT_NE(at, std::string::npos);
  text.replace(at, line.size(), R"(PTP(\"JPP\",1,45)");
  std::ofstream(artifact) << text << sha256Hex(text) << "\n";
  const Outcome verified = tmCell("verify " + artifact);
  EXPECT_EQ(verified.exit_code, 1);
  EXPECT_THAT(verified.output, HasSubstr("/lines/0 is"));
  EXPECT_THAT(verified.output, HasSubstr("Rebuild it"));
}

TEST_F(TmCell, writesOverNoDeviceAndNotOverWhatItReads) {
  const std::string pipe = in("pipe");
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  const Outcome to_pipe = tmCell("build " + cellFile("handover") + " -o " + pipe);
  EXPECT_EQ(to_pipe.exit_code, 1);
  EXPECT_THAT(to_pipe.output, HasSubstr("it is not a file"));
  std::ofstream(in("own.yaml")) << textIn(cellFile("handover"));
  const Outcome to_itself = tmCell("build " + in("own.yaml") + " -o " + in("own.yaml"));
  EXPECT_EQ(to_itself.exit_code, 1);
  EXPECT_THAT(to_itself.output, HasSubstr("it is the input file"));
  EXPECT_EQ(textIn(in("own.yaml")), textIn(cellFile("handover")));
}

TEST_F(TmCell, writesWhereALinkLeadsTo) {
  ASSERT_EQ(symlink("there", in("link").c_str()), 0);
  EXPECT_EQ(tmCell("build " + cellFile("handover") + " -o " + in("link")).exit_code, 0);
  EXPECT_EQ(tmCell("verify " + in("there")).exit_code, 0);
}

TEST_F(TmCell, readsNoFileWithoutAnEnd) {
  EXPECT_THAT(tmCell("check /dev/zero").output, HasSubstr("it is longer than"));
}

TEST_F(TmCell, namesAProgramThatNeverEndsACycle) {
  std::string text = textIn(cellFile("handover"));
  const std::string back = "    - {path: BACK";
  text.insert(text.find(back),
              "    - {path: STAY, from: T1, to: T1, steps: [{movement_command: PTP, data_format: JPP, "
              "target_position: T1, speed: 30, accel_time: 300}]}\n");
  std::ofstream(in("loop.yaml")) << text;
  const Outcome outcome = tmCell("build " + in("loop.yaml") + " -o " + in("loop"));
  EXPECT_EQ(outcome.exit_code, 0) << outcome.output;
  EXPECT_THAT(outcome.output, HasSubstr("RA: the first path of each station does not lead back home"));
  const Outcome simulated = tmCell("simulate " + in("loop") + " --cycles 1");
  EXPECT_EQ(simulated.exit_code, 1);
  EXPECT_THAT(simulated.output, HasSubstr("no cycle would end"));
}

TEST_F(TmCell, explainsWhyAnEventIsNotGranted) {
  const std::string artifact = built("head_on");
  const Outcome granted = tmCell("explain " + artifact + " RA_b_Z1 --behind RA_g_W");
  EXPECT_EQ(granted.exit_code, 0) << granted.output;
  const Outcome held = tmCell("explain " + artifact + " RB_b_Z2 --behind RA_g_W,RA_b_Z1,RA_b_Z2,RB_g_W");
  EXPECT_EQ(held.exit_code, 1);
  EXPECT_THAT(held.output, HasSubstr("ZONE_HELD: Z2 is held by RA"));
  const Outcome blocks = tmCell("explain " + artifact + " RB_b_Z2 --behind RA_g_W,RA_b_Z1,RB_g_W");
  EXPECT_EQ(blocks.exit_code, 1);
  EXPECT_THAT(blocks.output, HasSubstr("WOULD_BLOCK: RA, RB could not all return home"));
  EXPECT_THAT(tmCell("explain " + artifact + " RX_b_Z2").output, HasSubstr("the cell has RA_g_W"));
}

TEST_F(TmCell, tellsWhatASupervisorKeepsOutOfAsRules) {
  EXPECT_THAT(tmCell("rules " + built("handover")).output, HasSubstr("RA, RB: zones alone are enough"));
  const Outcome head_on = tmCell("rules " + built("head_on"));
  EXPECT_EQ(head_on.exit_code, 0) << head_on.output;
  EXPECT_THAT(head_on.output, HasSubstr("not RA with Z1 (W>1) while RB with Z2 (W>1)\n"));
  EXPECT_THAT(head_on.output, HasSubstr("RA, RB: 1 rules for 1 states to avoid"));
  const Outcome iris = tmCell("rules " + built("iris"));
  EXPECT_EQ(iris.exit_code, 0) << iris.output;
  EXPECT_THAT(iris.output, HasSubstr(" while R2 with "));
  const Outcome pallet = tmCell("rules " + built("pallet"));
  EXPECT_EQ(pallet.exit_code, 0) << pallet.output;
  const Outcome built_otherwise =
      tmCell("build " + cellFile("head_on") + " --policy safe_order -o " + in("safe"));
  EXPECT_EQ(built_otherwise.exit_code, 0) << built_otherwise.output;
  EXPECT_THAT(tmCell("rules " + in("safe")).output, HasSubstr("RA, RB: safe_order decides"));
}

TEST_F(TmCell, findsTheShortestSchedule) {
  const Outcome schedule = tmCell("schedule " + built("iris"));
  EXPECT_EQ(schedule.exit_code, 0) << schedule.output;
  EXPECT_THAT(schedule.output, HasSubstr("this is the shortest"));
}

TEST_F(TmCell, answersInJson) {
  const Outcome outcome = tmCell("zones --json " + cellFile("handover"));
  EXPECT_EQ(outcome.exit_code, 0);
  const auto answer = nlohmann::json::parse(outcome.output);
  EXPECT_TRUE(answer.at("ok"));
  EXPECT_EQ(answer.at("stages").back().at("name"), "soundness");
}

TEST_F(TmCell, saysWhatIsWrongWithAFile) {
  std::ofstream(in("wrong.yaml")) << "cell: x\nrobots: {RA: {model: tm5-901}}\n";
  const Outcome outcome = tmCell("check " + in("wrong.yaml"));
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_THAT(outcome.output, HasSubstr("wrong.yaml:2:"));
  EXPECT_THAT(outcome.output, HasSubstr("tm5-901"));
  EXPECT_EQ(tmCell("check " + in("nowhere.yaml")).exit_code, 1);
}

TEST_F(TmCell, keepsAPalletBackThatWouldEnterByItself) {
  const std::string artifact = built("pallet");
  const Outcome refused = tmCell("explain " + artifact + " PALLET_g_FEED --behind RA_g_FETCH,RA_b_Z1");
  EXPECT_EQ(refused.exit_code, 1);
  EXPECT_THAT(refused.output,
              HasSubstr("WOULD_BLOCK: PALLET could not be kept out of Z1, which RA would hold"));
  const Outcome safe_order = tmCell("build " + cellFile("pallet") + " --policy safe_order -o " + in("other"));
  EXPECT_EQ(safe_order.exit_code, 1);
  EXPECT_THAT(safe_order.output, HasSubstr("it cannot be made to wait"));
  EXPECT_EQ(tmCell("schedule " + artifact).exit_code, 0);
}

TEST_F(TmCell, coversAMeshByBoxesThatACellFileTakes) {
  std::ofstream(in("plate.stl")) << "solid plate\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\n"
                                    "vertex 300 0 0\nvertex 0 200 0\nendloop\nendfacet\nendsolid\n";
  const Outcome shapes = tmCell("cover " + in("plate.stl") + " --cell 100");
  EXPECT_EQ(shapes.exit_code, 0) << shapes.output;
  EXPECT_THAT(shapes.output, HasSubstr("shapes:\n  - box: {size: ["));
  std::ifstream handover(cellFile("handover"));
  std::string cell((std::istreambuf_iterator<char>(handover)), std::istreambuf_iterator<char>());
  std::string parts = shapes.output;
  for (std::size_t at = parts.find('\n'); at != std::string::npos && at + 1 < parts.size();
       at = parts.find('\n', at + 5)) {
    parts.insert(at + 1, "    ");
  }
  std::ofstream(in("cell.yaml")) << cell << "\nparts:\n  plate:\n    on: flange\n" << parts;
  const Outcome checked = tmCell("check " + in("cell.yaml"));
  EXPECT_EQ(checked.exit_code, 0) << checked.output;
  EXPECT_THAT(checked.output, HasSubstr("1 parts"));
  std::ofstream(in("no.stl")) << "shapes: []";
  EXPECT_THAT(tmCell("cover " + in("no.stl")).output, HasSubstr("no.stl: it is not an STL file"));
  EXPECT_EQ(tmCell("cover " + in("plate.stl") + " --cell 0").exit_code, 2);
}

TEST_F(TmCell, writesZonesAndClaimsForViewers) {
  const Outcome clouds = tmCell("voxels " + cellFile("pallet") + " -o " + in("new/folder"));
  EXPECT_EQ(clouds.exit_code, 0) << clouds.output;
  EXPECT_THAT(clouds.output, HasSubstr("zone Z1 of RA and PALLET, cell pallet"));
  for (const char* file : {"zone_Z1.ply", "claim_RA.ply", "claim_PALLET.ply"}) {
    std::ifstream cloud(in("new/folder/") + file);
    std::string line;
    EXPECT_TRUE(std::getline(cloud, line)) << file;
    EXPECT_EQ(line, "ply");
  }
  const Outcome maps = tmCell("voxels " + cellFile("head_on") + " --format bt -o " + in("maps"));
  EXPECT_EQ(maps.exit_code, 0) << maps.output;
  for (const char* file : {"zone_Z1.bt", "zone_Z2.bt", "claim_RA.bt", "claim_RB.bt"}) {
    std::ifstream map(in("maps/") + file);
    std::string line;
    EXPECT_TRUE(std::getline(map, line)) << file;
    EXPECT_EQ(line, "# Octomap OcTree binary file");
  }
  std::ofstream(in("file")) << "no folder";
  const Outcome refused = tmCell("voxels " + cellFile("pallet") + " -o " + in("file"));
  EXPECT_EQ(refused.exit_code, 1);
  EXPECT_THAT(refused.output, HasSubstr("cannot be created"));
  EXPECT_EQ(tmCell("voxels " + cellFile("pallet")).exit_code, 2);
  EXPECT_EQ(tmCell("voxels " + cellFile("pallet") + " --format pcd -o " + in("maps")).exit_code, 2);
}

TEST_F(TmCell, runsTheCellsOfTheDemosUnderTheirSupervisorsWithoutATouch) {
  for (const char* cell : {"handover", "head_on", "iris", "corridor"}) {
    const std::string artifact = built(cell);
    for (const char* policy : {"supervisor", "safe_order", "schedule"}) {
      const Outcome outcome = tmCell("simulate " + artifact + " --quiet --policy " + policy);
      EXPECT_EQ(outcome.exit_code, 0) << cell << " " << policy << ": " << outcome.output;
    }
  }
}

TEST_F(TmCell, runsARobotBesideAPalletThatComesInByItselfAndCollidesWithoutASupervisor) {
  const std::string artifact = built("pallet");
  const Outcome outcome = tmCell("simulate " + artifact);
  EXPECT_EQ(outcome.exit_code, 0) << outcome.output;
  EXPECT_THAT(outcome.output, HasSubstr("PALLET: OUT, waits: WOULD_BLOCK by PALLET, RA"));
  const Outcome touched = tmCell("simulate " + artifact + " --quiet --policy none");
  EXPECT_EQ(touched.exit_code, 1);
  EXPECT_THAT(touched.output, HasSubstr("COLLISION: RA and PALLET"));
  const Outcome refused = tmCell("simulate " + artifact + " --policy safe_order");
  EXPECT_EQ(refused.exit_code, 1);
  EXPECT_THAT(refused.output, HasSubstr("safe_order"));
}

TEST_F(TmCell, tellsLaunchFilesWhatTheyWantToKnowOfAnArtifact) {
  const std::string artifact = built("pallet");
  EXPECT_EQ(tmCell("ask " + artifact + " robots").output, "RA\n");
  EXPECT_EQ(tmCell("ask " + artifact + " mechanisms").output, "PALLET\n");
  EXPECT_EQ(tmCell("ask " + artifact + " model RA").output, "tm5-900\n");
  EXPECT_EQ(tmCell("ask " + artifact + " home RA").output, "[0, -30, 120, 0, 90, 0]\n");
  EXPECT_EQ(tmCell("ask " + artifact + " home PALLET").output, "0\n");
  EXPECT_EQ(tmCell("ask " + artifact + " places RA").output, "HOME T1 FETCH> FETCH>1 BRING> BRING>1\n");
  const Outcome one_more = tmCell("ask " + artifact + " robots RA");
  EXPECT_EQ(one_more.exit_code, 1);
  EXPECT_THAT(one_more.output, HasSubstr("\"RA\": robots refers to the whole cell"));
  const Outcome none = tmCell("ask " + artifact + " model PALLET");
  EXPECT_EQ(none.exit_code, 1);
  EXPECT_THAT(none.output, HasSubstr("there is no \"PALLET\" with a model: the artifact has RA"));
}

TEST_F(TmCell, readsWholeNumbersAsPeopleWriteThem) {
  const std::string artifact = built("handover");
  const Outcome ten = tmCell("simulate " + artifact + " --quiet --cycles 010");
  EXPECT_EQ(ten.exit_code, 0) << ten.output;
  EXPECT_THAT(ten.output, HasSubstr("RA: 10 cycles")) << "and not 8";
  for (const char* option : {"--seed 99999999999999999999", "--seed 18446744073709551615", "--seed -1",
                             "--cycles 0x10", "--cycles 1.5", "--cycles 1000001", "--cycles ''"}) {
    const Outcome outcome = tmCell("simulate " + artifact + " --quiet " + option);
    EXPECT_EQ(outcome.exit_code, 2) << option;
    EXPECT_THAT(outcome.output, HasSubstr("is not a whole number from")) << option;
  }
  EXPECT_EQ(tmCell("simulate " + artifact + " --quiet --seed 999999999").exit_code, 0);
}

TEST_F(TmCell, showsThatMutualExclusionAloneBlocksAndThatNothingAtAllCollides) {
  for (const char* cell : {"head_on", "iris", "corridor"}) {
    const std::string artifact = built(cell);
    const Outcome blocked = tmCell("simulate " + artifact + " --quiet --policy mutex");
    EXPECT_EQ(blocked.exit_code, 1) << cell;
    EXPECT_THAT(blocked.output, HasSubstr("DEADLOCK")) << cell;
    const Outcome touched = tmCell("simulate " + artifact + " --quiet --policy none");
    EXPECT_EQ(touched.exit_code, 1) << cell;
    EXPECT_THAT(touched.output, HasSubstr("COLLISION")) << cell;
  }
}

TEST_F(TmCell, keepsTheDistanceWhateverIsLateOrLost) {
  const std::string artifact = built("head_on");
  const Outcome late = tmCell("simulate " + artifact + " --quiet --random --seed 7 --cycles 2");
  EXPECT_EQ(late.exit_code, 0) << late.output;
  const Outcome lossy = tmCell("simulate " + artifact + " --quiet --loss 30 --seed 7 --cycles 3");
  EXPECT_EQ(lossy.exit_code, 0) << lossy.output;
}

TEST_F(TmCell, leavesNoArtifactWhereItCannotBeWritten) {
  const Outcome outcome = tmCell("build " + cellFile("handover") + " -o " + in("no/such/folder"));
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_THAT(outcome.output, HasSubstr("cannot be written"));
}

TEST_F(TmCell, exchangesAutomata) {
  const std::string artifact = built("iris");
  EXPECT_EQ(tmCell("export " + artifact + " wmod -o " + in("iris.wmod")).exit_code, 0);
  const Outcome imported = tmCell("import " + in("iris.wmod"));
  EXPECT_EQ(imported.exit_code, 0) << imported.output;
  EXPECT_THAT(imported.output, HasSubstr("258 states, 672 transitions"));
  EXPECT_THAT(tmCell("export " + artifact + " cif").output, HasSubstr("requirement Z1:"));
  EXPECT_THAT(tmCell("export " + artifact + " dot").output, HasSubstr("digraph"));
}

TEST_F(TmCell, hasTheFiguresOfTheDataFile) {
  const Outcome outcome = tmCell("oracle " + inSourceTree("test/data/cell-oracles.json"));
  EXPECT_EQ(outcome.exit_code, 0) << outcome.output;
  EXPECT_THAT(outcome.output, HasSubstr("352 figures were compared"));
}

TEST_F(TmCell, refusesACommandLineThatItCannotUse) {
  EXPECT_EQ(tmCell("").exit_code, 2);
  EXPECT_EQ(tmCell("build " + cellFile("handover")).exit_code, 2);
  EXPECT_EQ(tmCell("build " + cellFile("handover") + " -o x --policy mutex").exit_code, 2);
  EXPECT_EQ(tmCell("zones " + cellFile("handover") + " --threads 0").exit_code, 2);
}

TEST_F(TmCell, namesAMisspeltOptionBeforeWhatIsMissing) {
  const Outcome outcome = tmCell("build " + cellFile("handover") + " --outptu " + in("x"));
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.output, HasSubstr("tm_cell: there is no option \"--outptu\"; --output is near"));
}

TEST_F(TmCell, namesItselfAndItsVersion) {
  EXPECT_THAT(tmCell("--help").output, HasSubstr("Usage: tm_cell [OPTIONS] SUBCOMMAND"));
  EXPECT_THAT(tmCell("verify --help").output, HasSubstr("Usage: tm_cell verify [OPTIONS] ARTIFACT"));
  EXPECT_THAT(tmCell("--version").output, StartsWith("tm_cell (cobot_command) "));
  EXPECT_EQ(tmCell("--version").exit_code, 0);
}

}  // namespace
}  // namespace cobot_command::test_support
