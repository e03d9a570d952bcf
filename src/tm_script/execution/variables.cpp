#include "cobot_command/tm_script/variables.h"

#include <utility>

namespace cobot_command::tm_script {

namespace {

/// An entry of the map costs more than its value.
std::size_t costOf(std::string_view name, const Value& value) {
  constexpr std::size_t kEntry = 128;
  const auto* array = std::get_if<Array>(&value);
  return kEntry + name.size() + sizeOf(value) + (array ? array->items.size() * sizeof(Scalar) : 0);
}

}  // namespace

const Value* Variables::find(std::string_view name) const {
  const auto found = values_.find(name);
  return found == values_.end() ? nullptr : &found->second;
}

bool Variables::set(std::string_view name, Value value) {
  const auto found = values_.find(name);
  const std::size_t before = found == values_.end() ? 0 : costOf(name, found->second);
  const std::size_t after = bytes_ - before + costOf(name, value);
  if (after > kMaxVariableBytes) return false;
  bytes_ = after;
  if (found == values_.end()) {
    values_.emplace(name, std::move(value));
  } else {
    found->second = std::move(value);
  }
  return true;
}

void Variables::clear() {
  values_.clear();
  bytes_ = 0;
}

}  // namespace cobot_command::tm_script
