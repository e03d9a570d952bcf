// Whatever bytes parameters, goals and messages have: what the nodes tell of them can be shown, and is a
// string that a ROS client can decode.
#include "block_messages.h"
#include "files/named_file.h"
#include "foreign_bytes.h"
#include "own_folder.h"
#include <gmock/gmock.h>

#include "cobot_command/ros/command/command_parameters.h"
#include "cobot_command/ros/mechanism/mechanism_node.h"
#include "cobot_command/ros/simulation/simulator_parameters.h"
#include "cobot_command/ros/supervision/supervisor_parameters.h"

namespace cobot_command::ros_adapter {
namespace {

using test_support::foreignTexts;
using test_support::IsHarmless;

template <class Read>
void expectHarmless(const SettingTable& table, const Read& read) {
  const auto tell = [&](const GivenValues& values) {
    const auto parameters = read(GivenParameters{"/robot/node", values, std::nullopt});
    if (!parameters) {
      EXPECT_THAT(parameters.error().message, IsHarmless());
      return;
    }
    for (const std::string& warning : parameters->warnings) EXPECT_THAT(warning, IsHarmless());
  };
  for (const std::string& text : foreignTexts()) {
    for (const Setting& setting : table) {
      tell({{setting.name, Given{text}}});
      tell({{setting.name, Given{GivenList{Given{text}}}}});
    }
    tell({{text, Given{text}}});
    tell({{text + std::string(100000, 'x'), Given{text}}});
  }
}

TEST(ForeignText, ofParametersIsToldWithoutHarm) {
  CommandParameters command;
  expectHarmless(settingsTable(command),
                 [](const GivenParameters& given) { return readCommandParameters(given); });
  SimulatorNodeSetup simulator;
  expectHarmless(settingsTable(simulator),
                 [](const GivenParameters& given) { return readSimulatorParameters(given); });
  for (const std::string& text : foreignTexts()) {
    for (const char* name : {"artifact", "journal", "cell_file", "policy", "mechanism"}) {
      const GivenParameters given{
          "/robot/node", {{"artifact", Given{text}}, {name, Given{text}}}, std::nullopt};
      const auto supervisor = readSupervisorParameters(given);
      if (!supervisor) {
        EXPECT_THAT(supervisor.error().message, IsHarmless());
      }
      const auto mechanism = readMechanismParameters(given);
      if (!mechanism) {
        EXPECT_THAT(mechanism.error().message, IsHarmless());
      }
    }
  }
}

TEST(ForeignText, ofARobotDescriptionIsToldWithoutHarm) {
  for (const std::string& text : foreignTexts()) {
    const auto parameters =
        readCommandParameters({"/robot/node", {}, Given{"<robot name=\"" + text + "\"/>"}});
    ASSERT_FALSE(parameters);
    EXPECT_THAT(parameters.error().message, IsHarmless());
  }
}

TEST(ForeignText, ofTheTablesFileIsToldWithoutHarm) {
  const OwnFolder folder;
  for (const std::string& text : foreignTexts()) {
    const auto parameters = readCommandParameters(
        {"/robot/node", {{"tables_file", Given{folder.file("tables", text)}}}, std::nullopt});
    if (!parameters) {
      EXPECT_THAT(parameters.error().message, IsHarmless());
    }
  }
}

TEST(ForeignText, ofTheNameOfAFileIsToldWithoutHarm) {
  for (const std::string& text : foreignTexts()) {
    for (const std::string& location : {text, "/no/" + text}) {
      const auto file = readNamedFile("steps_file", location, 1000);
      if (!file) {
        EXPECT_THAT(file.error(), IsHarmless());
      }
    }
  }
  // Each looks through all packages of the machine.
  for (const std::string& name : {test_support::allBytes(), std::string("roscpp/\x1B")}) {
    EXPECT_THAT(readNamedFile("steps_file", "package://" + name, 1000).error(), IsHarmless());
  }
}

TEST(ForeignText, inWhatTheCoreTellsIsHarmlessInResultsAndFeedback) {
  const JointNames names = jointNames("");
  const FillSite site{names, ClockPair{ros::Time(1000), Instant(std::chrono::seconds(50))}};
  for (const std::string& text : foreignTexts()) {
    blocks::Outcome outcome;
    outcome.error_id = 0x110;
    outcome.error_description = text;
    outcome.remedy = text;
    cobot_command::MoveAbsoluteResult result;
    fill(result, outcome, site);
    EXPECT_THAT(result.error_description, IsHarmless());
    EXPECT_THAT(result.remedy, IsHarmless());
    blocks::Progress progress;
    progress.text = text;
    cobot_command::MoveAbsoluteFeedback feedback;
    fill(feedback, progress, site);
    EXPECT_THAT(feedback.text, IsHarmless());
  }
}

}  // namespace
}  // namespace cobot_command::ros_adapter
