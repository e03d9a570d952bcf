#include "source_tree.h"

namespace cobot_command::test_support {

std::string inSourceTree(const std::string& path) {
  return COBOT_SOURCE_TREE "/" + path;
}

}  // namespace cobot_command::test_support
