// tm_frame: frames of the TM protocol from and to bytes, for people and scripts.
#include <cerrno>
#include <cstdio>
#include <exception>
#include <iostream>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "../command_line.h"
#include "../written_output.h"
#include <CLI/CLI.hpp>
#include <fcntl.h>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <sys/stat.h>
#include <unistd.h>

#include "cobot_command/common/foreign_text.h"
#include "cobot_command/common/trace_text.h"
#include "cobot_command/protocol/frame.h"
#include "cobot_command/protocol/frame_decoder.h"
#include "cobot_command/protocol/message.h"
#include "cobot_command/protocol/status_items.h"

namespace {

using namespace cobot_command::protocol;
using Json = nlohmann::ordered_json;

constexpr int kSuccess = 0;
constexpr int kFaultFound = 1;
constexpr const char* kStandardInput = "-";
const std::vector<std::string> kSenders{"client", "controller", "status"};
using cobot_command::tools::kBadUsage;

/// What a frame says, or why it says nothing.
struct Reading {
  bool valid = false;
  std::string meaning;
};

std::string toHex(std::string_view bytes) {
  constexpr std::string_view kDigits = "0123456789abcdef";
  std::string text;
  text.reserve(2 * bytes.size());
  for (const char byte : bytes) {
    text += kDigits[static_cast<unsigned char>(byte) >> 4u];
    text += kDigits[static_cast<unsigned char>(byte) & 0x0Fu];
  }
  return text;
}

/// Pairs of hexadecimal digits, blanks between them or not; false when there is anything else.
bool fromHex(std::string_view text, std::string& bytes) {
  std::string digits;
  for (const char c : text) {
    if (std::string_view(" \t\r").find(c) == std::string_view::npos) digits += c;
  }
  if (digits.size() % 2 != 0 || digits.find_first_not_of("0123456789abcdefABCDEF") != std::string::npos) {
    return false;
  }
  bytes.clear();
  for (std::size_t i = 0; i < digits.size(); i += 2) {
    bytes += static_cast<char>(std::stoi(digits.substr(i, 2), nullptr, 16));
  }
  return true;
}

/// JSON holds text only: bytes that are none are shown as \xNN, and all are given in hexadecimal besides.
void addBytes(Json& line, const std::string& key, const std::string& bytes) {
  try {
    static_cast<void>(Json(bytes).dump());
    line[key] = bytes;
  } catch (const Json::type_error&) {
    line[key] = cobot_command::escaped(bytes);
    line[key + "_hex"] = toHex(bytes);
  }
}

Json toJson(const Frame& frame) {
  Json line;
  line["header"] = frame.header;
  addBytes(line, "data", frame.data);
  line["valid"] = true;
  line["meaning"] = describe(frame);
  return line;
}

Json toJson(const DecodeFault& fault) {
  Json line;
  line["valid"] = false;
  line["fault"] = toString(fault.kind);
  line["message"] = fault.message;
  addBytes(line, "bytes", fault.bytes);
  return line;
}

/// Prints what the decoder gives; whether a fault was among it.
bool printEvents(FrameDecoder& decoder) {
  bool faulty = false;
  while (const auto event = decoder.next()) {
    faulty = faulty || std::holds_alternative<DecodeFault>(*event);
    std::cout << std::visit([](const auto& value) { return toJson(value); }, *event).dump() << std::endl;
  }
  return faulty;
}

/// From here on standard input is the file; or why it is not.
std::optional<std::string> readFrom(const std::string& file) {
  if (file == kStandardInput) return std::nullopt;
  const auto told = [&](const std::string& why) {
    return fmt::format("{} cannot be read: {}; name a file with the bytes of frames, or - for standard input",
                       cobot_command::foreignText(file), why);
  };
  if (file.empty()) return told("the name is empty");
  const int opened = ::open(file.c_str(), O_RDONLY | O_CLOEXEC);
  if (opened < 0) return told(std::generic_category().message(errno));
  struct stat about {};
  const bool is_folder = ::fstat(opened, &about) == 0 && S_ISDIR(about.st_mode);
  if (!is_folder) ::dup2(opened, STDIN_FILENO);
  ::close(opened);
  return is_folder ? std::optional(told("it is a folder")) : std::nullopt;
}

int cannotRead(const std::string& fault) {
  std::cerr << "tm_frame: " << cobot_command::forPeople(fault) << '\n';
  return kBadUsage;
}

/// As the bytes come, so that it can stand behind a live connection.
int decodeBytes(FrameDecoder decoder) {
  bool faulty = false;
  char block[4096];
  ssize_t size = 0;
  while (std::cout && (size = ::read(STDIN_FILENO, block, sizeof(block))) > 0) {
    decoder.feed(std::string_view(block, static_cast<std::size_t>(size)));
    faulty = printEvents(decoder) || faulty;
  }
  if (size < 0) return cannotRead("reading the input failed: " + std::generic_category().message(errno));
  decoder.finish();
  faulty = printEvents(decoder) || faulty;
  return faulty ? kFaultFound : kSuccess;
}

/// `print` gets the decoder with the bytes of one line in it, and says whether there was a fault.
template <class Print>
int decodeHexLines(FrameDecoder decoder, const Print& print) {
  bool faulty = false;
  int number = 0;
  for (std::string line, bytes; std::cout && std::getline(std::cin, line);) {
    ++number;
    if (!fromHex(line, bytes)) {
      std::cerr << "tm_frame: line " << number << ": expected pairs of hexadecimal digits, found \""
                << cobot_command::foreignText(line) << "\"\n";
      return kBadUsage;
    }
    decoder.reset();
    decoder.feed(bytes);
    decoder.finish();
    faulty = print(decoder, bytes) || faulty;
  }
  if (std::cin.bad() || std::ferror(stdin) != 0) return cannotRead("reading the input failed");
  return faulty ? kFaultFound : kSuccess;
}

template <class Message>
Reading readingOf(const cobot_command::Result<Message, MessageFault>& message) {
  return message ? Reading{true, describe(*message)} : Reading{false, message.error().message};
}

/// A frame as the one reads it who gets it; `sender` is one of kSenders.
Reading readingOf(const Frame& frame, const std::string& sender) {
  if (sender == "client") return readingOf(parseClientMessage(frame));
  if (sender == "controller") return readingOf(parseControllerMessage(frame));
  const auto items = parseStatusFrame(frame);
  return {items.has_value(), describe(frame)};
}

/// One frame, or one fault: that is what the flight recorder writes down at a time.
Reading readOne(FrameDecoder& decoder, const std::string& sender) {
  const auto event = decoder.next();
  if (!event) return {false, "no bytes"};
  if (const auto* fault = std::get_if<DecodeFault>(&*event)) return {false, fault->message};
  Reading reading = readingOf(std::get<Frame>(*event), sender);
  return decoder.next() ? Reading{false, "more than one frame"} : std::move(reading);
}

/// One line for each line, so that the two can be laid side by side.
int readTraces(FrameDecoder decoder, const std::string& sender) {
  return decodeHexLines(std::move(decoder), [&](FrameDecoder& line_decoder, const std::string& bytes) {
    const Reading reading = readOne(line_decoder, sender);
    Json line;
    line["valid"] = reading.valid;
    line["meaning"] = reading.meaning;
    line["text"] = cobot_command::traceText(bytes);
    std::cout << line.dump(-1, ' ', false, Json::error_handler_t::replace) << '\n';
    return !reading.valid;
  });
}

int encodeToOutput(const std::string& header, const std::string& data) {
  if (data.size() > kMaxDataLength) {
    std::cerr << "tm_frame: DATA has " << data.size() << " bytes, at most " << kMaxDataLength
              << " can be sent\n";
    return kFaultFound;
  }
  std::cout << encodeFrame(header, data);
  return kSuccess;
}

std::string checkHeader(const std::string& header) {
  const bool letters =
      !header.empty() && header.size() <= kMaxHeaderLength &&
      header.find_first_not_of("ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz") == std::string::npos;
  return letters ? ""
                 : "HEADER is \"" + cobot_command::foreignText(header) + "\", expected at most " +
                       std::to_string(kMaxHeaderLength) + " letters";
}

/// What the words of the command line set.
struct Given {
  std::string header;
  std::string data;
  std::string file = kStandardInput;
  bool hex = false;
  FrameDecoder::Options options;
  std::string sender;
};

CLI::App* addEncode(CLI::App& app, Given& given) {
  CLI::App* encode = app.add_subcommand("encode", "Write the bytes of one frame to standard output");
  encode
      ->add_option("HEADER", given.header, "TMSCT, TMSTA, TMSVR or CPERR; other letters are sent as they are")
      ->required()
      ->check(checkHeader);
  encode->add_option("DATA", given.data, "Any text, for example \"1,ScriptExit()\"")->required();
  return encode;
}

void addDecode(CLI::App& app, Given& given) {
  CLI::App* decode = app.add_subcommand(
      "decode", "Read bytes from a file or standard input, write one line of JSON for each frame or fault");
  decode->add_option("FILE", given.file, "Input file; default, or with -: standard input")->type_name("");
  CLI::Option* const hex_lines = decode->add_flag(
      "--hex", given.hex, "The input is lines of hexadecimal digits, each decoded on its own");
  decode->add_flag("--accept-empty-length", given.options.accept_empty_length,
                   "Accept an empty LENGTH and search for the end of the frame, as some bridges require");
  decode
      ->add_option("--trace-of", given.sender,
                   "Each line is one frame or fault of the flight recorder from this sender (client, "
                   "controller: script port; status: status port). Writes one line of JSON for each, with "
                   "the text and meaning that the topics frames and status_frames have")
      ->needs(hex_lines)
      ->check(CLI::IsMember(kSenders));
}

int run(int argc, char** argv) {
  CLI::App app("Frames of the TM protocol: $HEADER,LENGTH,DATA,*CS");
  cobot_command::tools::nameProgram(app, "tm_frame");
  app.footer("Exit status: 0 success, 1 a fault was found, 2 bad usage, 3 the answer could not be written.");
  Given given;
  const CLI::App* encode = addEncode(app, given);
  addDecode(app, given);
  cobot_command::tools::askForSubcommand(app);
  if (const auto end =
          cobot_command::tools::readCommandLine(app, cobot_command::tools::wordsOf(argc, argv))) {
    return *end;
  }
  if (encode->parsed()) return encodeToOutput(given.header, given.data);
  if (const auto fault = readFrom(given.file)) return cannotRead(*fault);
  if (!given.sender.empty()) return readTraces(FrameDecoder(given.options), given.sender);
  if (!given.hex) return decodeBytes(FrameDecoder(given.options));
  return decodeHexLines(FrameDecoder(given.options),
                        [](FrameDecoder& decoder, const std::string&) { return printEvents(decoder); });
}

}  // namespace

int main(int argc, char** argv) try {
  return cobot_command::tools::unlessOutputLost("tm_frame", run(argc, argv));
} catch (const std::exception& error) {
  std::fprintf(stderr, "tm_frame: %s\n", cobot_command::forPeople(error.what()).c_str());
  return kFaultFound;
}
