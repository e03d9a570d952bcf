// How much faster than real time a simulated controller is, from the text of a script to the arm at rest,
// with one client and nobody else waiting: the counter simulated_per_real. It must be above 1000.
#include <chrono>
#include <string>

#include <benchmark/benchmark.h>

#include "cobot_command/protocol/frame.h"
#include "cobot_command/simulator/simulated_controller.h"
#include "cobot_command/tm_script/parser.h"

namespace cobot_command::simulator {
namespace {

constexpr const char* kPtp =
    "PTP(\"JPP\",30,0,90,0,90,0,50,200,0,false)\r\nQueueTag(1)\r\n"
    "PTP(\"JPP\",0,0,90,0,90,0,50,200,0,false)\r\nQueueTag(2)";
constexpr const char* kLines =
    "Line(\"CAP\",417.5,-22.3,361.05,180,0,90,100,200,0,false)\r\n"
    "Line(\"CAP\",417.5,-122.3,361.05,180,0,90,100,200,0,false)\r\nQueueTag(1)";
constexpr const char* kBlended =
    "Line(\"CAR\",417.5,-22.3,361.05,180,0,90,100,200,20,false)\r\n"
    "Line(\"CAR\",367.5,-22.3,361.05,180,0,90,100,200,20,false)\r\n"
    "Line(\"CAR\",367.5,-122.3,361.05,180,0,90,100,200,20,false)\r\n"
    "Line(\"CAR\",417.5,-122.3,361.05,180,0,90,100,200,0,false)\r\nQueueTag(1)";
constexpr const char* kCircle =
    "Circle(\"CAP\",467.5,-72.3,361.05,180,0,90,417.5,-22.3,361.05,180,0,90,100,200,0,0,false)\r\n"
    "Circle(\"CAP\",467.5,-72.3,361.05,180,0,90,417.5,-122.3,361.05,180,0,90,100,200,0,0,false)\r\nQueueTag("
    "1)";
constexpr const char* kPLines =
    "PLine(\"CAP\",417.5,-22.3,361.05,180,0,90,100,200,20)\r\n"
    "PLine(\"CAP\",367.5,-22.3,361.05,180,0,90,100,200,20)\r\n"
    "PLine(\"CAP\",367.5,-122.3,361.05,180,0,90,100,200,20)\r\n"
    "PLine(\"CAP\",417.5,-122.3,361.05,180,0,90,100,200,0)\r\nQueueTag(1)";
constexpr const char* kPvt =
    "PVTEnter(1)\r\nPVTPoint(417.5,-22.3,361.05,180,0,90,-50,50,0,0,0,0,2)\r\n"
    "PVTPoint(417.5,-122.3,361.05,180,0,90,0,0,0,0,0,0,3)\r\nPVTExit()\r\nQueueTag(1)";
/// As programs make it: names, arrays, expressions.
constexpr const char* kProgram =
    "Robot[0].CameraLight = 1\r\n"
    "float[] target = {417.5,-122.3,361.05,180,0,90}\r\n"
    "target[1] += 50 * 2\r\n"
    "Line(\"CAP\",target,100,200,0,false)\r\n"
    "target[1] -= 50 * 2\r\n"
    "Line(\"CAP\",target,100,200,0,false)\r\nQueueTag(1)\r\n"
    "ListenSend(90,GetString(Robot[0].CoordRobot))\r\nScriptExit()";

/// Whether the status stream has a listener.
enum class Stream { Off, On };

void run(benchmark::State& state, const std::string& script, Stream stream) {
  constexpr ClientId kScript = 1, kStatus = 2;
  Instant now{};
  SimulatedController robot(arm::ArmModel::named("tm5-900").value(), {}, now);
  robot.clientConnected(Port::Script, kScript, now);
  if (stream == Stream::On) robot.clientConnected(Port::Status, kStatus, now);
  const std::string frame = protocol::encodeFrame("TMSCT", "1," + script);
  for (auto _ : state) {
    robot.received(Port::Script, kScript, frame, now);
    do {
      now = std::min(robot.nextEvent(), now + std::chrono::minutes(1));
      robot.advance(now);
      benchmark::DoNotOptimize(robot.takeOutputs());
    } while (robot.state().queued_motions > 0 || !robot.state().listening);
    if (robot.state().error) return state.SkipWithError("the motion was not made");
  }
  state.counters["simulated_per_real"] = benchmark::Counter(
      std::chrono::duration<double>(now.time_since_epoch()).count(), benchmark::Counter::kIsRate);
}

void parsing(benchmark::State& state, const std::string& script) {
  for (auto _ : state) benchmark::DoNotOptimize(tm_script::parse(script));
}

BENCHMARK_CAPTURE(run, ptp, kPtp, Stream::Off);
BENCHMARK_CAPTURE(run, lines, kLines, Stream::Off);
BENCHMARK_CAPTURE(run, blended_lines, kBlended, Stream::Off);
BENCHMARK_CAPTURE(run, circles, kCircle, Stream::Off);
BENCHMARK_CAPTURE(run, plines, kPLines, Stream::Off);
BENCHMARK_CAPTURE(run, pvt_of_poses, kPvt, Stream::Off);
BENCHMARK_CAPTURE(run, program, kProgram, Stream::Off);
BENCHMARK_CAPTURE(run, ptp_streamed, kPtp, Stream::On);
BENCHMARK_CAPTURE(run, lines_streamed, kLines, Stream::On);
BENCHMARK_CAPTURE(parsing, ptp, kPtp);
BENCHMARK_CAPTURE(parsing, blended_lines, kBlended);
BENCHMARK_CAPTURE(parsing, program, kProgram);

}  // namespace
}  // namespace cobot_command::simulator
