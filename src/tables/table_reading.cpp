#include <algorithm>
#include <map>
#include <utility>

#include "file_frame.h"
#include "table_scanner.h"
#include <fmt/format.h>

#include "cobot_command/common/foreign_text.h"
#include "cobot_command/tables/table_text.h"

namespace cobot_command::tables {
namespace {

constexpr double kM2PerMm2 = 1e-6;

/// One entry as somebody wrote it.
struct Written {
  std::string place;
  std::string_view text;   ///< all that stands there
  std::size_t before = 0;  ///< what of it is in front of the entry
  EntryEnd end = EntryEnd::Text;
};

/// Fills the tables entry by entry, and remembers where each stood.
class Reading {
 public:
  /// Nothing when it was taken.
  std::optional<TextFault> take(Kind kind, const Written& written);
  Result<DataTables, TextFault> result(const Payload& payload) &&;

 private:
  std::optional<std::string> fill(Kind kind, const EntryText& entry);
  std::optional<std::string> fillLoad(const EntryText& entry);
  template <class Entry>
  std::optional<std::string> fillPlaced(Kind kind, Table<Entry>& table, int Entry::*refers_to,
                                        const EntryText& text);

  Entries entries_;
  std::map<std::pair<Kind, int>, TextFault> places_;  ///< with no reason
};

/// Six numbers from there on. The error is the reason.
Result<arm::Pose, std::string> poseOf(const std::vector<double>& numbers, std::size_t first) {
  arm::ControllerPose six{};
  std::copy_n(numbers.begin() + static_cast<std::ptrdiff_t>(first), six.size(), six.begin());
  const auto pose = poseIn(six);
  if (!pose) return refuse(fmt::format("{}; allowed: {}", pose.error().found, pose.error().allowed));
  return *pose;
}

template <class Entry>
std::optional<std::string> Reading::fillPlaced(Kind kind, Table<Entry>& table, int Entry::*refers_to,
                                               const EntryText& text) {
  Entry entry;
  entry.name = text.name.value_or("");
  entry.*refers_to = text.refers_to.value_or(0);
  if (text.name && text.name->empty()) return "the name is empty";
  if (!text.numbers.empty()) {
    if (text.numbers.size() != 6) {
      return fmt::format("there are {} numbers; a {} has six: x,y,z in mm and rx,ry,rz in degrees",
                         text.numbers.size(), toString(kind));
    }
    const auto pose = poseOf(text.numbers, 0);
    if (!pose) return pose.error();
    entry.pose = *pose;
  }
  table[static_cast<std::size_t>(text.index)] = std::move(entry);
  return std::nullopt;
}

std::optional<std::string> Reading::fillLoad(const EntryText& text) {
  constexpr std::size_t kAll = 10;
  if (text.name) return "a load has no name, only numbers";
  if (text.refers_to) return "a load cannot refer to another entry: remove the @";
  if (text.numbers.size() != 1 && text.numbers.size() != kAll) {
    return fmt::format(
        "there are {} numbers; a load has its mass in kg, or ten: kg, Ixx,Iyy,Izz in kg mm^2, "
        "and x,y,z,rx,ry,rz of its centre in mm and degrees",
        text.numbers.size());
  }
  Load load;
  load.mass = text.numbers[0];
  if (text.numbers.size() == kAll) {
    for (std::size_t i = 0; i < load.inertia.size(); ++i) load.inertia[i] = text.numbers[1 + i] * kM2PerMm2;
    const auto centre = poseOf(text.numbers, 4);
    if (!centre) return centre.error();
    load.centre = *centre;
  }
  entries_.loads[static_cast<std::size_t>(text.index)] = load;
  return std::nullopt;
}

std::optional<std::string> Reading::fill(Kind kind, const EntryText& text) {
  if (!isIndex(text.index) || text.index == 0) {
    return fmt::format("{} {} cannot be set; allowed: 1 to {}", toString(kind), text.index, kEntryCount - 1);
  }
  const auto there = places_.find({kind, text.index});
  if (there != places_.end()) {
    return fmt::format("{} {} is in {} already", toString(kind), text.index, there->second.place);
  }
  if (kind == Kind::Tool) return fillPlaced(kind, entries_.tools, &Tool::load, text);
  if (kind == Kind::Frame) return fillPlaced(kind, entries_.frames, &Frame::reference, text);
  return fillLoad(text);
}

std::optional<TextFault> Reading::take(Kind kind, const Written& written) {
  TextFault place{kind, written.place, std::string(written.text), ""};
  const auto scanned = scanEntry(written.text.substr(written.before), written.end, written.before);
  const auto reason = scanned ? fill(kind, *scanned) : scanned.error();
  if (reason) {
    place.reason = *reason;
    return place;
  }
  places_.emplace(std::pair(kind, scanned->index), std::move(place));
  return std::nullopt;
}

Result<DataTables, TextFault> Reading::result(const Payload& payload) && {
  auto tables = DataTables::of(std::move(entries_), payload);
  if (tables) return *std::move(tables);
  TextFault fault = places_.at({tables.error().kind, tables.error().index});
  fault.reason = describe(tables.error());
  return refuse(std::move(fault));
}

std::string_view withoutEnd(std::string_view line) {
  return !line.empty() && line.back() == '\r' ? line.substr(0, line.size() - 1) : line;
}

/// The kind of the line's entry, and where that begins; nothing when there is none.
std::optional<std::pair<Kind, std::size_t>> kindOf(std::string_view line, std::size_t begin) {
  for (const Kind kind : {Kind::Tool, Kind::Frame, Kind::Load}) {
    const std::string_view word = toString(kind);
    const std::size_t end = begin + word.size();
    if (line.substr(begin, word.size()) == word && end < line.size() &&
        (line[end] == ' ' || line[end] == '\t')) {
      return std::pair(kind, end);
    }
  }
  return std::nullopt;
}

/// A line that is neither empty nor a comment. Nothing when it was taken.
std::optional<TextFault> takeLine(Reading& reading, FileFrame& frame, const std::string& place,
                                  std::string_view line) {
  TextFault fault{{}, place, std::string(line), ""};
  if (FileFrame::isPart(line)) {
    auto reason = frame.take(line);
    if (!reason) return std::nullopt;
    fault.reason = *std::move(reason);
    return fault;
  }
  const auto kind = kindOf(line, line.find_first_not_of(" \t"));
  if (!kind) {
    fault.reason = fmt::format("a line begins with tool, frame, load, {}, {} or #", kFirstLine, kLastLine);
    return fault;
  }
  if (auto reason = frame.takeEntry()) {
    fault.reason = *std::move(reason);
    return fault;
  }
  return reading.take(kind->first, {place, line, kind->second, EntryEnd::TextOrComment});
}

}  // namespace

std::string describe(const TextFault& fault) {
  return forPeople(
      fmt::format("{}, \"{}\": {}", fault.place, foreignText(fault.text, kQuoteLimit), fault.reason));
}

Result<DataTables, TextFault> readLists(const TableLists& lists, const Payload& payload) {
  Reading reading;
  const auto take = [&](Kind kind, const std::vector<std::string>& list) -> std::optional<TextFault> {
    for (std::size_t i = 0; i < list.size(); ++i) {
      const std::string place = fmt::format("entry {} of {}s", i + 1, toString(kind));
      if (auto fault = reading.take(kind, {place, list[i], 0, EntryEnd::Text})) return fault;
    }
    return std::nullopt;
  };
  auto fault = take(Kind::Tool, lists.tools);
  if (!fault) fault = take(Kind::Frame, lists.frames);
  if (!fault) fault = take(Kind::Load, lists.loads);
  if (fault) return refuse(*std::move(fault));
  return std::move(reading).result(payload);
}

Result<TableFile, TextFault> readFile(std::string_view text, const Payload& payload) {
  Reading reading;
  FileFrame frame;
  TextFault last{{}, "line 1", "", ""};
  for (std::size_t begin = 0, number = 1; begin < text.size(); ++number) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    const std::string_view line = withoutEnd(text.substr(begin, end - begin));
    begin = end + 1;
    const std::size_t first = line.find_first_not_of(" \t");
    if (first == std::string_view::npos) continue;
    last = {{}, fmt::format("line {}", number), std::string(line), ""};
    if (line[first] == '#') continue;
    if (auto fault = takeLine(reading, frame, last.place, line)) return refuse(*std::move(fault));
  }
  if (auto missing = frame.whatIsMissing(!text.empty() && text.back() == '\n')) {
    last.reason = *std::move(missing);
    return refuse(std::move(last));
  }
  auto tables = std::move(reading).result(payload);
  if (!tables) return refuse(std::move(tables.error()));
  return TableFile{*std::move(tables), frame.hasEnd()};
}

}  // namespace cobot_command::tables
