// What a test measures on the side. It is printed and not asserted: on a loaded machine a wall clock proves
// nothing. `scripts/figures` runs the tests that have figures thoroughly, and makes a table of them.
#pragma once

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

namespace cobot_command::testing {

/// The figure of a goal of doc/reliability.md; printed when it goes out of scope.
class Figure {
 public:
  enum class Limited { Worst, NinetyNinthPercentile };

  /// `what`: in plain words. `limit`: of the goal, in `unit`, for the worst value or for 99 % of them.
  Figure(std::string goal, std::string what, std::string unit, double limit, Limited limited = Limited::Worst)
      : goal_(std::move(goal)),
        what_(std::move(what)),
        unit_(std::move(unit)),
        limit_(limit),
        limited_(limited) {}
  ~Figure() {
    if (!values_.empty()) {
      print();
    }
  }
  Figure(const Figure&) = delete;
  Figure& operator=(const Figure&) = delete;

  void add(double value) { values_.push_back(value); }
  /// In ms.
  void add(std::chrono::steady_clock::duration time) {
    add(std::chrono::duration<double, std::milli>(time).count());
  }

 private:
  [[nodiscard]] double percentile(std::size_t percent) const {
    return values_[(values_.size() * percent + 99) / 100 - 1];
  }
  void print() {
    std::sort(values_.begin(), values_.end());
    const double judged = limited_ == Limited::Worst ? values_.back() : percentile(99);
    std::printf("figure: | %s | %s | %zu | %.4g | %.4g | %.4g | %s | %s %g | %s |\n", goal_.c_str(),
                what_.c_str(), values_.size(), percentile(50), percentile(99), values_.back(), unit_.c_str(),
                limited_ == Limited::Worst ? "all" : "99 %", limit_, judged <= limit_ ? "holds" : "OVER");
  }

  const std::string goal_, what_, unit_;
  const double limit_;
  const Limited limited_;
  std::vector<double> values_;
};

/// How long a call takes.
template <class Call>
[[nodiscard]] std::chrono::steady_clock::duration timeOf(const Call& call) {
  const auto start = std::chrono::steady_clock::now();
  call();
  return std::chrono::steady_clock::now() - start;
}

}  // namespace cobot_command::testing
