#include "cobot_command/blocks/shared/error_catalogue.h"

#include <algorithm>
#include <array>
#include <tuple>
#include <utility>

#include <fmt/format.h>

#include "cobot_command/blocks/list/goal.h"

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

template <class... Kinds>
std::vector<std::vector<OwnNumber>> ownNumbersOf(const std::variant<Kinds...>* /*list*/) {
  return {Kinds::errors().ownNumbers()...};
}

constexpr const Goal* kList = nullptr;

/// In the order in which they decide.
const std::vector<OwnNumber>& ownNumbersOf(Block block) {
  static const std::vector<std::vector<OwnNumber>> kNumbers = ownNumbersOf(kList);
  return kNumbers.at(static_cast<std::size_t>(block));
}

bool isDecimal(int id) {
  constexpr int kFirst = 1000;
  constexpr int kLast = 1999;
  return id >= kFirst && id <= kLast;
}

/// Its place among the errors of a block: own numbers of common failures, then those of the book that the
/// block is from, then this layer's.
std::tuple<std::size_t, bool, int> placeOf(Block block, int id) {
  const int own = ownErrorId(block, id);
  const auto& first = ownNumbersOf(block);
  const auto found =
      std::find_if(first.begin(), first.end(), [own](const OwnNumber& number) { return number.own == own; });
  return {static_cast<std::size_t>(found - first.begin()), !isDecimal(own), own};
}

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

int ownErrorId(Block block, int id) {
  const auto& numbers = ownNumbersOf(block);
  const auto found =
      std::find_if(numbers.begin(), numbers.end(), [id](const OwnNumber& n) { return n.general == id; });
  return found == numbers.end() ? id : found->own;
}

int generalErrorId(Block block, int id) {
  const auto& numbers = ownNumbersOf(block);
  const auto found =
      std::find_if(numbers.begin(), numbers.end(), [id](const OwnNumber& n) { return n.own == id; });
  return found == numbers.end() ? id : found->general;
}

bool decidesBefore(Block block, int id, int other) {
  return placeOf(block, id) < placeOf(block, other);
}

std::string errorNumber(int id) {
  return isDecimal(id) ? fmt::format("{}", id) : fmt::format("16#{:X}", id);
}

}  // namespace cobot_command::blocks
