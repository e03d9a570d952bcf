// Lines of an operator, between what clients say: '>' goes to the script port as a script, '<' to the status
// port as DATA, '+' lets so many milliseconds pass, all others are control lines. The controller answers
// afterwards.
#include <algorithm>
#include <charconv>
#include <string>
#include <string_view>

#include "require.h"
#include "simulated_robot.h"

#include "cobot_command/simulator/control_line.h"

using namespace cobot_command;
using simulator::ClientId;
using simulator::Port;
using simulator::test::SimulatedRobot;

namespace {

constexpr std::size_t kMostLines = 50;
constexpr int kLongestPause = 2000;  // [ms]: a stream of status frames is made for all of it

int millisecondsOf(std::string_view text) {
  int milliseconds = 0;
  std::from_chars(text.data(), text.data() + text.size(), milliseconds);
  return std::clamp(milliseconds, 0, kLongestPause);
}

class Session {
 public:
  void take(std::string_view line) {
    const char kind = line.empty() ? ' ' : line.front();
    if (kind == '>') return robot_.script(script_, "1", std::string(line.substr(1)));
    if (kind == '<') {
      return robot_.send(status_, protocol::encodeFrame("TMSVR", line.substr(1)), Port::Status);
    }
    if (kind == '+') return robot_.wait(std::chrono::milliseconds(millisecondsOf(line.substr(1))));
    const auto reply = simulator::control(robot_.controller(), line, robot_.now());
    REQUIRE(line.find_first_not_of(" \t\r\v\f") == std::string_view::npos || !reply.text.empty());
  }
  void end() {
    robot_.wait(std::chrono::milliseconds(100));
    for (const double joint : robot_.joints()) REQUIRE(std::isfinite(joint));
  }

 private:
  SimulatedRobot robot_;
  ClientId script_ = robot_.connect();
  ClientId status_ = robot_.connect(Port::Status);
};

}  // namespace

// NOLINTNEXTLINE(readability-identifier-naming): the name that libFuzzer calls
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::string_view text(reinterpret_cast<const char*>(data), size);
  Session session;
  for (std::size_t lines = 0; !text.empty() && lines < kMostLines; ++lines) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    session.take(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  session.end();
  return 0;
}
