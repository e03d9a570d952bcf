// Every fault with a connect goal: it connects in spite of it, or ends at its timeout with an ErrorID and a
// text that name the cause, and the next connect works. All rows run side by side, as a timeout is 10 s at
// least.
#include <functional>
#include <thread>

#include "block_cases.h"
#include "hostile_rig.h"
#include <gmock/gmock.h>

#include "cobot_command/blocks/shared/error_ids.h"

namespace cobot_command::hostile {
namespace {

using namespace blocks;
using testing::Direction;
using testing::Fault;
using testing::FaultKind;
using ::testing::HasSubstr;
using Port = testing::FaultProxy::Port;

struct ConnectRow {
  std::string name;
  std::function<void(HostileRig&)> before;
  int error_id = 0;  ///< 0: it connects
  std::string words;
};

ConnectRow at(std::string name, const std::vector<Fault>& faults, int error_id = 0, std::string words = "") {
  return {std::move(name),
          [faults](HostileRig& rig) {
            for (const Fault& fault : faults) rig.proxy.add(Port::Script, fault);
          },
          error_id, std::move(words)};
}
ConnectRow inController(const std::string& fault, int error_id, std::string words) {
  return {fault, [fault](HostileRig& rig) { rig.setFault(fault); }, error_id, std::move(words)};
}
ConnectRow byOperator(std::string name, const simulator::OperatorAction& action, int error_id,
                      std::string words) {
  return {std::move(name), [action](HostileRig& rig) { rig.operate(action); }, error_id, std::move(words)};
}

Fault every(FaultKind kind, Direction direction = Direction::ToClient) {
  Fault fault;
  fault.kind = kind;
  fault.direction = direction;
  return fault;
}
Fault first(FaultKind kind, Direction direction) {
  Fault fault = every(kind, direction);
  fault.count = 1;
  return fault;
}
Fault saying(FaultKind kind, const std::string& text) {
  Fault fault = every(kind);
  fault.text = text;
  return fault;
}
Fault late(Direction direction) {
  Fault fault = every(FaultKind::Delay, direction);
  fault.time = 200ms;
  fault.jitter = 150ms;
  return fault;
}
Fault merged(Direction direction) {
  Fault fault = every(FaultKind::Merge, direction);
  fault.time = 100ms;
  return fault;
}
Fault slow() {
  Fault fault = every(FaultKind::ByteByByte);
  fault.rate = 2;
  return fault;
}

constexpr Direction kToClient = Direction::ToClient;
constexpr Direction kToController = Direction::ToController;
constexpr int kNoConnection = connect_error::kConnection;
constexpr int kNotACobot = connect_error::kNotACobot;
constexpr const char* kNobody = "nothing answers";
constexpr const char* kForeign = "does not speak the protocol";

std::vector<ConnectRow> connectRows() {
  return {
      at("refused", {every(FaultKind::Refuse)}, kNoConnection, "refused"),
      at("accepted, then silence", {every(FaultKind::Silence)}, kNotACobot, kNobody),
      at("accepted, then closed", {every(FaultKind::CloseAtOnce)}, kNoConnection,
         "closed the connection at once"),
      at("reset once, by the peer", {first(FaultKind::Reset, kToClient)}),
      at("reset once, at the question", {first(FaultKind::Reset, kToController)}),
      at("closed once, by the peer", {first(FaultKind::Close, kToClient)}),
      at("closed once, at the question", {first(FaultKind::Close, kToController)}),
      at("black hole both ways", {every(FaultKind::Drop), every(FaultKind::Drop, kToController)}, kNotACobot,
         kNobody),
      at("black hole to the client", {every(FaultKind::Drop)}, kNotACobot, kNobody),
      at("one byte a segment", {every(FaultKind::ByteByByte), every(FaultKind::ByteByByte, kToController)}),
      at("many frames in one segment", {merged(kToClient), merged(kToController)}),
      at("2 bytes a second", {slow()}, kNotACobot, ""),
      at("never reads", {every(FaultKind::NeverRead)}, kNotACobot, kNobody),
      at("latency and jitter", {late(kToClient), late(kToController)}),
      at("wrong checksums", {every(FaultKind::WrongChecksum)}, kNotACobot, kForeign),
      at("wrong checksum, then good", {every(FaultKind::WrongChecksumThenGood)}),
      at("garbage before each frame", {every(FaultKind::Garbage)}),
      at("negative lengths", {saying(FaultKind::BadLength, "-1")}, kNotACobot, kForeign),
      at("lengths of 20 digits", {saying(FaultKind::BadLength, "99999999999999999999")}, kNotACobot,
         kForeign),
      at("a length that swallows all", {saying(FaultKind::BadLength, "1000000")}, kNotACobot, kForeign),
      at("doubled", {every(FaultKind::Duplicate)}),
      at("nothing but CPERR", {saying(FaultKind::Cperr, "04")}, kNotACobot, ""),
      inController("impostor", kNotACobot, kForeign),
      inController("silence", kNotACobot, kNobody),
      inController("close_on_connect", kNoConnection, "closed the connection at once"),
      // The proxy accepts these two, is refused itself, and resets what it has accepted.
      inController("refuse_connections", kNoConnection, ""),
      byOperator("stopped the project", simulator::StopProject{}, kNoConnection, ""),
      byOperator("left the Listen node", simulator::LeaveListenNode{}, connect_error::kTimeOut,
                 "not in a Listen node"),
      {"no status stream", [](HostileRig& rig) { rig.proxy.add(Port::Status, every(FaultKind::Drop)); }, 0,
       ""},
      {"status port refused", [](HostileRig& rig) { rig.proxy.add(Port::Status, every(FaultKind::Refuse)); },
       0, ""},
  };
}

void expectNextConnectToWork(HostileRig& rig) {
  rig.proxy.heal();
  rig.operate(simulator::ClearFaults{});
  if (!rig.robot().state().project_running) rig.operate(simulator::RunProject{});
  rig.operate(simulator::EnterListenNode{});
  (void)rig.connect();
  const BlockCase proof = proofOfWork();
  const auto outcome = rig.layer.endOf(rig.layer.submit(proof.goal));
  ASSERT_TRUE(outcome.has_value());
  EXPECT_EQ(outcome->ending, Ending::Done) << outcome->error_description;
  EXPECT_EQ(proof.lie(rig.robot().state()), "");
}

void tryRow(const ConnectRow& row, unsigned seed) {
  SCOPED_TRACE("connect with \"" + row.name + "\"");
  HostileRig rig(seed);
  row.before(rig);
  const GoalId goal = rig.layer.submit(rig.controller());
  ASSERT_TRUE(rig.layer.waitUntil([&](const Told& told) {
    return told.ended(goal) || told.reached(goal, Phase::Connected);
  })) << "neither connected nor ended";
  if (row.error_id == 0) {
    EXPECT_TRUE(rig.layer.told().reached(goal, Phase::Connected));
    rig.layer.cancel(goal);
  }
  const auto outcome = rig.layer.endOf(goal);
  ASSERT_TRUE(outcome.has_value());
  EXPECT_EQ(outcome->ending, row.error_id == 0 ? Ending::Done : Ending::Aborted)
      << outcome->error_description;
  EXPECT_EQ(outcome->error_id, row.error_id) << outcome->error_description;
  EXPECT_THAT(outcome->error_description, HasSubstr(row.words));
  expectNextConnectToWork(rig);
  rig.layer.stop();
  for (const auto& [id, ends] : rig.layer.told().ends) EXPECT_EQ(ends.size(), 1u) << "goal " << id;
}

TEST(ConnectMatrix, connectsOrNamesTheCause) {
  const auto rows = connectRows();
  std::vector<std::thread> threads;
  for (unsigned i = 0; i < rows.size(); ++i) {
    threads.emplace_back([&row = rows[i], i] { tryRow(row, i); });
  }
  for (std::thread& thread : threads) thread.join();
}

}  // namespace
}  // namespace cobot_command::hostile
