// Grammars in EBNF (ISO/IEC 14977), as they are written in grammar/*.ebnf.
// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace rmpl::sentences {

/// An expression of a grammar.
struct Expression {
  enum class Kind {
    sequence,   ///< `a, b`
    choice,     ///< `a | b`
    optional,   ///< `[ a ]`
    repeated,   ///< `{ a }`
    exception,  ///< `a - b`
    terminal,   ///< `"a"`
    rule,       ///< `a`
    special     ///< `? in words ?`
  };
  Kind kind = Kind::sequence;
  std::string text;  ///< of a terminal, a rule or a special
  std::vector<Expression> parts;
};

/// Rules by name.
using Grammar = std::map<std::string, Expression>;

/// Adds the rules of a text to a grammar. Throws std::runtime_error where it is no EBNF, or a rule is there already.
void read_ebnf(std::string_view text, Grammar& grammar);

}  // namespace rmpl::sentences
