// A set of tuples of local states, packed into as few bits as possible and numbered in the order of
// insertion.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "cobot_command/automata/composition.h"

namespace cobot_command::automata {

class PackedStates {
 public:
  using Number = std::uint32_t;

  explicit PackedStates(const Composition& composition);

  struct Inserted {
    Number number = 0;
    bool is_new = false;
  };
  /// Precondition: fewer than 2^32 - 1 states are stored.
  Inserted insert(const StateIndex* tuple);
  [[nodiscard]] std::optional<Number> find(const StateIndex* tuple) const;

  [[nodiscard]] Number size() const { return size_; }
  void unpack(Number number, StateIndex* tuple) const;
  [[nodiscard]] Tuple tuple(Number number) const;

 private:
  /// Position of a local state. It never crosses the end of a word.
  struct Field {
    std::size_t word = 0;
    unsigned shift = 0;
    std::uint64_t mask = 0;
  };

  void pack(const StateIndex* tuple, std::uint64_t* key) const;
  [[nodiscard]] bool isAt(Number number, const std::uint64_t* key) const;
  [[nodiscard]] std::size_t slotOf(const std::uint64_t* key) const;
  void grow();

  std::vector<Field> fields_;
  std::size_t words_ = 1;
  std::vector<std::uint64_t> keys_;  ///< `words_` per state, by number
  std::vector<Number> slots_;        ///< number + 1; 0: free. The size is a power of two
  std::vector<std::uint64_t> key_;   ///< key of the state that is being inserted
  Number size_ = 0;
};

}  // namespace cobot_command::automata
