// The rows of the thesis's error tables, as they stand there.
#pragma once

#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <utility>

#include "source_tree.h"
#include <gtest/gtest.h>

#include "cobot_command/blocks/list/goal.h"
#include "cobot_command/blocks/shared/error_catalogue.h"

namespace cobot_command::testing {

struct ThesisTexts {
  std::string description;
  std::string action;
};

inline blocks::Block blockNamed(const std::string& name) {
  for (std::size_t i = 0; i < blocks::kBlockCount; ++i) {
    if (name == toString(static_cast<blocks::Block>(i))) return static_cast<blocks::Block>(i);
  }
  ADD_FAILURE() << name;
  return blocks::kBlock<blocks::ConnectGoal>;
}

/// Block, id in hexadecimal, description, action.
inline std::map<std::pair<blocks::Block, int>, ThesisTexts> thesisRows() {
  std::ifstream file(test_support::inSourceTree("test/data/thesis-errors.tsv"));
  std::map<std::pair<blocks::Block, int>, ThesisTexts> rows;
  for (std::string line; std::getline(file, line);) {
    std::istringstream fields(line);
    std::string block;
    std::string id;
    ThesisTexts texts;
    std::getline(fields, block, '\t');
    std::getline(fields, id, '\t');
    std::getline(fields, texts.description, '\t');
    std::getline(fields, texts.action, '\t');
    rows[{blockNamed(block), std::stoi(id, nullptr, 16)}] = texts;
  }
  return rows;
}

}  // namespace cobot_command::testing
