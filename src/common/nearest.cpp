#include "cobot_command/common/nearest.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace cobot_command {

namespace {

/// Of Damerau and Levenshtein, with neighbours swapped once at most.
std::size_t distance(std::string_view from, std::string_view to) {
  std::vector<std::size_t> before(to.size() + 1);
  std::vector<std::size_t> last(to.size() + 1);
  std::iota(last.begin(), last.end(), std::size_t{0});
  for (std::size_t i = 1; i <= from.size(); ++i) {
    std::vector<std::size_t> row(to.size() + 1, i);
    for (std::size_t j = 1; j <= to.size(); ++j) {
      const std::size_t changed = last[j - 1] + (from[i - 1] == to[j - 1] ? 0 : 1);
      row[j] = std::min({row[j - 1] + 1, last[j] + 1, changed});
      if (i > 1 && j > 1 && from[i - 1] == to[j - 2] && from[i - 2] == to[j - 1]) {
        row[j] = std::min(row[j], before[j - 2] + 1);
      }
    }
    before = std::exchange(last, std::move(row));
  }
  return last.back();
}

}  // namespace

std::string nearestOf(std::string_view word, const std::vector<std::string>& known, std::size_t most) {
  // A third of a word may be wrong; a longer one than any name is not worth the work.
  constexpr std::size_t kLongestWord = 64;
  std::size_t least = std::min(most, std::max<std::size_t>(1, word.size() / 3)) + 1;
  std::string nearest;
  if (word.size() > kLongestWord) return nearest;
  for (const std::string& name : known) {
    const std::size_t steps = distance(word, name);
    if (steps < least) {
      least = steps;
      nearest = name;
    }
  }
  return nearest;
}

}  // namespace cobot_command
