#include "cobot_command/cell/artifact/artifact.h"

#include <random>

#include "../cell_zones/zoned_cell.h"
#include <gmock/gmock.h>

#include "cobot_command/cell/artifact/cell_build.h"
#include "cobot_command/cell/artifact/cycle_times.h"
#include "cobot_command/cell/program/canonical.h"

namespace cobot_command::cell {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;

CellBuild built(const std::string& name, Policy policy = Policy::Supervisor, unsigned threads = 1) {
  CellBuild build(cellOf(name), policy, threads);
  for (const BuildStage stage : kBuildStages) {
    EXPECT_THAT(build.run(stage), IsEmpty()) << name << ": " << toString(stage);
    EXPECT_FALSE(build.report(stage).empty()) << toString(stage);
  }
  return build;
}

const std::string& headOn() {
  static const std::string bytes = built("head_on").bytes();
  return bytes;
}

TEST(AnArtifact, isTheSameWhenItIsReadAndWritten) {
  const auto artifact = fromBytes(headOn());
  ASSERT_TRUE(artifact) << artifact.error();
  EXPECT_EQ(toBytes(*artifact), headOn());
  EXPECT_EQ(artifact->hash, hashOf(cellOf("head_on")));
}

TEST(AnArtifact, hasTheSameBytesOnAnyNumberOfThreads) {
  EXPECT_EQ(built("iris").bytes(), built("iris", Policy::Supervisor, 3).bytes());
}

TEST(AnArtifact, isRefusedWhereAnyBitIsFlipped) {
  std::mt19937 chance(17);
  for (int run = 0; run < 200; ++run) {
    std::string damaged = headOn();
    const std::size_t at = chance() % damaged.size();
    damaged[at] = static_cast<char>(damaged[at] ^ (1 << chance() % 8));
    const auto artifact = fromBytes(damaged);
    ASSERT_FALSE(artifact) << at;
    EXPECT_THAT(artifact.error(), HasSubstr("checksum"));
  }
}

TEST(AnArtifact, isRefusedWhereItIsCutOff) {
  for (std::size_t length = 0; length < headOn().size(); length += 997) {
    EXPECT_FALSE(fromBytes(headOn().substr(0, length))) << length;
  }
}

/// As somebody would who knows how the checksum is made.
std::string withChange(const std::function<void(Artifact&)>& change) {
  Artifact artifact = *fromBytes(headOn());
  change(artifact);
  return toBytes(artifact);
}

TEST(AnArtifact, isRefusedWhereAnIndexLeadsNowhere) {
  const auto fault = [](const std::function<void(Artifact&)>& change) {
    const auto artifact = fromBytes(withChange(change));
    return artifact ? std::string("none") : artifact.error();
  };
  EXPECT_THAT(fault([](Artifact& artifact) { artifact.zones.pop_back(); }), HasSubstr("zones or robots"));
  EXPECT_THAT(fault([](Artifact& artifact) { artifact.robots[0].paths.pop_back(); }),
              HasSubstr("paths or stations"));
  EXPECT_THAT(fault([](Artifact& artifact) { artifact.robots[0].paths[0].pieces[3].zones = {7}; }),
              HasSubstr("a zone is named"));
  EXPECT_THAT(fault([](Artifact& artifact) { artifact.robots[0].paths[0].pieces[3].frame = 7; }),
              HasSubstr("no frame"));
  EXPECT_THAT(fault([](Artifact& artifact) { artifact.robots[0].paths[0].places[0].frame = 7; }),
              HasSubstr("no frame or piece"));
  EXPECT_THAT(fault([](Artifact& artifact) { artifact.robots[0].paths[0].places.pop_back(); }),
              HasSubstr("no place"));
}

std::vector<std::string> faultsOfVerification(const std::function<void(Artifact&)>& change) {
  const auto artifact = fromBytes(withChange(change));
  if (!artifact) return {artifact.error()};
  const auto model = modelOf(artifact->program);
  if (!model) return model.error();
  std::vector<std::string> faults;
  for (const auto& part : verifyParts(*model, artifact->supervisors, 100000)) {
    faults.insert(faults.end(), part.faults.begin(), part.faults.end());
  }
  return faults;
}

TEST(TheVerificationOfAnArtifact, hasTeeth) {
  EXPECT_THAT(faultsOfVerification([](Artifact&) {}), IsEmpty());
  EXPECT_THAT(faultsOfVerification([](Artifact& artifact) { artifact.supervisors[0].frontier.clear(); }),
              Contains(HasSubstr("it blocks")));
  EXPECT_THAT(faultsOfVerification([](Artifact& artifact) { artifact.supervisors[0].fingerprint[0] = 'x'; }),
              Contains(HasSubstr("not the supervisor that was synthesized")));
  EXPECT_THAT(faultsOfVerification([](Artifact& artifact) { artifact.supervisors.clear(); }),
              Contains(HasSubstr("has no supervisor")));
  EXPECT_THAT(faultsOfVerification([](Artifact& artifact) {
                std::swap(artifact.program.robots[0].paths[0].steps[0],
                          artifact.program.robots[0].paths[0].steps[1]);
              }),
              Contains(HasSubstr("not the supervisor that was synthesized")));
  EXPECT_THAT(
      faultsOfVerification([](Artifact& artifact) { artifact.program.robots[0].paths[0].steps.pop_back(); }),
      Contains(HasSubstr("has no place")));
}

TEST(ACellOfSafeOrders, isBuiltWithoutATable) {
  const auto artifact = fromBytes(built("iris", Policy::SafeOrder).bytes());
  ASSERT_TRUE(artifact);
  EXPECT_EQ(artifact->supervisors.front().policy, Policy::SafeOrder);
  EXPECT_THAT(artifact->supervisors.front().frontier, IsEmpty());
}

TEST(ABuild, endsWithWhatIsWrong) {
  Cell cell = cellOf("handover");
  cell.robots[0].program[0].steps[0].goal = blocks::RunScriptGoal{};
  CellBuild build(cell, Policy::Supervisor, 1);
  EXPECT_THAT(build.run(BuildStage::Plan), Contains(HasSubstr("programs.RA[0].steps[0]")));
}

TEST(ACycle, hasTheTimesOfItsFrames) {
  const Artifact artifact = *fromBytes(headOn());
  const CellModel model = *modelOf(artifact.program);
  const auto cycle = cycleOf(artifact, model, 0);
  ASSERT_TRUE(cycle) << cycle.error();
  EXPECT_EQ(cycle->events.size(), 8U);
  Duration all{};
  for (const TimedEvent& event : cycle->events) all += event.after;
  EXPECT_EQ(all, artifact.robots[0].paths[0].duration + artifact.robots[0].paths[1].duration);
}

}  // namespace
}  // namespace cobot_command::cell
