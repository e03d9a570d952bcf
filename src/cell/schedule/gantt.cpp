#include "cobot_command/cell/schedule/gantt.h"

#include <algorithm>
#include <string_view>
#include <vector>

#include <fmt/format.h>

namespace cobot_command::cell {
namespace {

constexpr std::size_t kLeastColumns = 10;
constexpr std::string_view kSigns = "123456789ABCDEFGHIJKLMNOPQRSTUVWXYZ";

struct Row {
  std::string label;
  std::string cells;
};

/// A line of time from the start to the makespan.
class TimeLine {
 public:
  TimeLine(Duration length, std::size_t columns) : length_(length), columns_(columns) {}

  [[nodiscard]] std::string empty() const { return std::string(columns_, '.'); }
  /// All columns whose middle lies in it.
  void draw(std::string& cells, Duration from, Duration until, char sign) const {
    for (std::size_t column = 0; column < columns_; ++column) {
      const double middle = (static_cast<double>(column) + 0.5) * columnLength();
      if (middle >= toSeconds(from) && middle < toSeconds(until)) cells[column] = sign;
    }
  }
  [[nodiscard]] double columnLength() const { return toSeconds(length_) / static_cast<double>(columns_); }

 private:
  Duration length_;
  std::size_t columns_;
};

char signOf(const std::vector<std::size_t>& robots, std::size_t robot) {
  const auto index =
      static_cast<std::size_t>(std::find(robots.begin(), robots.end(), robot) - robots.begin());
  return index < kSigns.size() ? kSigns[index] : '+';
}

std::vector<std::size_t> robotsOf(const Schedule& schedule) {
  std::vector<std::size_t> robots;
  for (const ScheduledEvent& event : schedule.events) robots.push_back(event.robot);
  std::sort(robots.begin(), robots.end());
  robots.erase(std::unique(robots.begin(), robots.end()), robots.end());
  return robots;
}

std::string robotCells(const Schedule& schedule, const TimeLine& line, std::size_t robot) {
  std::string cells = line.empty();
  Duration home{};
  for (const ScheduledEvent& event : schedule.events) {
    if (event.robot == robot) home = event.at;
  }
  line.draw(cells, Duration{}, home, '-');
  for (const ZoneOrder& zone : schedule.zones) {
    for (const ScheduledHold& hold : zone.holds) {
      if (hold.robot == robot) line.draw(cells, hold.from, hold.until, '#');
    }
  }
  for (const ScheduledEvent& event : schedule.events) {
    if (event.robot == robot) line.draw(cells, event.at - event.waited, event.at, '~');
  }
  return cells;
}

std::vector<Row> rowsOf(const Schedule& schedule, const automata::Problem& problem, const TimeLine& line) {
  std::vector<Row> rows;
  const auto robots = robotsOf(schedule);
  rows.reserve(robots.size() + schedule.zones.size());
  for (const std::size_t robot : robots) {
    rows.push_back({fmt::format("{} {}", signOf(robots, robot), problem.automata[robot].name),
                    robotCells(schedule, line, robot)});
  }
  for (const ZoneOrder& zone : schedule.zones) {
    std::string cells = line.empty();
    for (const ScheduledHold& hold : zone.holds) {
      line.draw(cells, hold.from, hold.until, signOf(robots, hold.robot));
    }
    rows.push_back({fmt::format("  {}", problem.automata[zone.zone].name), std::move(cells)});
  }
  return rows;
}

}  // namespace

std::string ganttOf(const Schedule& schedule, const automata::Problem& problem, std::size_t columns) {
  columns = std::max(columns, kLeastColumns);
  const TimeLine line(schedule.makespan, columns);
  const std::vector<Row> rows = rowsOf(schedule, problem, line);
  std::size_t width = 0;
  for (const Row& row : rows) width = std::max(width, row.label.size());
  std::string text = fmt::format("{:{}} |0{:>{}}|\n", "", width,
                                 fmt::format("{:.2f} s", toSeconds(schedule.makespan)), columns - 1);
  for (const Row& row : rows) text += fmt::format("{:{}} |{}|\n", row.label, width, row.cells);
  text += fmt::format("{:{}}  - on its way, # in a zone, ~ waits, . at home or free; a column is {:.3f} s\n",
                      "", width, line.columnLength());
  return text;
}

}  // namespace cobot_command::cell
