#include "settings_text.h"

#include <algorithm>
#include <cmath>

#include <arpa/inet.h>
#include <fmt/format.h>

#include "cobot_command/arm/controller_pose.h"
#include "cobot_command/common/given.h"
#include "cobot_command/protocol/item_content.h"

namespace cobot_command::simulator {

namespace {

/// As the system writes it; nothing when it is none. Clients of IPv4 are known by that.
std::optional<std::string> addressIn(const std::string& text) {
  constexpr std::string_view kMapped = "::ffff:";
  for (const int family : {AF_INET, AF_INET6}) {
    std::array<unsigned char, sizeof(in6_addr)> bytes{};
    std::array<char, INET6_ADDRSTRLEN> written{};
    if (::inet_pton(family, text.c_str(), bytes.data()) != 1) continue;
    std::string address = ::inet_ntop(family, bytes.data(), written.data(), written.size());
    const bool is_mapped =
        address.compare(0, kMapped.size(), kMapped) == 0 && address.find('.') != std::string::npos;
    return is_mapped ? address.substr(kMapped.size()) : address;
  }
  return std::nullopt;
}

/// What scripts can write between quotes.
bool isName(const std::string& name) {
  const auto is_fine = [](char c) { return static_cast<unsigned char>(c) >= ' ' && c != '"' && c != '\x7f'; };
  return !name.empty() && name.front() != ' ' && name.back() != ' ' &&
         std::all_of(name.begin(), name.end(), is_fine);
}

}  // namespace

std::vector<std::string> parseNames(std::string_view text) {
  std::vector<std::string> names;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(','), text.size());
    std::string_view name = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    while (!name.empty() && name.front() == ' ') name.remove_prefix(1);
    while (!name.empty() && name.back() == ' ') name.remove_suffix(1);
    if (!name.empty()) names.emplace_back(name);
  }
  return names;
}

std::optional<NamedList> parseNamedList(const std::string& text) {
  const std::size_t sign = text.rfind('=');
  if (sign == std::string::npos) return std::nullopt;
  const auto value = protocol::parseValue(protocol::ItemFormat::String, '{' + text.substr(sign + 1) + '}',
                                          std::vector<double>());
  if (!value) return std::nullopt;
  return NamedList(text.substr(0, sign), std::get<std::vector<double>>(*value));
}

Result<NamedNumbers, std::string> parseNamedNumbers(const std::string& text) {
  const auto refused = [&](const std::string& reason) {
    return refuse(fmt::format("holds {}: {}", quoted(text), reason));
  };
  const std::size_t sign = text.find('=');
  if (sign == std::string::npos) return refused("there is no =");
  std::string name = text.substr(0, sign);
  if (!isName(name)) return refused("the text before = is not a name without quotes and surrounding blanks");
  const auto value = protocol::parseValue(protocol::ItemFormat::String, '{' + text.substr(sign + 1) + '}',
                                          std::vector<double>());
  std::array<double, 6> numbers{};
  if (!value || protocol::elementCount(*value) != numbers.size()) {
    return refused("the text after = is not six numbers");
  }
  const auto& found = std::get<std::vector<double>>(*value);
  // Written so that NaN is refused as well.
  const auto is_sane = [](double number) { return std::abs(number) <= arm::kMaxCoordinate; };
  if (!std::all_of(found.begin(), found.end(), is_sane)) {
    return refused(fmt::format("a number is beyond {}", arm::kMaxCoordinate));
  }
  std::copy(found.begin(), found.end(), numbers.begin());
  return NamedNumbers(std::move(name), numbers);
}

Result<WriteClients, std::string> parseWriteClients(const std::string& text) {
  WriteClients clients;
  if (text == "all") return clients;
  clients.emplace();
  if (text == "none") return clients;
  const std::vector<std::string> names = parseNames(text);
  for (const std::string& name : names) {
    const auto address = addressIn(name);
    if (!address) return refuse(fmt::format("names {}, which is not an address", quoted(name)));
    clients->insert(*address);
  }
  if (names.empty()) return refuse(std::string("names no address"));
  return clients;
}

}  // namespace cobot_command::simulator
