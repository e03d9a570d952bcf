// Whether a sanitizer watches this process: everything takes far longer then, and the heap is the sanitizer's
// own.
#pragma once

namespace cobot_command::testing {

#if defined(COBOT_WATCHED)  // the rooms alone are
inline constexpr bool kIsWatched = true;
#elif defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
inline constexpr bool kIsWatched = true;
#elif defined(__has_feature)  // clang says it so
inline constexpr bool kIsWatched = __has_feature(address_sanitizer) || __has_feature(thread_sanitizer);
#else
inline constexpr bool kIsWatched = false;
#endif

}  // namespace cobot_command::testing
