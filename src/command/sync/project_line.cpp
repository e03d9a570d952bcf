#include "sync/project_line.h"

#include <utility>

#include <fmt/format.h>

#include "cobot_command/common/overloaded.h"

namespace cobot_command::command {
namespace {

ProjectLine::Result resultOf(const link::ScriptAnswered& answered) {
  using Result = ProjectLine::Result;
  return std::visit(
      Overloaded{[](const protocol::ScriptReply& reply) -> Result {
                   if (reply.accepted) return ProjectLine::Written{};
                   return ProjectLine::NotWritten{fmt::format(
                       "the controller refuses line {} of the write script", fmt::join(reply.lines, ", "))};
                 },
                 [](const protocol::CommunicationError& error) -> Result {
                   return ProjectLine::NotWritten{protocol::describe(error)};
                 },
                 [](const link::NoReply&) -> Result {
                   return ProjectLine::NotWritten{"no reply to the write script"};
                 }},
      answered.answer);
}

}  // namespace

bool ProjectLine::isFree() const {
  return script_.state() == link::ScriptLinkState::Ready && !script_.requests().awaitsScript() &&
         !isReading() && !writing_;
}

void ProjectLine::read(std::vector<script::AttributeRead> reads, Instant now) {
  // The instant makes it another one than those of other command layers.
  script::ReadingScript script{fmt::format("cobot_command {:x} {}", now.time_since_epoch().count(), ++marks_),
                               std::move(reads)};
  std::string id = script_.sendScript(toText(script), now);
  ledger_.sent(std::move(script), std::move(id), now + 2 * settings_.reply_timeout);
}

void ProjectLine::write(const std::vector<script::AttributeWrite>& writes, Instant now) {
  writing_ = script_.sendScript(toText(writes), now);
}

void ProjectLine::forget() {
  static_cast<void>(ledger_.lost("no client waits for it"));
  writing_.reset();
  result_.reset();
}

bool ProjectLine::take(const link::ScriptAnswered& answered) {
  if (auto outcome = ledger_.take(answered)) {
    result_ = *std::move(outcome);
  } else if (writing_ == answered.id) {
    writing_.reset();
    result_ = resultOf(answered);
  } else {
    return false;
  }
  return true;
}

void ProjectLine::advance(Instant now) {
  if (auto outcome = ledger_.advance(now)) result_ = *std::move(outcome);
}

}  // namespace cobot_command::command
