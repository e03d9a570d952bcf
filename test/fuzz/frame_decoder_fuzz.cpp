// The first byte chooses how the others are cut into pieces and whether an empty LENGTH is accepted.
#include <cstdint>

#include "decode_events.h"
#include "reference_decoder.h"
#include "require.h"

#include "cobot_command/protocol/message.h"

using namespace cobot_command::protocol;

// NOLINTNEXTLINE(readability-identifier-naming): the name that libFuzzer calls
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const std::string_view stream(reinterpret_cast<const char*>(data) + 1, size - 1);
  const FrameDecoder::Options options{(data[0] & 0x80u) != 0};
  const std::size_t piece = 1 + (data[0] & 0x7Fu);

  FrameDecoder decoder(options);
  for (std::size_t begin = 0; begin < stream.size(); begin += piece) {
    decoder.feed(stream.substr(begin, piece));
    while (const auto event = decoder.next()) {
      if (const auto* frame = std::get_if<Frame>(&*event)) REQUIRE(!describe(*frame).empty());
    }
  }
  decoder.finish();
  while (decoder.next()) {
  }
  REQUIRE(decoder.pending() == 0);

  const auto events = decodeInPieces(stream, piece, piece, FrameDecoder(options));
  REQUIRE(events == decode(stream, FrameDecoder(options)));
  if (!options.accept_empty_length) REQUIRE(events == reference::decode(stream));
  return 0;
}
