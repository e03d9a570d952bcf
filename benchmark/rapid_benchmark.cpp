// What reading, checking and formatting RAPID costs, as ratios of two sides that are measured alternately in
// one run: a time alone depends more on the machine than on the code. Figures: doc/rapid.md.
//
//   build/release/benchmark/rapid_benchmark     # a release build, a quiet machine
#include <algorithm>
#include <array>
#include <cstdint>
#include <ctime>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include "cobot_command/rapid/checks/check.h"
#include "cobot_command/rapid/source/printer.h"
#include "cobot_command/rapid/source/source.h"
#include "cobot_command/rapid/types/predefined.h"

namespace cobot_command::rapid {
namespace {

/// Moves with inline targets: `moves` lines of about 130 bytes.
std::string moduleOf(int moves) {
  std::string text = "MODULE Moves\n\n  PROC main()\n";
  std::uint32_t chance = 1;
  const auto coordinate = [&chance] {
    chance = chance * 1664525U + 1013904223U;
    return (chance >> 8U) % 1000000 / 1000.0;
  };
  for (int move = 0; move < moves; ++move) {
    text += fmt::format(
        "    MoveL "
        "[[{:.3f},-{:.3f},{:.3f}],[0,0.707106781,0.707106781,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]],"
        "v100,z50,tool0\\WObj:=wobj0;\n",
        coordinate(), coordinate(), coordinate());
  }
  return text + "  ENDPROC\nENDMODULE\n";
}

/// 0: a blank; 1: part of a name or a number; 2: a sign.
constexpr std::array<std::uint8_t, 256> kClasses = [] {
  std::array<std::uint8_t, 256> classes{};
  for (std::size_t byte = 0; byte < classes.size(); ++byte) {
    const bool is_letter = (byte >= 'a' && byte <= 'z') || (byte >= 'A' && byte <= 'Z') || byte == '_';
    const bool is_digit = (byte >= '0' && byte <= '9') || byte == '.';
    classes.at(byte) = byte <= ' ' ? 0 : is_letter || is_digit ? 1 : 2;
  }
  return classes;
}();

/// The floor: one pass over the bytes, through a table of classes, that counts tokens. Without branches, so
/// that nothing but the bytes counts.
std::size_t countTokens(std::string_view text) {
  std::size_t tokens = 0;
  unsigned before = 0;
  for (const char c : text) {
    const unsigned now = kClasses[static_cast<unsigned char>(c)];
    tokens += (now >> 1U) | (now & ~before & 1U);
    before = now;
  }
  return tokens;
}

/// Of this process [s]
double cpuTime() {
  timespec time{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

template <class Work>
double timed(const Work& work) {
  const double begin = cpuTime();
  work();
  return cpuTime() - begin;
}

double median(std::vector<double> times) {
  const auto middle = times.begin() + static_cast<std::ptrdiff_t>(times.size() / 2);
  std::nth_element(times.begin(), middle, times.end());
  return *middle;
}

/// Counter: check_by_parse (at most 2, goal 1), of the check alone.
void checking(benchmark::State& run) {
  const std::string text = moduleOf(static_cast<int>(run.range(0)));
  std::vector<double> parses;
  std::vector<double> checks;
  static_cast<void>(check({}, {}));
  for (auto _ : run) {
    std::shared_ptr<const Source> source;
    parses.push_back(timed([&] { source = std::make_shared<const Source>(readSource(text)); }));
    checks.push_back(timed([&] { benchmark::DoNotOptimize(check({{"moves.mod", source}}, {})); }));
  }
  run.counters["check_by_parse"] = median(std::move(checks)) / median(std::move(parses));
}
BENCHMARK(checking)->Arg(20000)->Iterations(25)->Unit(benchmark::kMillisecond);

/// Counters: parse_by_scan (at most 60, goal 25), format_by_parse (at most 3, goal 2), MB_per_s of the
/// parser.
void readingAndFormatting(benchmark::State& run) {
  const std::string text = moduleOf(static_cast<int>(run.range(0)));
  static_cast<void>(predefinedNames());
  std::vector<double> scans;
  std::vector<double> parses;
  std::vector<double> formats;
  for (auto _ : run) {
    scans.push_back(timed([&] { benchmark::DoNotOptimize(countTokens(text)); }));
    parses.push_back(timed([&] { benchmark::DoNotOptimize(readSource(text)); }));
    formats.push_back(timed([&] { benchmark::DoNotOptimize(print(readSource(text), predefinedNames())); }));
  }
  const double parse = median(parses);
  run.counters["parse_by_scan"] = parse / median(std::move(scans));
  run.counters["format_by_parse"] = median(std::move(formats)) / parse;
  run.counters["MB_per_s"] = 1e-6 * static_cast<double>(text.size()) / parse;
}
BENCHMARK(readingAndFormatting)->Arg(20000)->Iterations(25)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace cobot_command::rapid
