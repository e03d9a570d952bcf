#include "cobot_command/cell/supervision/journal.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cobot_command/common/overloaded.h"
#include "cobot_command/common/sha256.h"

namespace cobot_command::cell::journal {
namespace {

using nlohmann::json;

/// Hexadecimal digits of the hash that stand in front of a record: 64 bits.
constexpr std::size_t kChecksumLength = 16;

std::string checksumOf(std::string_view text) {
  return sha256Hex(text).substr(0, kChecksumLength);
}

json toJson(const Snapshot& snapshot) {
  json robots = json::array();
  for (const Snapshot::Robot& one : snapshot.robots) {
    json recent = json::array();
    for (const NumberedEvent& event : one.recent) {
      recent.push_back({event.number, static_cast<int>(event.kind), event.event});
    }
    robots.push_back({{"robot", one.robot},
                      {"session", one.session},
                      {"behind", one.acknowledged},
                      {"recent", std::move(recent)},
                      {"out", one.is_out},
                      {"joins", one.joins}});
  }
  return {{"is", "snapshot"},
          {"instance", snapshot.instance},
          {"epoch", snapshot.epoch},
          {"hash", snapshot.hash},
          {"robots", std::move(robots)},
          {"states", snapshot.states},
          {"held", snapshot.held ? json(*snapshot.held) : json()},
          {"finishing", snapshot.is_finishing},
          {"events", snapshot.events}};
}

json toJson(const Record& record) {
  return std::visit(
      Overloaded{
          [](const Started& one) -> json {
            return {{"is", "started"}, {"instance", one.instance}, {"epoch", one.epoch}, {"hash", one.hash}};
          },
          [](const Joined& one) -> json {
            return {{"is", "joined"},
                    {"robot", one.robot},
                    {"session", one.session},
                    {"behind", one.acknowledged}};
          },
          [](const CarriedOut& one) -> json {
            return {{"is", "event"},
                    {"robot", one.robot},
                    {"session", one.session},
                    {"number", one.event.number},
                    {"kind", static_cast<int>(one.event.kind)},
                    {"event", one.event.event}};
          },
          [](const Recovered& one) -> json {
            return {{"is", "recovered"}, {"robot", one.robot}, {"place", one.place}, {"by", one.person}};
          },
          [](const TakenOut& one) -> json {
            return {{"is", "out"}, {"robot", one.robot}, {"by", one.person}};
          },
          [](const Held& one) -> json {
            return {{"is", "held"}, {"on", one.on}, {"why", one.reason}};
          },
          [](const Finishing& one) -> json {
            return {{"is", "finishing"}, {"on", one.on}};
          },
          [](const Snapshot& one) -> json { return toJson(one); }},
      record);
}

NumberedEvent toEvent(const json& number, const json& kind, const json& event) {
  const int which = kind;
  if (which < 0 || which > static_cast<int>(NumberedEvent::Kind::Withdrawn)) {
    throw json::other_error::create(501, fmt::format("no event is of kind {}", which), &kind);
  }
  return {number, static_cast<NumberedEvent::Kind>(which), event};
}

Snapshot toSnapshot(const json& line) {
  Snapshot snapshot;
  snapshot.instance = line.at("instance");
  snapshot.epoch = line.at("epoch");
  snapshot.hash = line.at("hash");
  for (const json& one : line.at("robots")) {
    Snapshot::Robot robot{one.at("robot"), one.at("session"), one.at("behind"), {},
                          one.at("out"),   one.at("joins")};
    for (const json& event : one.at("recent")) {
      robot.recent.push_back(toEvent(event.at(0), event.at(1), event.at(2)));
    }
    snapshot.robots.push_back(std::move(robot));
  }
  line.at("states").get_to(snapshot.states);
  if (!line.at("held").is_null()) snapshot.held = line.at("held");
  snapshot.is_finishing = line.at("finishing");
  snapshot.events = line.at("events");
  return snapshot;
}

Record fromJson(const json& line) {
  const std::string is = line.at("is");
  if (is == "started") return Started{line.at("instance"), line.at("epoch"), line.at("hash")};
  if (is == "joined") return Joined{line.at("robot"), line.at("session"), line.at("behind")};
  if (is == "recovered") return Recovered{line.at("robot"), line.at("place"), line.at("by")};
  if (is == "out") return TakenOut{line.at("robot"), line.at("by")};
  if (is == "held") return Held{line.at("on"), line.at("why")};
  if (is == "finishing") return Finishing{line.at("on")};
  if (is == "snapshot") return toSnapshot(line);
  if (is != "event") throw json::other_error::create(501, "no record is \"" + is + "\"", &line);
  return CarriedOut{line.at("robot"), line.at("session"),
                    toEvent(line.at("number"), line.at("kind"), line.at("event"))};
}

Result<Record, std::string> fromLine(std::string_view line) {
  const std::string_view text = line.substr(std::min(line.size(), kChecksumLength + 1));
  if (line.size() <= kChecksumLength || line[kChecksumLength] != ' ' ||
      line.substr(0, kChecksumLength) != checksumOf(text)) {
    return refuse(std::string("its checksum is wrong"));
  }
  try {
    return fromJson(json::parse(text));
  } catch (const json::exception& wrong) {
    return refuse(fmt::format("it is not a record: {}", wrong.what()));
  }
}

}  // namespace

const std::string* hashOf(const Record& record) {
  if (const auto* started = std::get_if<Started>(&record)) return &started->hash;
  const auto* snapshot = std::get_if<Snapshot>(&record);
  return snapshot == nullptr ? nullptr : &snapshot->hash;
}

bool tellsOfRobots(const Record& record) {
  if (std::holds_alternative<Joined>(record)) return true;
  const auto* snapshot = std::get_if<Snapshot>(&record);
  return snapshot != nullptr && std::any_of(snapshot->robots.begin(), snapshot->robots.end(),
                                            [](const Snapshot::Robot& one) { return one.joins > 0; });
}

std::string toLine(const Record& record) {
  const std::string text = toJson(record).dump(-1, ' ', true, json::error_handler_t::replace);
  return fmt::format("{} {}\n", checksumOf(text), text);
}

Result<Contents, Damage> read(std::string_view bytes) {
  Contents contents;
  for (std::size_t at = 0, number = 1; at < bytes.size(); ++number) {
    const auto end = bytes.find('\n', at);
    if (end == std::string_view::npos) {
      contents.torn = bytes.size() - at;
      break;
    }
    const auto record = fromLine(bytes.substr(at, end - at));
    if (!record) return refuse(Damage{number, record.error()});
    contents.records.push_back(*record);
    at = end + 1;
  }
  return contents;
}

}  // namespace cobot_command::cell::journal
