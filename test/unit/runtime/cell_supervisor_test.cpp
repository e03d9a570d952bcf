// A supervisor starts with nothing but what is made of its cell, whatever the checksum of the file says.
#include "cobot_command/runtime/cell/cell_supervisor.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "source_tree.h"
#include <gmock/gmock.h>

#include "cobot_command/cell/artifact/cell_build.h"
#include "cobot_command/runtime/cell/cell_files.h"

namespace cobot_command::runtime {
namespace {

using testing::AllOf;
using testing::HasSubstr;

class ASupervisor : public testing::Test {
 protected:
  ASupervisor() {
    char name[] = "/tmp/cell_supervisor_test_XXXXXX";
    if (mkdtemp(name) == nullptr) throw std::runtime_error("no folder for the test");
    folder_ = name;
  }
  ~ASupervisor() override { std::filesystem::remove_all(folder_); }

  [[nodiscard]] std::string in(const std::string& name) const { return folder_ + "/" + name; }

  [[nodiscard]] static cell::Artifact built(const std::string& cell_file) {
    auto cell = readCellFile(cell_file);
    if (!cell) throw std::runtime_error(cell.error().front());
    cell::CellBuild build(*std::move(cell), cell::Policy::Supervisor, 1);
    for (const cell::BuildStage stage : cell::kBuildStages) {
      const auto faults = build.run(stage);
      if (!faults.empty()) throw std::runtime_error(faults.front());
    }
    return *cell::fromBytes(build.bytes());
  }

  /// Empty: it starts.
  [[nodiscard]] std::string faultWith(const cell::Artifact& artifact,
                                      const std::string& cell_file = {}) const {
    std::ofstream(in("artifact")) << toBytes(artifact);
    const auto supervisor =
        CellSupervisor::open({in("artifact"), in("journal"), cell_file}, Deciding::AsBuilt);
    return supervisor ? std::string() : supervisor.error();
  }

  const std::string file_ = test_support::inSourceTree("config/cells/handover.yaml");
  const std::string other_ = test_support::inSourceTree("config/cells/head_on.yaml");

 private:
  std::string folder_;
};

TEST_F(ASupervisor, startsWithWhatWasBuiltOfItsCell) {
  EXPECT_EQ(faultWith(built(file_)), "");
  EXPECT_EQ(faultWith(built(file_), file_), "");
}

TEST_F(ASupervisor, doesNotStartWithHoldsThatAreTooShort) {
  cell::Artifact artifact = built(file_);
  std::size_t& last = *artifact.robots[0].paths[1].holds[0].last_piece;
  last -= 40;
  const auto expected = AllOf(HasSubstr("/robots/0/paths/1/holds/0/last_piece is"), HasSubstr("rebuild it"));
  EXPECT_THAT(faultWith(artifact), expected);
  EXPECT_THAT(faultWith(artifact, file_), expected);
  EXPECT_FALSE(std::filesystem::exists(in("journal"))) << "nothing was begun";
}

TEST_F(ASupervisor, doesNotStartWithTheArtifactOfAnotherCell) {
  EXPECT_THAT(faultWith(built(other_), file_), HasSubstr("was not made from"));
}

}  // namespace
}  // namespace cobot_command::runtime
