// Settings as people write them; what cannot be read is refused with what was found.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "cobot_command/common/result.h"

namespace cobot_command::simulator {

using WriteClients = std::optional<std::set<std::string, std::less<>>>;
using NamedList = std::pair<std::string, std::vector<double>>;
using NamedNumbers = std::pair<std::string, std::array<double, 6>>;

/// Names, separated by commas.
[[nodiscard]] std::vector<std::string> parseNames(std::string_view text);
/// "NAME=1,2": any name, which may hold a =, and finite numbers; nothing when it is otherwise.
[[nodiscard]] std::optional<NamedList> parseNamedList(const std::string& text);
/// "NAME=1,2,3,4,5,6": a pose [mm, deg], or joint angles [deg].
[[nodiscard]] Result<NamedNumbers, std::string> parseNamedNumbers(const std::string& text);
/// "all", "none", or addresses, separated by commas; these as the system writes them.
[[nodiscard]] Result<WriteClients, std::string> parseWriteClients(const std::string& text);

}  // namespace cobot_command::simulator
