// Makes findings of the rows of finding_kinds.h.
#pragma once

#include <string>
#include <string_view>

#include <fmt/format.h>

#include "cobot_command/common/foreign_text.h"
#include "cobot_command/rapid/source/finding.h"
#include "cobot_command/rapid/source/finding_kinds.h"

namespace cobot_command::rapid {

/// `values` replace each `{}`. Text of the file must have gone through quoted().
template <class... Values>
[[nodiscard]] Finding finding(const FindingKind& kind, Span span, const Values&... values) {
  return {kind.id, span, fmt::format(fmt::runtime(kind.text), values...)};
}

/// Text of the file as it is shown in a finding.
[[nodiscard]] inline std::string quoted(std::string_view text) {
  return foreignText(text, kQuoteLimit);
}

}  // namespace cobot_command::rapid
