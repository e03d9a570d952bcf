#include <string>

#include "cell_texts.h"
#include <gmock/gmock.h>

#include "cobot_command/common/setting.h"

namespace cobot_command::cell {
namespace {

using ::testing::HasSubstr;

/// The table of section 2 of the specification.
TEST(CellParameters, haveTheirDefaultsAndUnits) {
  EXPECT_EQ(describe(Parameters{}),
            "voxel 20 mm\nstep_bound 10 mm\nmargin 20 mm\ntracking 0.1 deg\nbody_tolerance 0 mm\n"
            "body_cell 30 mm\nspeed_override 1\nzone_size 1000 mm\nzone_overlap 0.5\nsplit auto\n"
            "max_zones 256\nmax_states 5000000\nlease 0.5 s\nreport_period 0.05 s\nlookahead 0.5 s\n"
            "wait_timeout 60 s\naging 10 s\n");
}

TEST(CellParameters, areReadInTheirUnits) {
  const Parameters read = cellOf(kFull).parameters;
  EXPECT_EQ(describe(read),
            "voxel 10 mm\nstep_bound 5 mm\nmargin 30 mm\ntracking 0.2 deg\nbody_tolerance 6 mm\n"
            "body_cell 40 mm\nspeed_override 0.5\nzone_size 600 mm\nzone_overlap 0.25\nsplit never\n"
            "max_zones 100\nmax_states 1000\nlease 1 s\nreport_period 0.1 s\nlookahead 0.25 s\n"
            "wait_timeout 30 s\naging 5 s\n");
  EXPECT_EQ(read.voxel, 0.01) << "[m]";
  EXPECT_EQ(read.split, Split::Never);
}

TEST(CellParameters, areRefusedOutsideOfTheirRanges) {
  const auto faults = [](const std::string& parameter) {
    return faultsOf(with(kExample, "voxel: 20", parameter));
  };
  EXPECT_THAT(faults("voxel: 4.9"), HasSubstr("parameters.voxel is 4.9; allowed: a number, 5 to 100 mm"));
  EXPECT_THAT(faults("voxel: 101"), HasSubstr("parameters.voxel is 101"));
  EXPECT_THAT(faults("voxel: .inf"), HasSubstr("parameters.voxel is the text \".inf\""));
  EXPECT_THAT(faults("voxel: 1e999"), HasSubstr("parameters.voxel is the text"));
  EXPECT_THAT(faults("voxel: \"20\""), HasSubstr("parameters.voxel is the text \"20\""));
  EXPECT_THAT(faults("tracking: 2.1"), HasSubstr("0 to 2 deg"));
  EXPECT_THAT(faults("speed_override: 0.04"), HasSubstr("0.05 to 1"));
  EXPECT_THAT(faults("zone_overlap: 1.1"), HasSubstr("0 to 1"));
  EXPECT_THAT(faults("split: sometimes"), HasSubstr("auto or never"));
  EXPECT_THAT(faults("max_zones: 1.5"), HasSubstr("a whole number"));
  EXPECT_THAT(faults("max_zones: 0"), HasSubstr("1 to 65535"));
  EXPECT_THAT(faults("lease: 11"), HasSubstr("0.1 to 10 s"));
  EXPECT_THAT(faults("voxel: &a [*a]"), HasSubstr("parameters.voxel is a list of 1"));
}

TEST(CellParameters, haveToFitEachOther) {
  EXPECT_THAT(faultsOf(with(kExample, "voxel: 20", "lease: 0.1, report_period: 0.06")),
              HasSubstr("parameters.report_period is more than half of lease"));
  EXPECT_THAT(faultsOf(with(kExample, "voxel: 20", "voxel: 100, zone_size: 60")),
              HasSubstr("parameters.zone_size is below voxel"));
}

TEST(CellParameters, haveAMeaningEach) {
  Parameters parameters;
  for (const Setting& row : parameterTable(parameters)) EXPECT_FALSE(row.meaning.empty()) << row.name;
}

}  // namespace
}  // namespace cobot_command::cell
