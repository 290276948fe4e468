// What parses can be formatted, and what is formatted is settled: for the fuzz targets of the parsers.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdlib>

#include "compiler/format/format.hpp"

namespace rmpl::fuzz {

/// Aborts where it is not so. That the tree stays what it is, the formatter checks by itself.
inline void check_format(std::string_view text, compiler::Kind kind) {
  const auto once = compiler::format(text, kind);
  if (!once || compiler::format(*once, kind) != once) std::abort();
}

}  // namespace rmpl::fuzz
