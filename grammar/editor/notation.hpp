// The grammars as data: read from their EBNF (ISO/IEC 14977), for what wants to know what may come next.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "grammar/editor/keywords.hpp"

namespace rmpl::grammar {

/// What stands in a production: a rule by its number, or a token.
struct NotationSymbol {
  enum class Kind { rule, literal, name, number, whole_number, string };
  Kind kind = Kind::rule;
  std::size_t rule = 0;
  std::string text;  ///< of a literal
};

/// One way to write a rule.
struct Production {
  std::size_t rule = 0;
  std::vector<NotationSymbol> symbols;
};

/// A grammar without brackets: what stood in them is a rule of its own, which belongs to the rule around it.
class Notation {
 public:
  /// `texts`: the EBNF of the language, then of those whose rules it uses. The first rule is where it starts.
  explicit Notation(const std::vector<std::string_view>& texts);

  [[nodiscard]] const std::vector<Production>& productions() const { return productions_; }
  /// The productions of a rule, by their numbers.
  [[nodiscard]] const std::vector<std::size_t>& of(std::size_t rule) const { return by_rule_[rule]; }
  [[nodiscard]] bool may_be_empty(std::size_t rule) const { return empty_[rule]; }
  /// The name of a rule, or of the rule that a bracket belongs to.
  [[nodiscard]] const std::string& name(std::size_t rule) const { return names_[rule]; }

 private:
  friend class NotationReader;
  std::size_t add_rule(std::string name);
  void find_empty();

  std::vector<Production> productions_;
  std::vector<std::vector<std::size_t>> by_rule_;
  std::vector<std::string> names_;
  std::vector<bool> empty_;
};

/// The grammar of a language, with the rules of rmpl.ebnf that it uses.
const Notation& notation(Language language);

}  // namespace rmpl::grammar
