// The frames of test/data/golden-frames.json: from manuals, captures and other clients, with what is wrong in
// them.
#pragma once

#include <fstream>
#include <string>
#include <vector>

#include "source_tree.h"
#include <nlohmann/json.hpp>

namespace cobot_command::protocol {

struct GoldenFrame {
  std::string bytes;
  std::string header;
  std::string length_field;
  std::string checksum_field;
  std::string meaning;
  bool from_robot = false;
  bool length_valid = false;
  bool checksum_valid = false;
  bool valid = false;
};

inline void PrintTo(const GoldenFrame& frame, std::ostream* out) {
  *out << frame.header << ' ' << frame.meaning;
}

inline std::string fromHex(const std::string& hex) {
  std::string bytes;
  for (std::size_t i = 0; i + 1 < hex.size(); i += 2) {
    bytes += static_cast<char>(std::stoi(hex.substr(i, 2), nullptr, 16));
  }
  return bytes;
}

inline std::vector<GoldenFrame> goldenFrames() {
  std::ifstream file(test_support::inSourceTree("test/data/golden-frames.json"));
  std::vector<GoldenFrame> frames;
  for (const auto& entry : nlohmann::json::parse(file)) {
    frames.push_back({fromHex(entry.at("hex")), entry.at("header"), entry.at("length_field"),
                      entry.at("checksum_field"), entry.at("meaning"),
                      entry.at("direction") == "robot->client", entry.at("length_valid"),
                      entry.at("checksum_valid"), entry.at("valid")});
  }
  return frames;
}

}  // namespace cobot_command::protocol
