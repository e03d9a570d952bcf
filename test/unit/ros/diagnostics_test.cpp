#include "cobot_command/ros/command/diagnostics.h"

#include <gmock/gmock.h>

namespace cobot_command::ros_adapter {
namespace {

using diagnostic_msgs::DiagnosticStatus;
using LinkState = command::CommandStatus::LinkState;
using ::testing::HasSubstr;

DiagnosticsView ready() {
  DiagnosticsView view;
  view.command.link = LinkState::Ready;
  view.command.host = "192.168.1.2";
  view.command.port = 5890;
  view.command.listen_node = "Listen1";
  view.command.status_stream = true;
  view.robot.emergency_stop = view.robot.safeguard = view.robot.error = false;
  view.robot.project_running = true;
  view.robot.project_paused = false;
  view.robot.joints = arm::JointVector::Zero();
  view.status_rate = 66.4;
  view.status_age = 0.012;
  return view;
}

DiagnosticsView in(LinkState state) {
  DiagnosticsView view = ready();
  view.command.link = state;
  view.command.diagnosis = "connection refused";
  view.command.status_stream = false;
  view.command.status_diagnosis = "Ethernet Slave is off";
  return view;
}

diagnostic_updater::DiagnosticStatusWrapper said(
    void (*describe)(diagnostic_updater::DiagnosticStatusWrapper&, const DiagnosticsView&),
    const DiagnosticsView& view) {
  diagnostic_updater::DiagnosticStatusWrapper status;
  describe(status, view);
  return status;
}

TEST(Diagnostics, everythingIsFineWhileCommandsAreTaken) {
  for (const auto describe : {describeLink, describeListenNode, describeQueue, describeRobot,
                              describeStatusStream, describeExchange}) {
    const auto status = said(describe, ready());
    EXPECT_EQ(status.level, DiagnosticStatus::OK) << status.message;
  }
  EXPECT_THAT(said(describeLink, ready()).message, HasSubstr("192.168.1.2:5890"));
  EXPECT_THAT(said(describeStatusStream, ready()).message, HasSubstr("66 frames"));
}

TEST(Diagnostics, dataThatAreOutOfSyncAreAWarningThatNamesThem) {
  DiagnosticsView view = ready();
  view.group.ri_state = blocks::RiState::Initialized;
  EXPECT_EQ(said(describeExchange, view).level, DiagnosticStatus::OK) << "nothing is compared";
  view.group.out_of_sync = "tool 3 is another one";
  EXPECT_EQ(said(describeExchange, view).level, DiagnosticStatus::WARN);
  EXPECT_EQ(said(describeExchange, view).message, "tool 3 is another one");
  view.group = {};
  view.group.ri_state = blocks::RiState::Synchronized;
  EXPECT_EQ(said(describeExchange, view).level, DiagnosticStatus::OK);
}

TEST(Diagnostics, aLinkThatIsBeingTriedIsAWarningWithTheDiagnosis) {
  const auto status = said(describeLink, in(LinkState::Connecting));
  EXPECT_EQ(status.level, DiagnosticStatus::WARN);
  EXPECT_EQ(status.message, "connection refused");
}

TEST(Diagnostics, aLinkThatNobodyAskedForIsAWarningThatSaysHowToAsk) {
  const auto status = said(describeLink, in(LinkState::Disconnected));
  EXPECT_EQ(status.level, DiagnosticStatus::WARN);
  EXPECT_THAT(status.message, HasSubstr("send a connect goal"));
}

TEST(Diagnostics, aLostLinkIsAnErrorWithWhatWasFound) {
  DiagnosticsView view = in(LinkState::Disconnected);
  command::BlockOutputs connect;
  connect.error = true;
  connect.error_description = "Robot disconnected: no lifesign";
  view.command.blocks = {connect};
  const auto status = said(describeLink, view);
  EXPECT_EQ(status.level, DiagnosticStatus::ERROR);
  EXPECT_THAT(status.message, HasSubstr("no lifesign"));
}

TEST(Diagnostics, aFlowOutsideTheListenNodeIsAWarningButNoFaultOfTheLink) {
  const DiagnosticsView view = in(LinkState::NotListening);
  EXPECT_EQ(said(describeLink, view).level, DiagnosticStatus::OK);
  EXPECT_EQ(said(describeListenNode, view).level, DiagnosticStatus::WARN);
}

TEST(Diagnostics, whatCannotBeKnownIsStale) {
  const DiagnosticsView view = in(LinkState::Disconnected);
  EXPECT_EQ(said(describeListenNode, view).level, DiagnosticStatus::STALE);
  EXPECT_EQ(said(describeRobot, view).level, DiagnosticStatus::STALE);
  EXPECT_EQ(said(describeStatusStream, view).level, DiagnosticStatus::STALE);
}

TEST(Diagnostics, aQueueWithoutAFreeTagIsAWarning) {
  DiagnosticsView view = ready();
  for (int tag = 1; tag <= 15; ++tag) view.command.open_tags.push_back(tag);
  EXPECT_EQ(said(describeQueue, view).level, DiagnosticStatus::WARN);
  view.command.open_tags.pop_back();
  EXPECT_EQ(said(describeQueue, view).level, DiagnosticStatus::OK);
}

TEST(Diagnostics, theWorstOfTheRobotComesFirst) {
  DiagnosticsView view = ready();
  view.robot.project_running = false;
  EXPECT_THAT(said(describeRobot, view).message, HasSubstr("no project"));
  view.robot.project_paused = true;
  EXPECT_THAT(said(describeRobot, view).message, HasSubstr("paused"));
  view.robot.safeguard = true;
  EXPECT_THAT(said(describeRobot, view).message, HasSubstr("safeguard"));
  EXPECT_EQ(said(describeRobot, view).level, DiagnosticStatus::WARN);
  view.robot.error = true;
  view.robot.error_code = 1047;
  view.robot.error_text = "encoder";
  EXPECT_THAT(said(describeRobot, view).message, HasSubstr("1047 encoder"));
  EXPECT_EQ(said(describeRobot, view).level, DiagnosticStatus::ERROR);
  view.robot.emergency_stop = true;
  EXPECT_THAT(said(describeRobot, view).message, HasSubstr("emergency stop"));
  EXPECT_EQ(said(describeRobot, view).level, DiagnosticStatus::ERROR);
}

/// Nobody can say that it is ready without these.
TEST(Diagnostics, aRobotOfWhichTheStreamShowsTooLittleIsReadyOnlyAsFarAsItShows) {
  DiagnosticsView view = ready();
  view.robot.joints.reset();
  view.robot.emergency_stop.reset();
  const auto status = said(describeRobot, view);
  EXPECT_EQ(status.level, DiagnosticStatus::WARN);
  EXPECT_THAT(status.message,
              HasSubstr("ready to move according to the status stream, but the stream lacks"));
  EXPECT_THAT(status.message, HasSubstr("ESTOP (an emergency stop is not detected"));
  EXPECT_THAT(status.message, HasSubstr("Joint_Angle (no joint_states"));
  EXPECT_THAT(status.message, HasSubstr("Ethernet Slave"));
}

TEST(Diagnostics, aMissingStatusStreamIsAWarningOnlyWhenOneIsWanted) {
  DiagnosticsView view = in(LinkState::Ready);
  EXPECT_EQ(said(describeStatusStream, view).level, DiagnosticStatus::WARN);
  EXPECT_EQ(said(describeStatusStream, view).message, "Ethernet Slave is off");
  view.status_wanted = false;
  EXPECT_EQ(said(describeStatusStream, view).level, DiagnosticStatus::OK);
}

TEST(Diagnostics, aStreamWithItemsThatCannotBeReadIsAWarning) {
  DiagnosticsView view = in(LinkState::Ready);
  view.command.status_stream = true;
  view.command.status_diagnosis = "the value of Joint_Angle is invalid";
  EXPECT_EQ(said(describeStatusStream, view).level, DiagnosticStatus::WARN);
  EXPECT_THAT(said(describeStatusStream, view).message, HasSubstr("Joint_Angle"));
  view.command.status_diagnosis.clear();
  EXPECT_EQ(said(describeStatusStream, view).level, DiagnosticStatus::OK);
}

}  // namespace
}  // namespace cobot_command::ros_adapter
