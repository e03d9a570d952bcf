// What an entry must be, by itself and beside the others.
#pragma once

#include <optional>

#include "cobot_command/tables/data_tables.h"

namespace cobot_command::tables {

/// A number that can be written, of that kind.
[[nodiscard]] std::optional<Refusal> checkIndex(Kind kind, int index);

/// That entry, and all that refers to it. Precondition: checkIndex() has nothing against it.
[[nodiscard]] std::optional<Refusal> checkEntry(Kind kind, int index, const Entries& all,
                                                const Payload& payload);

/// All entries; those of number 0 are as they are fixed.
[[nodiscard]] std::optional<Refusal> checkAll(const Entries& all, const Payload& payload);

}  // namespace cobot_command::tables
