// The bytes of a fuzzer, taken as decisions and values. When they are used up all is zero, so every input
// ends.
#pragma once

#include <array>
#include <cstdint>
#include <cstring>
#include <limits>
#include <string>
#include <string_view>

namespace cobot_command::fuzz {

class FuzzInput {
 public:
  FuzzInput(const std::uint8_t* data, std::size_t size) : bytes_(reinterpret_cast<const char*>(data), size) {}

  [[nodiscard]] bool empty() const { return bytes_.empty(); }

  std::uint8_t byte() {
    if (bytes_.empty()) return 0;
    const auto value = static_cast<std::uint8_t>(bytes_.front());
    bytes_.remove_prefix(1);
    return value;
  }
  /// 0..count-1.
  std::size_t choice(std::size_t count) { return byte() % count; }
  bool flag() { return (byte() & 1u) != 0; }

  /// Small ones, and any.
  int whole() {
    const std::uint8_t kind = byte();
    return kind < 0xF0 ? kind - 16 : static_cast<int>(fixed<std::uint32_t>());
  }
  /// What numbers of a goal may be, at their borders and beyond.
  double number() {
    static constexpr double kInfinity = std::numeric_limits<double>::infinity();
    static constexpr std::array<double, 14> kOdd = {0,    -0.0,  1,      -1,        180,        90,   360,
                                                    1e-9, 1e300, -1e300, kInfinity, -kInfinity, 4500, 9999};
    const std::uint8_t kind = byte();
    if (kind < kOdd.size()) return kOdd[kind];
    if (kind == kOdd.size()) return std::numeric_limits<double>::quiet_NaN();
    if (kind < 0x40) return fixed<double>();
    return (static_cast<double>(fixed<std::uint16_t>()) - 32768) / 40;
  }
  /// Up to 63 bytes, or what is left of the input.
  std::string text() {
    const std::size_t size = choice(64);
    std::string taken(bytes_.substr(0, size));
    bytes_.remove_prefix(taken.size());
    return taken;
  }

 private:
  template <class Value>
  Value fixed() {
    std::array<char, sizeof(Value)> raw{};
    for (char& c : raw) c = static_cast<char>(byte());
    Value value{};
    std::memcpy(&value, raw.data(), sizeof value);
    return value;
  }

  std::string_view bytes_;
};

}  // namespace cobot_command::fuzz
