// What may come next in a text: the words, and in which rules a name.
// SPDX-License-Identifier: MIT
#pragma once

#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "grammar/editor/keywords.hpp"

namespace rmpl::grammar {

struct Expectation {
  std::set<std::string> words;       ///< literals that are words
  std::set<std::string> name_rules;  ///< the rules of the EBNF in which a name may come now
};

/// What may come behind some tokens, by the grammar of the language (Earley, "An efficient context-free parsing
/// algorithm", 1970). A token that cannot stand where it stands is passed over. Cubic at worst in the number of tokens:
/// meant for a statement and what is open around it (`open_statement`).
Expectation expected_after(Language language, const std::vector<std::string_view>& tokens);

/// The tokens of a text that matter for what may come behind it: of each bracket that is open what is before it, and
/// the statement that is not at its end. Comments are left out.
std::vector<std::string_view> open_statement(std::string_view text);

}  // namespace rmpl::grammar
