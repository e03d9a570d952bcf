#include "cobot_command/robot/read_ledger.h"

#include <cassert>
#include <cstddef>
#include <utility>

#include <fmt/format.h>

#include "cobot_command/common/overloaded.h"
#include "cobot_command/protocol/float_payload.h"

namespace cobot_command::robot {

namespace {

std::string list(const std::vector<script::AttributeRead>& reads) {
  std::string text;
  for (const auto& read : reads) text += (text.empty() ? "" : ", ") + describe(read);
  return text;
}

}  // namespace

void ReadLedger::sent(script::ReadingScript script, std::string script_id, Instant deadline) {
  assert(!waiting());
  script_ = std::move(script);
  script_id_ = std::move(script_id);
  deadline_ = deadline;
  fire(ReadEvent::Send);
}

bool ReadLedger::fire(ReadEvent event) {
  const auto row = findTransition<ReadTable>(state_, event);
  if (!row) return false;
  state_ = row->to;
  if (row->action == ReadAction::Begin) {
    values_.clear();
    broken_.reset();
  }
  return true;
}

bool ReadLedger::take(const protocol::ListenData& data) {
  if (data.channel == script::kMarkChannel && data.payload == script_.mark) return fire(ReadEvent::Mark);
  if (!script::isAttributeChannel(data.channel) || !fire(ReadEvent::Numbers)) return false;
  if (!broken_) store(data);
  return true;
}

void ReadLedger::store(const protocol::ListenData& data) {
  if (values_.size() == script_.reads.size()) {
    broken_ = {Kind::Mixed, {}, fmt::format("TMSTA {} arrived after the last answer", data.channel)};
    return;
  }
  const script::AttributeRead& read = script_.reads[values_.size()];
  const int awaited = channelOf(read.attribute);
  if (data.channel != awaited) {
    broken_ = {
        Kind::Mixed,
        {},
        fmt::format("TMSTA {} arrived where {} was expected for {}", data.channel, awaited, describe(read))};
    return;
  }
  const auto numbers = protocol::parseFloats(data.payload, numbersOf(read.attribute));
  if (numbers) {
    values_.push_back({read, {numbers->begin(), numbers->end()}});
  } else {
    broken_ = {Kind::Payload, {read}, fmt::format("{}: {}", describe(read), numbers.error().message)};
  }
}

std::optional<ReadOutcome> ReadLedger::take(const link::ScriptAnswered& answered) {
  if (!waiting() || answered.id != script_id_) return std::nullopt;
  return std::visit(
      Overloaded{[&](const protocol::ScriptReply& reply) {
                   return end(reply.accepted ? collected() : refuse(failureOf(reply)));
                 },
                 [&](const protocol::CommunicationError& error) {
                   return end(refuse(ReadFailure{Kind::NotTaken, {}, protocol::describe(error)}));
                 },
                 [&](const link::NoReply&) {
                   return end(refuse(ReadFailure{Kind::NoAnswer, {}, "no reply to the read script"}));
                 }},
      answered.answer);
}

ReadFailure ReadLedger::failureOf(const protocol::ScriptReply& reply) const {
  ReadFailure failure{Kind::Refused, {}, "the controller refuses the read script, but no line of it"};
  for (const int line : reply.lines) {
    if (line == script::kFirstReadLine - 1) {
      return {Kind::NoListenSend,
              {},
              fmt::format("the controller refuses ListenSend(), which TMflow before {}.{} does not have",
                          script::kAttributesSince.major, script::kAttributesSince.minor)};
    }
    // What is below the first line wraps around, and is beyond the last one.
    const std::size_t index = static_cast<std::size_t>(line) - script::kFirstReadLine;
    if (index < script_.reads.size()) failure.reads.push_back(script_.reads[index]);
  }
  if (failure.reads.empty()) return failure;
  failure.kind = Kind::Unknown;
  failure.reason =
      fmt::format("the controller refuses {}: its project has no such name", list(failure.reads));
  return failure;
}

ReadOutcome ReadLedger::collected() {
  if (broken_) return refuse(*broken_);
  if (values_.size() == script_.reads.size()) return std::move(values_);
  const auto missing = static_cast<std::ptrdiff_t>(values_.size());
  std::vector<script::AttributeRead> reads(script_.reads.begin() + missing, script_.reads.end());
  std::string reason = fmt::format("the read script was done, but no data arrived for {}", list(reads));
  return refuse(ReadFailure{Kind::Incomplete, std::move(reads), std::move(reason)});
}

ReadOutcome ReadLedger::end(ReadOutcome outcome) {
  fire(ReadEvent::End);
  return outcome;
}

std::optional<ReadOutcome> ReadLedger::advance(Instant now) {
  if (!waiting() || now < deadline_) return std::nullopt;
  return end(refuse(ReadFailure{Kind::NoAnswer, {}, "no reply in time to the read script"}));
}

std::optional<ReadOutcome> ReadLedger::lost(const std::string& reason) {
  if (!waiting()) return std::nullopt;
  return end(refuse(ReadFailure{Kind::Lost, {}, "the link was lost: " + reason}));
}

std::optional<Instant> ReadLedger::nextDeadline() const {
  return waiting() ? std::optional(deadline_) : std::nullopt;
}

}  // namespace cobot_command::robot
