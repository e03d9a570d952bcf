// Where the tests find files of the sources. In a function, as the path in a definition for every test would
// make the compiler cache useless for every other clone.
#pragma once

#include <string>

namespace cobot_command::test_support {

/// `path` within the sources, "doc/errors.md" for instance, as a path of this machine.
[[nodiscard]] std::string inSourceTree(const std::string& path);

}  // namespace cobot_command::test_support
