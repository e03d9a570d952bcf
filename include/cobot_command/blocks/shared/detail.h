// What only one block tells, of a goal's end or of its progress: a struct of its own, in the block's header
// beside the goal. It is carried by who does not know it, and read by who knows the block.
#pragma once

#include <cassert>
#include <memory>
#include <type_traits>
#include <typeinfo>
#include <utility>

namespace cobot_command::blocks {

/// A value of any kind, or none. Immutable: copies share it, on any threads, whatever its size.
class Detail {
 public:
  Detail() = default;
  template <class Kind>
  explicit Detail(Kind value) : kind_(&typeid(Kind)), value_(std::make_shared<const Kind>(std::move(value))) {
    static_assert(std::is_class_v<Kind>, "a detail has a name, and so have its fields");
  }

  [[nodiscard]] bool isNone() const { return value_ == nullptr; }

  /// Nothing (nullptr) when there is none, or one of another kind.
  template <class Kind>
  [[nodiscard]] const Kind* find() const {
    return !isNone() && *kind_ == typeid(Kind) ? static_cast<const Kind*>(value_.get()) : nullptr;
  }

  /// What a Kind is by default when there is none. Precondition: there is none of another kind.
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
