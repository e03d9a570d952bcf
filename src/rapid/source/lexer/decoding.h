// From the bytes of a file to text.
#pragma once

#include <string>
#include <string_view>

#include "cobot_command/common/result.h"
#include "cobot_command/rapid/source/encoding.h"
#include "cobot_command/rapid/source/finding.h"

namespace cobot_command::rapid {

struct DecodedText {
  std::string text;  ///< UTF-8
  Encoding encoding = Encoding::Utf8;
};

/// The text of a file; or E901, E902 or E904 at its beginning, if it has none. A byte order mark followed by
/// invalid text is E901: the file is damaged, and to read it in another encoding would hide that.
[[nodiscard]] Result<DecodedText, Finding> decoded(std::string_view bytes);

}  // namespace cobot_command::rapid
