#include "cobot_command/command/command_core.h"

#include "core_impl.h"

namespace cobot_command::command {

CommandCore::CommandCore(std::optional<arm::ArmModel> arm, link::LinkSettings settings, CorePorts ports,
                         Planning planning)
    : impl_(std::make_unique<Impl>(std::move(arm), settings, std::move(ports), planning)) {}
CommandCore::~CommandCore() = default;
CommandCore::CommandCore(CommandCore&&) noexcept = default;
CommandCore& CommandCore::operator=(CommandCore&&) noexcept = default;

void CommandCore::submit(blocks::GoalId id, const blocks::Goal& goal, Instant now) {
  impl_->submit(id, goal, now);
}

void CommandCore::cancel(blocks::GoalId id, Instant now, std::optional<blocks::GoalId> newest) {
  impl_->cancel(id, now, newest);
}

FinishReport CommandCore::finish(blocks::FinishAfter after, Instant now,
                                 std::optional<blocks::GoalId> newest) {
  return impl_->finish(after, now, newest);
}

void CommandCore::keepConnected(const blocks::ConnectGoal& target, Instant now) {
  impl_->keepConnected(target, now);
}

void CommandCore::retire(Instant now) {
  impl_->retire(now);
}

bool CommandCore::retired() const {
  return impl_->retired();
}

void CommandCore::shutDown(Instant now) {
  impl_->shutDown(now);
}

void CommandCore::useSettings(const link::LinkSettings& settings, Instant now) {
  impl_->useSettings(settings, now);
}

void CommandCore::useTables(tables::DataTables tables) {
  impl_->tables().use(std::move(tables));
}

TableAnswer CommandCore::writeTable(const TableWrite& write) {
  return impl_->tables().write(write);
}

TableAnswer CommandCore::tryTable(const TableWrite& write) const {
  return impl_->tables().tried(write);
}

std::optional<std::string> CommandCore::switchTracking(const TrackingSwitch& request, Instant now) {
  auto refusal = impl_->arbiter().switchTracking(request);
  impl_->advance(now);
  return refusal;
}

void CommandCore::setFeedrate(const FeedrateRequest& request, const FeedrateReply& reply, Instant now) {
  impl_->arbiter().setFeedrate(request, reply, now);
  impl_->advance(now);
}

void CommandCore::useExchangeRules(const ExchangeRules& rules) {
  impl_->exchange().useRules(rules);
}

void CommandCore::setSpeedOverride(double percent, const OverrideReply& reply, Instant now) {
  impl_->arbiter().setSpeedOverride(percent, reply, now);
  impl_->advance(now);
}

DynamicsAnswer CommandCore::writeDefaults(const blocks::DefaultDynamics& defaults) {
  return impl_->defaults().write(defaults);
}

const blocks::DefaultDynamics& CommandCore::defaults() const {
  return impl_->defaults().defaults();
}

std::optional<ReferenceDynamics> CommandCore::referenceDynamics() const {
  return impl_->limits().reference();
}

DynamicsAnswer CommandCore::writeLimits(const SoftwareLimits& limits, Instant now) {
  DynamicsAnswer answer = impl_->limits().write(limits, impl_->arbiter().underWay());
  impl_->advance(now);
  return answer;
}

std::optional<LimitsReport> CommandCore::limits() const {
  return impl_->limits().limits();
}

void CommandCore::interrupt(const InterruptReply& reply, Instant now) {
  impl_->arbiter().interrupts().interrupt(reply, now);
  impl_->advance(now);
}

void CommandCore::goOn(const InterruptReply& reply, Instant now) {
  impl_->arbiter().interrupts().goOn(reply, now);
  impl_->advance(now);
}

void CommandCore::keepJogging(Instant now) {
  impl_->arbiter().keepJogging();
  impl_->advance(now);
}

ExchangeAnswer CommandCore::updateExchange(const blocks::ExchangeSettings& settings, Instant now) {
  ExchangeAnswer answer = impl_->exchange().update(settings, now);
  impl_->advance(now);
  return answer;
}

ResetAnswer CommandCore::reset(Instant now) {
  ResetAnswer answer = impl_->messages().reset();
  impl_->advance(now);
  return answer;
}

void CommandCore::tellEnd(blocks::Block block, const blocks::Outcome& outcome, Instant now) {
  impl_->messages().tellEnd(block, outcome, now);
  impl_->advance(now);
}

std::vector<Message> CommandCore::messages(Severity least, std::uint32_t after_id) const {
  return impl_->messages().read(least, after_id);
}

void CommandCore::opened(link::ConnectionId id, Instant now) {
  impl_->opened(id, now);
}

void CommandCore::openFailed(link::ConnectionId id, const link::OpenFailure& failure, Instant now) {
  impl_->openFailed(id, failure, now);
}

void CommandCore::received(link::ConnectionId id, std::string_view bytes, Instant now) {
  impl_->received(id, bytes, now);
}

void CommandCore::closed(link::ConnectionId id, const std::string& reason, Instant now) {
  impl_->closed(id, reason, now);
}

void CommandCore::planned(PlanJobId id, PlanAnswer answer, Instant now) {
  impl_->planned(id, std::move(answer), now);
}

void CommandCore::advance(Instant now) {
  impl_->advance(now);
}

std::optional<Instant> CommandCore::nextDeadline() const {
  return impl_->nextDeadline();
}

std::vector<Action> CommandCore::takeActions() {
  return impl_->takeActions();
}

}  // namespace cobot_command::command
