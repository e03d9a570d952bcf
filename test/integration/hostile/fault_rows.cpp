#include "fault_rows.h"

#include <utility>

#include "cobot_command/blocks/shared/error_catalogue.h"
#include "cobot_command/blocks/shared/error_ids.h"

namespace cobot_command::hostile {
namespace {

using namespace blocks;
using testing::Direction;
using testing::Fault;
using testing::FaultKind;
using testing::Which;
using Done = Ends::Done;
using Port = testing::FaultProxy::Port;

constexpr Direction kToClient = Direction::ToClient;
constexpr Direction kToController = Direction::ToController;

// How goals end. No reply in time; the link lost; both may come first where nothing comes through any more.
const Ends kDone{Done::Must, {}};
const Ends kNoReply{Done::Never, {motion_error::kReceiveReply}};
const Ends kLost{Done::Never, {motion_error::kLinkDropped}};
const Ends kMayBeLost{Done::May, {motion_error::kLinkDropped}};
const Ends kCutOff{Done::Never, {motion_error::kReceiveReply, motion_error::kLinkDropped}};
const Ends kComplained{Done::Never, {own_error::kCommunication}};
const Ends kNotListening{Done::Never, {own_error::kNotListening}};

Ends ofMotions(int id) {
  return {Done::Never, {id}, Ends::Of::Motions};
}

Fault on(Direction direction, FaultKind kind, Which which = Which::Any) {
  Fault fault;
  fault.kind = kind;
  fault.direction = direction;
  fault.which = which;
  return fault;
}
Fault once(Fault fault, std::size_t first = 0) {
  fault.first = first;
  fault.count = 1;
  return fault;
}
Fault lasting(Fault fault, Duration time, Duration jitter = Duration{}) {
  fault.time = time;
  fault.jitter = jitter;
  return fault;
}
Fault saying(Fault fault, std::string text) {
  fault.text = std::move(text);
  return fault;
}
Fault atRate(Fault fault, double rate) {
  fault.rate = rate;
  return fault;
}

/// These faults at the script port, from before the goal on.
Variant at(std::string name, std::vector<Fault> faults, Ends ends) {
  return {std::move(name),
          [faults = std::move(faults)](HostileRig& rig, Random&) {
            for (const Fault& fault : faults) rig.proxy.add(Port::Script, fault);
          },
          std::move(ends),
          {}};
}
Variant atStatusPort(std::string name, const Fault& fault, Ends ends) {
  return {std::move(name),
          [fault](HostileRig& rig, Random&) { rig.proxy.add(Port::Status, fault); },
          std::move(ends),
          {}};
}
/// Switches of the simulated controller itself.
Variant inController(std::string name, const std::vector<std::string>& faults, Ends ends) {
  return {std::move(name),
          [faults](HostileRig& rig, Random&) {
            for (const std::string& fault : faults) rig.setFault(fault);
          },
          std::move(ends),
          {}};
}
Variant byOperator(std::string name, const simulator::OperatorAction& action, Ends ends) {
  return {std::move(name), [action](HostileRig& rig, Random&) { rig.operate(action); }, std::move(ends), {}};
}
Variant inMotion(std::string name, std::function<void(HostileRig&)> event, Ends ends) {
  return {std::move(name), [](HostileRig&, Random&) {}, std::move(ends), std::move(event), Pace::Lasting};
}

/// The controller has the script all the same, though the goal fails.
Variant executed(Variant variant) {
  variant.pace = Pace::Lasting;
  variant.stops_robot = true;
  return variant;
}

FaultRow connectionsThatFail(std::string name, FaultKind kind) {
  const Fault reset = once(on(kToClient, FaultKind::Reset, Which::Script));
  return {std::move(name),
          {at("of new connections", {on(kToClient, kind)}, kDone),
           at("and the old one is reset", {on(kToClient, kind), reset}, kLost)}};
}

FaultRow endAtEveryFrame(std::string name, FaultKind kind) {
  FaultRow row{std::move(name), {}, true};
  for (const Direction direction : {kToClient, kToController}) {
    for (std::size_t index = 0; index < 5; ++index) {
      const std::string where =
          direction == kToClient ? "to the client, frame " : "to the controller, frame ";
      row.variants.push_back(
          at(where + std::to_string(index), {once(on(direction, kind), index)}, kMayBeLost));
    }
  }
  return row;
}

void addBlackHoles(std::vector<FaultRow>& rows) {
  const Fault hears_nothing = on(kToClient, FaultKind::Drop);
  const Fault says_nothing = on(kToController, FaultKind::Drop);
  Fault after_reply = hears_nothing;
  after_reply.first = 1;
  Ends may_be_cut_off = kCutOff;
  may_be_cut_off.done = Done::May;
  may_be_cut_off.ids.insert(motion_error::kReceiveTag);  // asked for before the link counts as lost
  rows.push_back({"06_black_hole_both_ways",
                  {at("from the goal on", {hears_nothing, says_nothing}, kCutOff),
                   at("behind the first answer", {after_reply}, may_be_cut_off)}});
  rows.push_back(
      {"07_black_hole_one_way",
       {at("to the controller", {says_nothing}, kCutOff), at("to the client", {hears_nothing}, kCutOff)}});
}

void addSegments(std::vector<FaultRow>& rows) {
  rows.push_back({"08_one_byte_a_segment",
                  {at("to the client", {on(kToClient, FaultKind::ByteByByte)}, kDone),
                   at("to the controller", {on(kToController, FaultKind::ByteByByte)}, kDone),
                   atStatusPort("of the stream", on(kToClient, FaultKind::ByteByByte), kDone)}});
  rows.push_back({"09_many_frames_in_one_segment",
                  {at("to the client", {lasting(on(kToClient, FaultKind::Merge), 100ms)}, kDone),
                   at("to the controller", {lasting(on(kToController, FaultKind::Merge), 100ms)}, kDone),
                   atStatusPort("of the stream", lasting(on(kToClient, FaultKind::Merge), 300ms), kDone)}});
  // Longer than the reply timeout, shorter than what the lifesign bears.
  const auto cut = [](Direction direction, Which which) {
    return once(lasting(on(direction, FaultKind::Cut, which), 1900ms));
  };
  rows.push_back({"10_frame_cut_by_a_pause",
                  {at("reply", {cut(kToClient, Which::Script)}, kNoReply),
                   at("script", {cut(kToController, Which::Script)}, kNoReply),
                   at("tag", {cut(kToClient, Which::Tag)}, kDone)}});
}

void addSlowness(std::vector<FaultRow>& rows) {
  rows.push_back(
      {"11_slow_peer",
       {at("to the client", {atRate(on(kToClient, FaultKind::ByteByByte), 10)}, kCutOff),
        at("to the controller", {atRate(on(kToController, FaultKind::ByteByByte), 10)}, kCutOff)}});
  rows.push_back({"12_peer_that_never_reads",
                  {at("controller", {on(kToController, FaultKind::NeverRead)}, kCutOff),
                   at("what the client is sent", {on(kToClient, FaultKind::NeverRead)}, kCutOff)}});
  const auto late = [](Duration time, Duration jitter) {
    return std::vector<Fault>{lasting(on(kToClient, FaultKind::Delay), time, jitter),
                              lasting(on(kToController, FaultKind::Delay), time, jitter)};
  };
  rows.push_back({"13_latency_and_jitter",
                  {at("below the deadlines", late(200ms, 150ms), kDone),
                   at("beyond them", late(500ms, 400ms), {Done::May, {motion_error::kReceiveReply}})}});
}

void addSpoiltFrames(std::vector<FaultRow>& rows) {
  const auto script = [](Direction direction, FaultKind kind) {
    return once(on(direction, kind, Which::Script));
  };
  rows.push_back({"14_wrong_checksum",
                  {at("then good, to the client", {on(kToClient, FaultKind::WrongChecksumThenGood)}, kDone),
                   executed(at("then good, to the controller",
                               {script(kToController, FaultKind::WrongChecksumThenGood)}, kComplained)),
                   at("of the reply", {script(kToClient, FaultKind::WrongChecksum)}, kNoReply),
                   at("of the script", {script(kToController, FaultKind::WrongChecksum)}, kComplained)}});
  rows.push_back({"15_garbage_before_a_frame",
                  {at("to the client", {on(kToClient, FaultKind::Garbage)}, kDone),
                   at("to the controller", {on(kToController, FaultKind::Garbage)}, kDone)}});
  FaultRow lengths{"16_bad_length", {}};
  for (const char* text : {"-5", "abc", "99999999999999999999", "16777217"}) {
    lengths.variants.push_back(at(std::string("of the reply: ") + text,
                                  {saying(script(kToClient, FaultKind::BadLength), text)}, kNoReply));
    lengths.variants.push_back(at(std::string("of the script: ") + text,
                                  {saying(script(kToController, FaultKind::BadLength), text)}, kComplained));
  }
  for (const Direction direction : {kToClient, kToController}) {  // all that comes behind is taken for DATA
    lengths.variants.push_back(at(direction == kToClient ? "swallows answers" : "swallows scripts",
                                  {saying(script(direction, FaultKind::BadLength), "1000000")}, kCutOff));
  }
  rows.push_back(std::move(lengths));
}

void addAnswers(std::vector<FaultRow>& rows) {
  const auto script = [](Direction direction, FaultKind kind) {
    return once(on(direction, kind, Which::Script));
  };
  rows.push_back({"17_unknown_id",
                  {at("of the reply", {script(kToClient, FaultKind::OtherId)}, kNoReply),
                   at("of the script", {script(kToController, FaultKind::OtherId)}, kNoReply)}});
  rows.push_back({"18_doubled", {at("replies and tags", {on(kToClient, FaultKind::Duplicate)}, kDone)}});
  rows.push_back(
      {"19_early_reply",
       {at("before the controller has the script", {on(kToController, FaultKind::AnswerFirst, Which::Script)},
           kDone),
        at("before there is a script", {on(kToController, FaultKind::AnswerAhead, Which::Script)}, kDone)}});
  rows.push_back(
      {"20_late_reply",
       {at("behind its deadline", {lasting(script(kToClient, FaultKind::Overtaken), 1900ms)}, kNoReply)}});
  rows.push_back(
      {"22_cperr_for_a_reply",
       {executed(at("04", {saying(script(kToClient, FaultKind::Cperr), "04")}, kComplained)),
        at("F1", {saying(script(kToClient, FaultKind::Cperr), "F1")}, kNotListening),
        at("for a tag", {saying(once(on(kToClient, FaultKind::Cperr, Which::Tag)), "04")}, kDone)}});
}

void addTags(std::vector<FaultRow>& rows) {
  const auto tag = [](FaultKind kind) { return on(kToClient, kind, Which::Tag); };
  // The robot gets there long after one has looked for it.
  Variant early = inController("early", {"early_tag"}, ofMotions(own_error::kNotAtTarget));
  early.pace = Pace::Lasting;
  rows.push_back(
      {"21_tags",
       {at("dropped", {once(tag(FaultKind::Drop))}, kDone),
        at("dropped, and the answer, too", {tag(FaultKind::Drop)}, ofMotions(motion_error::kReceiveTag)),
        at("reordered", {tag(FaultKind::Swap)}, kDone),
        at("stale", {lasting(tag(FaultKind::Echo), 200ms)}, kDone),
        inController("false", {"false_tag"}, ofMotions(motion_error::kMotionFailed)),
        inController("unknown", {"drop_tag", "query_none"}, ofMotions(own_error::kTagLost)),
        inController("stale behind a stop", {"stale_tag"}, kDone), early}});
}

void addProject(std::vector<FaultRow>& rows) {
  const Ends lost_in_motion = ofMotions(motion_error::kLinkDropped);
  rows.push_back({"23_peer_restarts_in_motion",
                  {inMotion(
                      "ids begin anew", [](HostileRig& rig) { rig.restartRobot(); }, lost_in_motion)}});
  const auto pause_for_a_while = [](HostileRig& rig) {
    rig.operate(simulator::PauseProject{});
    rig.operate(simulator::ResumeProject{});
  };
  Variant paused = byOperator("paused before", simulator::PauseProject{}, kDone);
  paused.meanwhile = [](HostileRig& rig) { rig.operate(simulator::ResumeProject{}); };
  rows.push_back(
      {"24_operator",
       {byOperator("left the Listen node", simulator::LeaveListenNode{}, kNotListening), paused,
        inMotion("pauses in motion", pause_for_a_while, kDone),
        inMotion(
            "stops the project in motion", [](HostileRig& rig) { rig.operate(simulator::StopProject{}); },
            lost_in_motion),
        inMotion(
            "presses the emergency stop",
            [](HostileRig& rig) { rig.operate(simulator::SetEmergencyStop{true}); }, lost_in_motion),
        byOperator("has stopped the project", simulator::StopProject{},
                   {Done::Never, {motion_error::kNotConnected, motion_error::kLinkDropped}})}});
}

void addStream(std::vector<FaultRow>& rows) {
  // Nobody can see whether the robot stands.
  const Ends unseen{Done::May, {own_error::kStopNotConfirmed}, Ends::Of::Stops};
  rows.push_back({"25_status_stream",
                  {atStatusPort("falls silent", on(kToClient, FaultKind::Drop), unseen),
                   atStatusPort("is reset", once(on(kToClient, FaultKind::Reset)), unseen),
                   atStatusPort("has wrong checksums", on(kToClient, FaultKind::WrongChecksum), unseen),
                   atStatusPort("with garbage", on(kToClient, FaultKind::Garbage), kDone)}});
}

/// It is not the goals of this block that the fault is one of; check_sequence needs no robot.
bool isSpared(const BlockCase& block, const Ends& ends) {
  return block.block == kBlock<CheckSequenceGoal> || (ends.of == Ends::Of::Motions && !block.awaits_tag) ||
         (ends.of == Ends::Of::Stops && block.block != kBlock<StopGoal>);
}

}  // namespace

std::vector<FaultRow> faultRows() {
  std::vector<FaultRow> rows{connectionsThatFail("01_refused", FaultKind::Refuse),
                             connectionsThatFail("02_accept_then_silence", FaultKind::Silence),
                             connectionsThatFail("03_accept_then_close", FaultKind::CloseAtOnce),
                             endAtEveryFrame("04_reset_at_every_frame", FaultKind::Reset),
                             endAtEveryFrame("05_close_at_every_frame", FaultKind::Close)};
  addBlackHoles(rows);
  addSegments(rows);
  addSlowness(rows);
  addSpoiltFrames(rows);
  addAnswers(rows);
  addTags(rows);
  addProject(rows);
  addStream(rows);
  return rows;
}

std::set<int> allowedFor(const BlockCase& block, const Ends& ends) {
  const bool stops = block.block == kBlock<StopGoal>;
  if (isSpared(block, ends)) return {};
  std::set<int> ids;
  for (const int id : ends.ids) {
    const bool of_link = id == motion_error::kLinkDropped || id == motion_error::kNotConnected;
    if (of_link || (!stops && block.block != kBlock<PickAndPlaceGoal>)) {
      ids.insert(ownErrorId(block.block, id));
    } else if (stops) {
      ids.insert(own_error::kStopNotConfirmed);
    } else {
      ids.insert({own_error::kStepFailed, own_error::kOutputFailed});
    }
  }
  return ids;
}

Ends::Done doneFor(const BlockCase& block, const Ends& ends) {
  return isSpared(block, ends) ? Done::Must : ends.done;
}

}  // namespace cobot_command::hostile
