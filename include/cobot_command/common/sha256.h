// SHA-256 (FIPS 180-4) of bytes: by which an artifact knows that what it was made of has not changed.
#pragma once

#include <memory>
#include <string>
#include <string_view>

namespace cobot_command {

/// The hash of what comes piece by piece; how it is cut into pieces does not matter. A copy goes on from
/// where the original was.
class Sha256 {
 public:
  Sha256();
  Sha256(const Sha256& other);
  Sha256(Sha256&& other) noexcept;
  Sha256& operator=(Sha256 other) noexcept;
  ~Sha256();

  void update(std::string_view bytes);
  /// Of all that came so far, as 64 lower case hexadecimal digits. More may come behind it.
  [[nodiscard]] std::string hex() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// The same of one text.
[[nodiscard]] std::string sha256Hex(std::string_view bytes);

}  // namespace cobot_command
