// Result<T, E>: either a value or the reason why there is none.
//
// Every operation that can be refused returns one, and the caller must check it. Exceptions do not cross
// rooms (the modules of src/).
#pragma once

#include <utility>

#include <tl/expected.hpp>

namespace cobot_command {

template <class T, class E>
class [[nodiscard]] Result : public tl::expected<T, E> {
 public:
  using tl::expected<T, E>::expected;
};

/// Creates a Result that holds an error: `return refuse(MyError{...});`
template <class E>
[[nodiscard]] tl::unexpected<std::decay_t<E>> refuse(E&& error) {
  return tl::unexpected<std::decay_t<E>>(std::forward<E>(error));
}

}  // namespace cobot_command
