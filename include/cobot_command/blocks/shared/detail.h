// The part of a goal's outcome or progress that is specific to one block: a struct of its own, in the block's
// header next to the goal. Code that does not know the block passes it on; code that knows the block reads
// it.
#pragma once

#include <cassert>
#include <memory>
#include <type_traits>
#include <typeinfo>
#include <utility>

namespace cobot_command::blocks {

/// A value of any type, or none. Immutable: copies share the value, on any threads, whatever its size.
class Detail {
 public:
  Detail() = default;
  template <class Kind>
  explicit Detail(Kind value) : kind_(&typeid(Kind)), value_(std::make_shared<const Kind>(std::move(value))) {
    static_assert(std::is_class_v<Kind>, "a detail has a name, and so have its fields");
  }

  [[nodiscard]] bool isNone() const { return value_ == nullptr; }

  /// nullptr: there is no value, or one of another type.
  template <class Kind>
  [[nodiscard]] const Kind* find() const {
    return !isNone() && *kind_ == typeid(Kind) ? static_cast<const Kind*>(value_.get()) : nullptr;
  }

  /// The value, or a default Kind if there is none. Precondition: there is no value of another type.
  template <class Kind>
  [[nodiscard]] const Kind& as() const {
    static const Kind kNone{};
    const Kind* const found = find<Kind>();
    assert(found != nullptr || isNone());
    return found != nullptr ? *found : kNone;
  }

 private:
  const std::type_info* kind_ = nullptr;
  std::shared_ptr<const void> value_;
};

}  // namespace cobot_command::blocks
