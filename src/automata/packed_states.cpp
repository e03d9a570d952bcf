#include "cobot_command/automata/packed_states.h"

namespace cobot_command::automata {
namespace {

constexpr unsigned kWordBits = 64;

unsigned bitsFor(StateIndex states) {
  unsigned bits = 0;
  while (bits < kWordBits / 2 && (std::uint64_t{1} << bits) < states) ++bits;
  return bits;
}

/// The multiplication of Fibonacci hashing; the shift brings down what it has mixed into the high bits.
std::uint64_t mix(std::uint64_t hash) {
  hash *= 0x9E3779B97F4A7C15U;
  return hash ^ (hash >> 32U);
}

}  // namespace

PackedStates::PackedStates(const Composition& composition) : slots_(64, 0) {
  unsigned used = 0;
  for (std::size_t automaton = 0; automaton < composition.size(); ++automaton) {
    const unsigned bits = bitsFor(composition.stateCount(automaton));
    if (used + bits > kWordBits) {
      ++words_;
      used = 0;
    }
    fields_.push_back({words_ - 1, used % kWordBits, (std::uint64_t{1} << bits) - 1});
    used += bits;
  }
  key_.resize(words_);
}

void PackedStates::pack(const StateIndex* tuple, std::uint64_t* key) const {
  for (std::size_t word = 0; word < words_; ++word) key[word] = 0;
  for (const Field& field : fields_) key[field.word] |= std::uint64_t{*tuple++} << field.shift;
}

void PackedStates::unpack(Number number, StateIndex* tuple) const {
  const std::uint64_t* key = &keys_[number * words_];
  for (const Field& field : fields_) {
    *tuple++ = static_cast<StateIndex>((key[field.word] >> field.shift) & field.mask);
  }
}

Tuple PackedStates::tuple(Number number) const {
  Tuple tuple(fields_.size());
  unpack(number, tuple.data());
  return tuple;
}

bool PackedStates::isAt(Number number, const std::uint64_t* key) const {
  const std::uint64_t* known = &keys_[number * words_];
  for (std::size_t word = 0; word < words_; ++word) {
    if (known[word] != key[word]) return false;
  }
  return true;
}

std::size_t PackedStates::slotOf(const std::uint64_t* key) const {
  std::uint64_t hash = 0;
  for (std::size_t word = 0; word < words_; ++word) hash = mix(hash ^ key[word]);
  std::size_t slot = hash & (slots_.size() - 1);
  while (slots_[slot] != 0 && !isAt(slots_[slot] - 1, key)) slot = (slot + 1) & (slots_.size() - 1);
  return slot;
}

PackedStates::Inserted PackedStates::insert(const StateIndex* tuple) {
  pack(tuple, key_.data());
  std::size_t slot = slotOf(key_.data());
  if (slots_[slot] != 0) return {slots_[slot] - 1, false};
  if (2 * (std::size_t{size_} + 1) > slots_.size()) {
    grow();
    slot = slotOf(key_.data());
  }
  keys_.insert(keys_.end(), key_.begin(), key_.end());
  slots_[slot] = ++size_;
  return {size_ - 1, true};
}

std::optional<PackedStates::Number> PackedStates::find(const StateIndex* tuple) const {
  std::vector<std::uint64_t> key(words_);
  pack(tuple, key.data());
  const std::size_t slot = slotOf(key.data());
  if (slots_[slot] == 0) return std::nullopt;
  return slots_[slot] - 1;
}

void PackedStates::grow() {
  slots_.assign(2 * slots_.size(), 0);
  for (Number number = 0; number < size_; ++number) {
    slots_[slotOf(&keys_[number * words_])] = number + 1;
  }
}

}  // namespace cobot_command::automata
