// A range of adjacent elements in memory, for range-based loops.
#pragma once

#include <cstddef>

namespace cobot_command::automata {

template <class T>
class Range {
 public:
  Range(const T* first, const T* last) : first_(first), last_(last) {}
  [[nodiscard]] const T* begin() const { return first_; }
  [[nodiscard]] const T* end() const { return last_; }
  [[nodiscard]] bool empty() const { return first_ == last_; }
  [[nodiscard]] std::size_t size() const { return static_cast<std::size_t>(last_ - first_); }

 private:
  const T* first_;
  const T* last_;
};

}  // namespace cobot_command::automata
