// Taking declarations out of a text, with all that belongs to them and nothing else.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <map>
#include <string_view>
#include <vector>

#include "compiler/format/tokens.hpp"
#include "grammar/source/diagnostic.hpp"
#include "grammar/source/source_file.hpp"

namespace rmpl::compiler {

/// Whether a comment says what lint is to allow, or tries to: it begins with `lint:`.
bool speaks_to_lint(std::string_view comment);

/// The edits that take declarations out. What stands alone on its lines goes with them, and with the comments that
/// allow findings there; one blank line stays where there was one on either side. There are no edits where another
/// comment stands within the statement, right above or right behind: nobody but its author knows what it speaks of.
class Removals {
 public:
  /// Refers to the sources.
  explicit Removals(const grammar::Sources& sources) : sources_(sources) {}

  /// The statement that a part of it lies in: from behind the last `;`, `{` or `}` before it to its `;`.
  std::vector<grammar::Edit> of_statement(grammar::Span part);
  /// A name that a statement lists, with its comma; the statement, where it lists no other.
  std::vector<grammar::Edit> of_name(grammar::Span name);

 private:
  const Tokens& tokens(std::uint32_t file);
  const grammar::Sources& sources_;
  std::map<std::uint32_t, Tokens> tokens_;  ///< by file, of those that were asked about
};

/// Where there are edits, they are what to do about a finding.
void propose(grammar::Diagnostic& finding, std::vector<grammar::Edit> removal);

}  // namespace rmpl::compiler
