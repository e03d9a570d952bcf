#include "core_rig.h"

#include <utility>

namespace cobot_command::testing {

using namespace blocks;
using namespace command;

CoreRig::CoreRig(std::optional<arm::ArmModel> arm, link::LinkSettings settings, Planning planning)
    : core(std::move(arm), settings, ports(), planning) {}

CorePorts CoreRig::ports() {
  CorePorts all;
  all.frames = [this](const std::string& frame) -> std::optional<arm::Pose> {
    const auto found = frames.find(frame);
    return found == frames.end() ? std::nullopt : std::make_optional(found->second);
  };
  all.newest = [this] { return last_goal_; };
  all.gate = [this](const Departure& departure, Instant at) {
    return gate ? gate(departure, at) : std::nullopt;
  };
  all.program = program;
  return all;
}

CoreRig::~CoreRig() {
  EXPECT_TRUE(sent_.empty()) << sent_.size() << " frames were sent that the test did not expect; the first: "
                             << protocol::describe(sent_.front());
}

link::LinkSettings CoreRig::noStatus() {
  link::LinkSettings settings;
  settings.status_port = 0;
  return settings;
}

MoveAbsoluteGoal CoreRig::move(BufferMode mode) {
  MoveAbsoluteGoal goal;
  goal.target = {417.5, -122.3, 343.9, 180, 0, 90};
  goal.speed = 10;
  goal.accel_time = 200;
  goal.buffer_mode = static_cast<int>(mode);
  return goal;
}

MoveAbsoluteGoal CoreRig::blended(double percent) {
  MoveAbsoluteGoal goal = move();
  goal.blending_enable = true;
  goal.blending_value = percent;
  return goal;
}

ConnectGoal CoreRig::robot() {
  ConnectGoal goal;
  goal.host = "robot";
  return goal;
}

GoalId CoreRig::submit(const Goal& goal) {
  const GoalId id = come();
  handOn(id, goal);
  return id;
}

void CoreRig::handOn(GoalId id, const Goal& goal) {
  core.submit(id, goal, now);
  pump();
}

void CoreRig::cancel(GoalId id) {
  core.cancel(id, now);
  pump();
}

void CoreRig::shutDown() {
  core.shutDown(now);
  pump();
}

GoalId CoreRig::connect() {
  const GoalId id = submit(robot());
  open();
  if (pendingOpen(link::Channel::Status)) {
    open(link::Channel::Status);
    status({});  // a stream without a single item: nothing is known, and nobody waits for it any more
  }
  EXPECT_EQ(latest().link, CommandStatus::LinkState::Ready);
  return id;
}

std::optional<OpenConnection> CoreRig::pendingOpen(link::Channel channel) const {
  const auto found = opening_.find(channel);
  return found == opening_.end() ? std::nullopt : std::make_optional(found->second);
}

void CoreRig::open(link::Channel channel) {
  const auto pending = pendingOpen(channel);
  ASSERT_TRUE(pending.has_value()) << "the core does not want to open a connection";
  opening_.erase(channel);
  connections_[channel] = Connection{pending->id, true};
  if (channel == link::Channel::Script) decoder_.reset();
  core.opened(pending->id, now);
  pump();
}

void CoreRig::failOpen(link::OpenFailure::Kind kind, link::Channel channel) {
  const auto pending = pendingOpen(channel);
  ASSERT_TRUE(pending.has_value()) << "the core does not want to open a connection";
  opening_.erase(channel);
  core.openFailed(pending->id, {kind, "as the system says"}, now);
  pump();
}

void CoreRig::close(const std::string& reason, link::Channel channel) {
  const auto found = connections_.find(channel);
  ASSERT_NE(found, connections_.end());
  const link::ConnectionId id = found->second.id;
  connections_.erase(found);
  core.closed(id, reason, now);
  pump();
}

void CoreRig::receive(const std::string& bytes, link::Channel channel) {
  const auto found = connections_.find(channel);
  ASSERT_NE(found, connections_.end());
  core.received(found->second.id, bytes, now);
  pump();
}

void CoreRig::reply(const std::string& id, bool accepted, std::vector<int> lines) {
  say(protocol::ScriptReply{id, accepted, std::move(lines)});
}

void CoreRig::tag(int number, protocol::TagState state) {
  say(protocol::TagReport{number, state});
}

void CoreRig::status(const std::vector<protocol::StatusItem>& items) {
  receive(protocol::encode(protocol::StatusFrame{"0", 1, protocol::encodeBinaryItems(items)}),
          link::Channel::Status);
}

void CoreRig::stream(const std::vector<protocol::StatusItem>& items, int count) {
  for (int i = 0; i < count; ++i) {
    if (i > 0) pass(kStreamPeriod);
    status(items);
  }
}

void CoreRig::streamFor(Duration duration, const std::vector<protocol::StatusItem>& items, Duration period) {
  for (Duration t{}; t < duration; t += period) {
    pass(period);
    status(items);
  }
}

protocol::ScriptRequest CoreRig::takeScript() {
  if (sent_.empty() || !std::holds_alternative<protocol::ScriptRequest>(sent_.front())) {
    ADD_FAILURE() << "no script was sent";
    return {};
  }
  auto request = std::get<protocol::ScriptRequest>(sent_.front());
  sent_.pop_front();
  return request;
}

protocol::TagQuery CoreRig::takeTagQuery() {
  if (sent_.empty() || !std::holds_alternative<protocol::TagQuery>(sent_.front())) {
    ADD_FAILURE() << "no tag was asked for";
    return {};
  }
  const auto query = std::get<protocol::TagQuery>(sent_.front());
  sent_.pop_front();
  return query;
}

void CoreRig::pass(Duration duration) {
  const Instant end = now + duration;
  while (true) {
    const auto deadline = core.nextDeadline();
    if (!deadline || *deadline > end) break;
    now = std::max(now, *deadline);
    core.advance(now);
    pump();
  }
  now = end;
  core.advance(now);
  pump();
}

const Outcome* CoreRig::outcome(GoalId id) const {
  const auto found = ended_.find(id);
  return found == ended_.end() ? nullptr : &found->second;
}

const BlockOutputs& CoreRig::outputs(Block block) const {
  return latest_.blocks.at(static_cast<std::size_t>(block));
}

void CoreRig::pump() {
  for (const Action& action : core.takeActions()) {
    std::visit([this](const auto& a) { take(a); }, action);
  }
  answerLifesigns();
}

void CoreRig::answerLifesigns() {
  for (std::size_t i = 0; answers_lifesigns && i < sent_.size();) {
    if (!std::holds_alternative<protocol::ListenNodeQuery>(sent_[i])) {
      ++i;
      continue;
    }
    sent_.erase(sent_.begin() + static_cast<std::ptrdiff_t>(i));
    if (!connectionOpen(link::Channel::Script)) continue;  // closed in the same instant
    say(protocol::ListenNodeState{listening, listening ? listen_node : ""});
    return;  // say() pumps again
  }
}

void CoreRig::take(const OpenConnection& action) {
  ++opens;
  opening_.insert_or_assign(action.channel, action);
}

void CoreRig::take(const CloseConnection& action) {
  for (auto it = connections_.begin(); it != connections_.end();) {
    it = it->second.id == action.id ? connections_.erase(it) : std::next(it);
  }
  for (auto it = opening_.begin(); it != opening_.end();) {
    it = it->second.id == action.id ? opening_.erase(it) : std::next(it);
  }
}

void CoreRig::take(const SendBytes& action) {
  const auto status = connections_.find(link::Channel::Status);
  // Who the controller is: nobody answers that here.
  if (status != connections_.end() && status->second.id == action.id) return;
  const auto script = connections_.find(link::Channel::Script);
  ASSERT_NE(script, connections_.end()) << "bytes for a connection that is not open";
  ASSERT_EQ(script->second.id, action.id);
  decoder_.feed(action.bytes);
  while (const auto event = decoder_.next()) {
    ASSERT_TRUE(std::holds_alternative<protocol::Frame>(*event));
    const auto message = protocol::parseClientMessage(std::get<protocol::Frame>(*event));
    ASSERT_TRUE(message.has_value());
    if (std::holds_alternative<protocol::ScriptRequest>(*message)) ++scripts_sent;
    sent_.push_back(*message);
  }
}

void CoreRig::take(const GoalAccepted& action) {
  EXPECT_TRUE(accepted_.emplace(action.goal, true).second) << "goal accepted twice";
  EXPECT_EQ(ended_.count(action.goal), 0u) << "goal accepted after its end";
}

void CoreRig::take(const GoalProgressed& action) {
  const bool waits = action.progress.phase == Phase::Queued && action.progress.place_in_queue > 0;
  EXPECT_EQ(accepted(action.goal), !waits);
  EXPECT_EQ(ended_.count(action.goal), 0u) << "progress after the end";
  progress_[action.goal].push_back(action.progress);
}

void CoreRig::take(const GoalEnded& action) {
  if (action.outcome.ending != Ending::CommandAborted) {  // also what still waits can fall
    EXPECT_EQ(accepted(action.goal), action.outcome.ending != Ending::Rejected);
  }
  EXPECT_TRUE(ended_.emplace(action.goal, action.outcome).second) << "goal ended twice";
  const bool error = action.outcome.ending == Ending::Rejected || action.outcome.ending == Ending::Aborted;
  EXPECT_EQ(action.outcome.error_id != 0, error);
}

void CoreRig::take(const StatusChanged& action) {
  latest_ = action.status;
  for (const BlockOutputs& o : latest_.blocks) {
    EXPECT_LE(o.busy + o.done + o.error + o.command_aborted, 1);
    EXPECT_LE(o.active + o.done + o.error + o.command_aborted, 1);
    EXPECT_EQ(o.error, o.error_id != 0);
  }
}

void CoreRig::take(const RobotStatusReceived& action) {
  robot_statuses.push_back(action.status);
}

void CoreRig::take(const ActiveFramesChanged& action) {
  active_frames.push_back(action.frames);
}

void CoreRig::take(const TablesChanged& action) {
  told_tables.push_back(action.tables);
}

void CoreRig::take(const PathPlanned& /*action*/) {
  ++planned_paths;
}

void CoreRig::take(const GoalPreviewed& action) {
  previews.push_back(action);
}

void CoreRig::take(const PlanAsked& action) {
  plans_.push_back(action);
}

void CoreRig::answerPlan(PlanAnswer answer) {
  const PlanJobId id = plans_.front().id;
  plans_.pop_front();
  core.planned(id, std::move(answer), now);
  pump();
}

void CoreRig::finishPlanToSend() {
  const auto plan = std::find_if(plans_.begin(), plans_.end(),
                                 [](const PlanAsked& asked) { return asked.lane == PlanLane::Send; });
  ASSERT_NE(plan, plans_.end()) << "nothing is planned to be sent";
  const PlanAsked asked = *plan;
  plans_.erase(plan);
  core.planned(asked.id, asked.work(), now);
  pump();
}

void CoreRig::take(const CommandsFell& action) {
  fell.push_back(action);
}

void CoreRig::take(const FrameTraced& action) {
  traces.push_back(action);
}

void CoreRig::take(const LogMessage& action) {
  if (action.severity == Severity::Warning) warnings.push_back(action.text);
}

}  // namespace cobot_command::testing
