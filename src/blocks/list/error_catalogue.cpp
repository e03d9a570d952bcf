#include "cobot_command/blocks/shared/error_catalogue.h"

#include <algorithm>
#include <array>
#include <utility>

#include "cobot_command/blocks/goal.h"

namespace cobot_command::blocks {
namespace {

template <class... Kinds>
constexpr std::array<const char*, sizeof...(Kinds)> namesOf(const std::variant<Kinds...>* /*list*/) {
  return {Kinds::kName...};
}

void append(std::vector<ErrorEntry>& all, Block block, const ErrorTable& table) {
  for (const ErrorRow& row : table.rows()) all.push_back({row, block});
}

template <class... Kinds>
std::vector<ErrorEntry> errorsOf(const std::variant<Kinds...>* /*list*/) {
  std::vector<ErrorEntry> all;
  (append(all, kBlock<Kinds>, Kinds::errors()), ...);
  return all;
}

constexpr const Goal* kList = nullptr;

}  // namespace

const char* toString(Block block) {
  static constexpr auto kNames = namesOf(kList);
  return kNames.at(static_cast<std::size_t>(block));
}

const std::vector<ErrorEntry>& errorCatalogue() {
  static const std::vector<ErrorEntry> kCatalogue = errorsOf(kList);
  return kCatalogue;
}

const ErrorEntry* findError(Block block, int id) {
  const auto& all = errorCatalogue();
  const auto found = std::lower_bound(
      all.begin(), all.end(), std::pair(block, id),
      [](const ErrorEntry& entry, auto wanted) { return std::pair(entry.block, entry.id) < wanted; });
  return found != all.end() && found->block == block && found->id == id ? &*found : nullptr;
}

}  // namespace cobot_command::blocks
