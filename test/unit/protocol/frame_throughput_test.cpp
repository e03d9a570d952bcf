// How fast a stream is taken apart, beside copying its frames: a ratio, so that it means the same on any
// machine.
#include <string>
#include <vector>

#include "decode_events.h"
#include "figure.h"
#include "golden_frames.h"
#include "thorough.h"
#include <gtest/gtest.h>

namespace cobot_command::protocol {
namespace {

using std::chrono::steady_clock;

/// The valid golden frames, so often.
std::vector<std::string> manyFrames(int times) {
  std::vector<std::string> frames;
  for (int i = 0; i < times; ++i) {
    for (const GoldenFrame& golden : goldenFrames()) {
      if (golden.valid) {
        frames.push_back(golden.bytes);
      }
    }
  }
  return frames;
}

std::string joined(const std::vector<std::string>& frames) {
  std::string stream;
  for (const std::string& frame : frames) {
    stream += frame;
  }
  return stream;
}

/// What is fed at once is as much as a socket gives at once.
steady_clock::duration timeToDecode(const std::string& stream, std::size_t piece, std::size_t& decoded) {
  return testing::timeOf([&] {
    FrameDecoder decoder;
    for (std::string_view rest = stream; !rest.empty();) {
      const auto taken = rest.substr(0, piece);
      rest.remove_prefix(taken.size());
      decoder.feed(taken);
      while (decoder.next()) {
        ++decoded;
      }
    }
  });
}

steady_clock::duration timeToCopy(const std::vector<std::string>& frames) {
  return testing::timeOf([&] {
    for (const std::string& frame : frames) {
      const std::string copy(frame);
      volatile char last = copy.back();  // so that it is made
      static_cast<void>(last);
    }
  });
}

double ratio(steady_clock::duration a, steady_clock::duration b) {
  return static_cast<double>(a.count()) / static_cast<double>(b.count());
}

TEST(FrameThroughput, isThatOfCopyingAFewTimesAndLinear) {
  constexpr std::size_t kPiece = 16384;
  testing::Figure in_pieces("G1", "decoding, beside copying the same frames", "times", 6);
  testing::Figure doubled("G1", "decoding twice as much", "times", 2.3);
  testing::Figure doubled_bytes("G1", "decoding twice as much byte by byte", "times", 2.3);
  const int times = testing::quickOrThorough(20, 2000);
  const auto frames = manyFrames(times);
  const std::string once = joined(frames), twice = once + once;
  for (int i = 0; i < testing::quickOrThorough(1, 11); ++i) {
    std::size_t decoded = 0;
    const auto of_once = timeToDecode(once, kPiece, decoded);
    EXPECT_EQ(decoded, frames.size());
    in_pieces.add(ratio(of_once, timeToCopy(frames)));
    doubled.add(ratio(timeToDecode(twice, kPiece, decoded), of_once));
    const auto of_bytes = timeToDecode(once, 1, decoded);
    doubled_bytes.add(ratio(timeToDecode(twice, 1, decoded), of_bytes));
    EXPECT_EQ(decoded, 6 * frames.size());
  }
}

}  // namespace
}  // namespace cobot_command::protocol
