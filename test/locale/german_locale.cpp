// To be preloaded into a program: all that it does by the locale it then does by that of a desktop in
// Germany, with a decimal comma and dots between thousands, as if it had called setlocale().
#include <clocale>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <locale>

namespace {

constexpr const char* kLocale = "de_DE.UTF-8";

[[noreturn]] void fail(const char* why) {
  std::fprintf(stderr, "the locale %s is not in force: %s\n", kLocale, why);
  std::abort();
}

struct German {
  German() {
    try {
      std::locale::global(std::locale(kLocale));
    } catch (const std::exception& error) {
      fail(error.what());
    }
    if (std::strcmp(std::localeconv()->decimal_point, ",") != 0) fail("it has no decimal comma");
  }
} const german;

}  // namespace
