#include "robot/controller_clock.h"

#include <algorithm>
#include <chrono>
#include <ctime>

#include <fmt/format.h>

namespace cobot_command::simulator {

namespace {

constexpr std::time_t kYear2000 = 946684800;
constexpr int kHalfDay = 12;

/// A number of a run of letters: two of them ask for a zero in front.
std::string numberText(int number, std::size_t letters) {
  return fmt::format("{:0{}}", number, std::min<std::size_t>(letters, 2));
}

std::string fractionText(Duration since_second, std::size_t letters) {
  constexpr std::size_t kDigits = 9;
  const auto nanoseconds = std::chrono::duration_cast<std::chrono::nanoseconds>(since_second).count();
  return fmt::format("{:09}", nanoseconds).substr(0, std::min(letters, kDigits));
}

std::string partText(char letter, std::size_t letters, const std::tm& parts, Duration since_second) {
  constexpr int kFirstYear = 1900, kCentury = 100;
  const int year = parts.tm_year + kFirstYear;
  switch (letter) {
    case 'y':
      return letters > 2 ? std::to_string(year) : numberText(year % kCentury, letters);
    case 'M':
      return numberText(parts.tm_mon + 1, letters);
    case 'd':
      return numberText(parts.tm_mday, letters);
    case 'H':
      return numberText(parts.tm_hour, letters);
    case 'h':
      return numberText((parts.tm_hour + kHalfDay - 1) % kHalfDay + 1, letters);
    case 'm':
      return numberText(parts.tm_min, letters);
    case 's':
      return numberText(parts.tm_sec, letters);
    case 'f':
      return fractionText(since_second, letters);
    case 't':
      return parts.tm_hour < kHalfDay ? "AM" : "PM";
    default:
      return std::string(letters, letter);
  }
}

}  // namespace

std::string clockText(Instant time, std::string_view format) {
  const auto seconds = std::chrono::floor<std::chrono::seconds>(time.time_since_epoch());
  const std::time_t now = kYear2000 + seconds.count();
  std::tm parts{};
  gmtime_r(&now, &parts);
  std::string text;
  while (!format.empty()) {
    const std::size_t letters = std::min(format.find_first_not_of(format.front()), format.size());
    text += partText(format.front(), letters, parts, time.time_since_epoch() - seconds);
    format.remove_prefix(letters);
  }
  return text;
}

std::string durationText(Duration duration) {
  const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(duration).count();
  return fmt::format("{:02}:{:02}:{:02}", seconds / 3600, seconds / 60 % 60, seconds % 60);
}

}  // namespace cobot_command::simulator
