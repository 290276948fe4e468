// Putting the sure fixes of findings into their texts.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "grammar/source/diagnostic.hpp"
#include "grammar/source/source_file.hpp"

namespace rmpl::compiler {

/// What becomes of some texts, and what is still to be told of them.
struct Fixed {
  std::map<std::uint32_t, std::string> texts;  ///< by file; those that change
  std::vector<grammar::Diagnostic> left;       ///< without a fix, or in the way of one before it
  std::size_t count = 0;                       ///< findings that are fixed
};

/// Takes the fixes in order; one that overlaps with one before it is left for the next run. A text that was laid out as
/// `format` does is so afterwards.
Fixed apply_fixes(std::span<const grammar::Diagnostic> found, const grammar::Sources& sources);

}  // namespace rmpl::compiler
