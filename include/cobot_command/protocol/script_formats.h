// The data formats that each motion function takes (I848-E-03 chapter 8), and the names of the IO modules:
// for the reader and the writer alike.
#pragma once

#include <algorithm>
#include <array>
#include <string_view>

namespace cobot_command::protocol::formats {

inline constexpr std::array<std::string_view, 2> kPtp{"JPP", "CPP"};
inline constexpr std::array<std::string_view, 4> kLine{"CPP", "CPR", "CAP", "CAR"};
inline constexpr std::array<std::string_view, 2> kCircle{"CPP", "CAP"};
inline constexpr std::array<std::string_view, 3> kMovePtp{"CPP", "TPP", "JPP"};
inline constexpr std::array<std::string_view, 8> kMoveLine{"CPP", "CPR", "CAP", "CAR",
                                                           "TPP", "TPR", "TAP", "TAR"};
inline constexpr std::array<std::string_view, 2> kPLine{"JAP", "CAP"};
inline constexpr std::array<std::string_view, 3> kMovePLine{"CAP", "TAP", "JAP"};
/// The only one that takes pose configuration bits.
inline constexpr std::string_view kWithPoseBits = "CPP";
/// In the order of IoModule.
inline constexpr std::array<std::string_view, 2> kIoModules{"ControlBox", "EndModule"};

template <std::size_t N>
[[nodiscard]] bool has(const std::array<std::string_view, N>& formats, std::string_view format) {
  return std::find(formats.begin(), formats.end(), format) != formats.end();
}

}  // namespace cobot_command::protocol::formats
