// Names for the ErrorIDs. Texts, remedies and conditions are in the catalogue (error_catalogue.h).
//
// Below 16#200: the thesis's numbers, whose meaning depends on the block. From 16#200: this layer's own, with
// one meaning for all blocks.
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

/// Table 5.3.2.8, and 16#99 of annex code. The same numbers mean the same in the other motion blocks.
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

namespace own_error {
// The target.
inline constexpr int kNotFinite = 0x200;
inline constexpr int kUnreachable = 0x201;
inline constexpr int kPoseBits = 0x202;
inline constexpr int kJointLimit = 0x203;
inline constexpr int kJointSpeed = 0x204;
inline constexpr int kSingular = 0x205;
inline constexpr int kNotPlannable = 0x206;
// The parameters.
inline constexpr int kBlendingRange = 0x210;
inline constexpr int kMovementUnknown = 0x211;
inline constexpr int kPoseWithJoints = 0x212;
inline constexpr int kCoordinateRange = 0x213;
inline constexpr int kNoFreeTag = 0x214;
// The controller.
inline constexpr int kNotListening = 0x220;
inline constexpr int kEmergencyStop = 0x221;
inline constexpr int kRobotError = 0x222;
inline constexpr int kTagLost = 0x223;
inline constexpr int kCommunication = 0x224;
inline constexpr int kStopNotConfirmed = 0x225;
// The layer.
inline constexpr int kShutDown = 0x230;
// The connection.
inline constexpr int kHostInvalid = 0x240;
inline constexpr int kPortRange = 0x241;
inline constexpr int kConnectBusy = 0x242;
}  // namespace own_error

}  // namespace cobot_command::blocks
