// What holds for all values, tried on random ones. A failure prints the seed: RC_PARAMS="seed=..." repeats
// it.
#include "decode_events.h"
#include "reference_decoder.h"
#include <gmock/gmock.h>
#include <rapidcheck/gtest.h>

#include "cobot_command/protocol/message.h"
#include "cobot_command/protocol/status_items.h"

namespace cobot_command::protocol {
namespace {

using Bytes = std::string;

rc::Gen<Bytes> anyBytes() {
  return rc::gen::container<Bytes>(rc::gen::arbitrary<char>());
}

/// Bytes that look like the protocol: they reach deeper than arbitrary ones.
rc::Gen<Bytes> protocolBytes() {
  const auto token = rc::gen::oneOf(
      rc::gen::element<Bytes>("$", ",", "*", "\r\n", "TMSCT", "TMSTA", "0x", "0b", "5", "0", "-", "6D", "OK",
                              "$TMSCT,", "10,OK", ",*6D\r\n", "$TMSCT,5,10,OK,*6D\r\n"),
      rc::gen::map(rc::gen::arbitrary<char>(), [](char c) { return Bytes(1, c); }));
  return rc::gen::map(rc::gen::container<std::vector<Bytes>>(token), [](const std::vector<Bytes>& tokens) {
    Bytes bytes;
    for (const Bytes& t : tokens) bytes += t;
    return bytes;
  });
}

RC_GTEST_PROP(FrameProperty, isDecodedToWhatWasEncoded, ()) {
  const Bytes data = *anyBytes();
  const Bytes header = *rc::gen::nonEmpty(rc::gen::container<Bytes>(rc::gen::inRange('A', 'Z')));
  RC_PRE(header.size() <= kMaxHeaderLength);
  FrameDecoder decoder;
  decoder.feed(encodeFrame(header, data));
  const auto event = decoder.next();
  RC_ASSERT(event.has_value());
  RC_ASSERT(std::get<Frame>(*event) == (Frame{header, data}));
  RC_ASSERT(decoder.pending() == 0u);
}

RC_GTEST_PROP(FrameProperty, ofAnyStreamIsWhatTheReferenceSaysInAnyPieces, ()) {
  const Bytes stream = *rc::gen::oneOf(anyBytes(), protocolBytes());
  FrameDecoder decoder;
  reference::Events events;
  for (std::string_view rest = stream; !rest.empty();) {
    const std::size_t size = *rc::gen::inRange<std::size_t>(1, rest.size() + 1);
    decoder.feed(rest.substr(0, size));
    rest.remove_prefix(size);
    for (auto& event : drain(decoder)) events.push_back(std::move(event));
  }
  RC_ASSERT(events == reference::decode(stream));
}

RC_GTEST_PROP(FrameProperty, ofAnyStreamWithEmptyLengthsDoesNotDependOnThePieces, ()) {
  const FrameDecoder::Options options{true};
  const Bytes stream = *protocolBytes() + "$TMSCT,,1,*,*6" + *protocolBytes() + ",*6D\r\n";
  RC_ASSERT(decodeInPieces(stream, 1, 1, FrameDecoder(options)) == decode(stream, FrameDecoder(options)));
}

RC_GTEST_PROP(FrameProperty, ofAStreamThatEndsLeavesNothing, ()) {
  FrameDecoder decoder(FrameDecoder::Options{*rc::gen::arbitrary<bool>()});
  decoder.feed(*protocolBytes());
  decoder.finish();
  while (decoder.next()) {
  }
  RC_ASSERT(decoder.pending() == 0u);
}

RC_GTEST_PROP(MessageProperty, ofAnyDataIsAMessageThatIsReadAgainOrAFault, ()) {
  const Bytes header = *rc::gen::element<Bytes>("TMSCT", "TMSTA", "CPERR", "TMSVR", "X");
  const Bytes data = *rc::gen::oneOf(
      anyBytes(), rc::gen::map(protocolBytes(), [](const Bytes& bytes) { return "01," + bytes; }),
      rc::gen::map(anyBytes(), [](const Bytes& bytes) { return "90," + bytes; }), protocolBytes());
  const auto reread = [](const Bytes& bytes) {
    FrameDecoder decoder;
    decoder.feed(bytes);
    return std::get<Frame>(decoder.next().value());
  };
  const Frame frame{header, data};
  RC_ASSERT(!describe(frame).empty());
  if (const auto message = parseControllerMessage(frame)) {
    const auto again = parseControllerMessage(reread(encode(*message)));
    RC_ASSERT(again.has_value());
    RC_ASSERT(encode(*again) == encode(*message));
  }
  const auto message = parseClientMessage(frame);
  if (const auto* request = message ? std::get_if<ScriptRequest>(&*message) : nullptr; request != nullptr) {
    RC_ASSERT(request->id + ',' + request->script == data);
  }
}

RC_GTEST_PROP(ItemsProperty, areReadAsTheyWereWritten, ()) {
  const auto names = *rc::gen::container<std::vector<Bytes>>(rc::gen::nonEmpty(anyBytes()));
  std::vector<StatusItem> items;
  items.reserve(names.size());
  for (const Bytes& name : names) items.push_back({name, *anyBytes()});
  const auto read = parseBinaryItems(encodeBinaryItems(items));
  RC_ASSERT(read.has_value());
  RC_ASSERT(*read == items);
}

RC_GTEST_PROP(ItemsProperty, ofAnyBytesAreTheSameBytesOrAFault, ()) {
  const Bytes content = *anyBytes();
  if (const auto items = parseBinaryItems(content)) RC_ASSERT(encodeBinaryItems(*items) == content);
  if (const auto reply = parseStatusReply(content)) {
    RC_ASSERT(parseStatusReply(toContent(*reply)).has_value());
  }
}

}  // namespace
}  // namespace cobot_command::protocol
