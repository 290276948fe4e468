// Comments that allow a finding: `// lint: allow RMPL0514 because …`, or the same between `/*` and `*/`.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "compiler/session/files.hpp"
#include "grammar/source/diagnostic.hpp"
#include "grammar/source/source_file.hpp"

namespace rmpl::compiler {

/// A code that a comment allows on a line.
struct Allowance {
  grammar::Code code;
  grammar::Span span;     ///< of the code
  grammar::Span comment;  ///< all of it
  std::uint32_t line;     ///< of the finding: that of the comment, or where nothing else stands on it, the next
  std::string reason;     ///< what stands behind `because`, on one line
};

/// The allowances in a text. A malformed allowance is reported as a finding.
std::vector<Allowance> allowances_in(const grammar::Sources& sources, std::uint32_t file, grammar::Diagnostics& found);

/// The findings that no comment allows, and the faults of the comments themselves. Errors cannot be allowed. An unused
/// allowance is a finding with a fix if the user named its file. Otherwise it is a note without a fix, since another
/// input set may need it. Those that are allowed are added to `allowed`.
grammar::Diagnostics without_allowed(const grammar::Diagnostics& found, const grammar::Sources& sources,
                                     std::span<const File> files, std::vector<grammar::AllowedFinding>& allowed);

}  // namespace rmpl::compiler
