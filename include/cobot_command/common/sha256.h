// SHA-256 (FIPS 180-4). A cell artifact uses it to detect changed sources.
#pragma once

#include <memory>
#include <string>
#include <string_view>

namespace cobot_command {

/// Incremental hash; how the input is divided into pieces does not matter. A copy continues from the state of
/// the original.
class Sha256 {
 public:
  Sha256();
  Sha256(const Sha256& other);
  Sha256(Sha256&& other) noexcept;
  Sha256& operator=(Sha256 other) noexcept;
  ~Sha256();

  void update(std::string_view bytes);
  /// Hash of all bytes up to this point, as 64 lower-case hexadecimal digits. More bytes can be added
  /// afterwards.
  [[nodiscard]] std::string hex() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// Hash of one text.
[[nodiscard]] std::string sha256Hex(std::string_view bytes);

}  // namespace cobot_command
