// Names for the ErrorIDs. Texts, remedies and conditions are in the catalogue (error_catalogue.h).
//
// Below 16#200: the numbers of the thesis; their meaning depends on the block. From 16#200: own numbers of
// this layer, with one meaning for all blocks.
#pragma once

namespace cobot_command::blocks {

/// Table 5.3.1.4.
namespace connect_error {
inline constexpr int kTimeoutRange = 0x15;
inline constexpr int kConnection = 0x20;
inline constexpr int kTimeOut = 0x21;
inline constexpr int kClearBuffer = 0x30;
inline constexpr int kGetStatus = 0x40;
inline constexpr int kSend = 0x50;
inline constexpr int kReceive = 0x60;
inline constexpr int kNotACobot = 0x70;
inline constexpr int kGetStatusAgain = 0x80;
inline constexpr int kDisconnected = 0x90;
inline constexpr int kClose = 0x100;
}  // namespace connect_error

/// Table 5.3.2.8, and 16#99 of the annex code. The same numbers have the same meaning in all other blocks
/// that have them; exceptions are below.
namespace motion_error {
inline constexpr int kNotConnected = 0x10;
inline constexpr int kOtherBlockBusy = 0x11;
inline constexpr int kClearBuffer = 0x20;
inline constexpr int kSpeedRangeAbsolute = 0x25;
inline constexpr int kSpeedRangePercent = 0x26;
inline constexpr int kAccelTimeRange = 0x27;
inline constexpr int kCommandIdRange = 0x28;
inline constexpr int kPoseWithLine = 0x29;
inline constexpr int kPose1Range = 0x30;
inline constexpr int kPose2Range = 0x31;
inline constexpr int kPose3Range = 0x32;
inline constexpr int kFormatForPtp = 0x35;
inline constexpr int kFormatForLine = 0x36;
inline constexpr int kChecksumLength = 0x40;
inline constexpr int kFrameBuilding = 0x50;
inline constexpr int kSend = 0x60;
inline constexpr int kReceiveReply = 0x70;
inline constexpr int kRejected = 0x80;
inline constexpr int kClearBufferAgain = 0x90;
inline constexpr int kLinkDropped = 0x99;
inline constexpr int kReceiveTag = 0x100;
inline constexpr int kMotionFailed = 0x110;
}  // namespace motion_error

/// Table 5.3.3.7: differences from MoveAbsolute.
namespace relative_error {
inline constexpr int kFormatForPtp = 0x30;
inline constexpr int kFormatForLine = 0x31;
}  // namespace relative_error

/// Table 5.3.6.6: difference from MoveAbsolute.
namespace tcp_error {
inline constexpr int kWeightRange = 0x25;
}  // namespace tcp_error

namespace own_error {
// The target.
inline constexpr int kNotFinite = 0x200;
inline constexpr int kUnreachable = 0x201;
inline constexpr int kPoseBits = 0x202;
inline constexpr int kJointLimit = 0x203;
inline constexpr int kJointSpeed = 0x204;
inline constexpr int kSingular = 0x205;
inline constexpr int kNotPlannable = 0x206;
inline constexpr int kBlendingTooLarge = 0x207;
inline constexpr int kStartUnknown = 0x208;
inline constexpr int kNoModel = 0x209;
inline constexpr int kAmbiguousTurn = 0x20A;
inline constexpr int kFrameMoved = 0x20B;
inline constexpr int kPlanningBudget = 0x20C;
// The parameters.
inline constexpr int kBlendingRange = 0x210;
inline constexpr int kMovementUnknown = 0x211;
inline constexpr int kPoseWithJoints = 0x212;
inline constexpr int kCoordinateRange = 0x213;
inline constexpr int kNoFreeTag = 0x214;
inline constexpr int kBufferModeUnknown = 0x215;
inline constexpr int kQueueFull = 0x216;
inline constexpr int kFrameUnknown = 0x217;
inline constexpr int kQuaternion = 0x218;
inline constexpr int kPoseNeedsCartesian = 0x219;
inline constexpr int kArcAngleRange = 0x21A;
inline constexpr int kFormatForCircle = 0x21B;
inline constexpr int kProgramCommandUnknown = 0x21C;
inline constexpr int kInertiaRange = 0x21D;
inline constexpr int kScriptInvalid = 0x21E;
inline constexpr int kNameInvalid = 0x21F;
// The controller.
inline constexpr int kNotListening = 0x220;
inline constexpr int kEmergencyStop = 0x221;
inline constexpr int kRobotError = 0x222;
inline constexpr int kTagLost = 0x223;
inline constexpr int kCommunication = 0x224;
inline constexpr int kStopNotConfirmed = 0x225;
inline constexpr int kNotAtTarget = 0x226;
inline constexpr int kOrphanMoves = 0x227;
inline constexpr int kStoppedElsewhere = 0x228;
inline constexpr int kManualMode = 0x229;  // not used under this number yet: load_path has one of its own
// The layer.
inline constexpr int kShutDown = 0x230;
inline constexpr int kBaseUnknown = 0x231;
// 0x232 belongs to the services of the tables: tables/refusal.h.
inline constexpr int kOverrideZero = 0x234;  ///< of the speed: it pauses the robot
inline constexpr int kInterruption = 0x233;  ///< nothing to interrupt or to continue
// The connection.
inline constexpr int kHostInvalid = 0x240;
inline constexpr int kPortRange = 0x241;
inline constexpr int kConnectBusy = 0x242;
// Sequences.
inline constexpr int kStepCount = 0x250;
inline constexpr int kStepRefused = 0x251;
inline constexpr int kStepFailed = 0x252;
inline constexpr int kDwellRange = 0x253;
inline constexpr int kCycleRange = 0x254;
inline constexpr int kOutputInvalid = 0x255;
inline constexpr int kStepsUnreadable = 0x256;
inline constexpr int kOutputFailed = 0x257;
inline constexpr int kBlendBeforeDwell = 0x258;
inline constexpr int kExitBeforeEnd = 0x259;
// Raw scripts.
inline constexpr int kReplyTimeoutRange = 0x260;
// Load, outputs and inputs.
inline constexpr int kLoadRange = 0x261;
inline constexpr int kOutputValue = 0x262;
inline constexpr int kInputInvalid = 0x263;
inline constexpr int kWaitRange = 0x264;
inline constexpr int kInputTimedOut = 0x265;
inline constexpr int kInputUnknown = 0x266;
// Paths.
inline constexpr int kTrackingOffset = 0x270;
inline constexpr int kNotInAScript = 0x271;
inline constexpr int kPvtUnavailable = 0x272;
inline constexpr int kFeedrateRange = 0x273;  ///< of the service; no goal reports it
inline constexpr int kPathDeviates = 0x274;
inline constexpr int kExecutionUnknown = 0x275;
inline constexpr int kRestNotPlanned = 0x276;
inline constexpr int kPvtTooLong = 0x277;
inline constexpr int kDeviationRange = 0x278;
inline constexpr int kPathUnreadable = 0x279;
inline constexpr int kPoseTemplate = 0x27A;
inline constexpr int kNothingDriven = 0x27B;
inline constexpr int kPointNotDriven = 0x27C;
inline constexpr int kNotOnTheWay = 0x27D;
// Cells.
inline constexpr int kNotPermitted = 0x280;
inline constexpr int kPermitLate = 0x281;
inline constexpr int kNotInArtifact = 0x282;
inline constexpr int kNotAtStepStart = 0x283;
inline constexpr int kSettingDiffers = 0x284;
inline constexpr int kSupervisorSilent = 0x285;
inline constexpr int kOffPath = 0x286;
inline constexpr int kOnlyPrograms = 0x287;
inline constexpr int kProgramUnknown = 0x288;
inline constexpr int kRecoveryNeeded = 0x289;
// 0x28A and 0x28B belong to the actions of the supervisor: ros/supervision/supervisor_errors.h.
// Trajectories.
inline constexpr int kTrajectoryInvalid = 0x2A0;
inline constexpr int kJointNames = 0x2A1;
inline constexpr int kStampOld = 0x2A2;
inline constexpr int kNotAtStart = 0x2A3;
inline constexpr int kPathTolerance = 0x2A4;
inline constexpr int kGoalTolerance = 0x2A5;
}  // namespace own_error

/// SRCI numbers, of goals that the interface refuses (exchange_configuration).
namespace interface_error {
inline constexpr int kNotEnabled = 0x8C05;
inline constexpr int kNotSynchronized = 0x8C06;
inline constexpr int kInterrupted = 0x8C30;
}  // namespace interface_error

/// SRCI numbers, of the return to the position of an interruption.
namespace return_error {
inline constexpr int kTooFar = 0x8C07;
inline constexpr int kToolDiffers = 0x8C22;
inline constexpr int kLoadDiffers = 0x8C23;
inline constexpr int kFrameDiffers = 0x8C24;
inline constexpr int kReturnMode = 0x8D30;
inline constexpr int kTrajectoryMode = 0x8D36;
}  // namespace return_error

/// SRCI numbers of WaitTime.
namespace wait_error {
inline constexpr int kTime = 0x8D34;
}  // namespace wait_error

/// SRCI numbers of GroupJog; those of frames and tools: tables/refusal.h.
namespace jog_error {
inline constexpr int kMotionActive = 0x8C33;
inline constexpr int kTwoRotations = 0x8C36;
inline constexpr int kInput = 0x8D12;
}  // namespace jog_error

/// Numbers of Rockwell's manual of LoadPath, which are decimal; those of points and plans:
/// path/path_refusal.h.
namespace load_path_error {
inline constexpr int kNotRegistered = 1000;
inline constexpr int kHandlerNotRunning = 1001;
inline constexpr int kHandlerFaulted = 1002;
inline constexpr int kHandlerState = 1003;
inline constexpr int kNotEnergised = 1005;
inline constexpr int kManualMode = 1006;
inline constexpr int kInterrupted = 1007;
inline constexpr int kFirstNotAbsolute = 1019;
inline constexpr int kOnlyPtp = 1021;
}  // namespace load_path_error

}  // namespace cobot_command::blocks
