// Reading EBNF: brackets become rules, what is said in words ends at the tokens.
// SPDX-License-Identifier: MIT
#include "grammar/editor/notation.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <optional>

#include "base/check.hpp"
#include "grammar/editor/texts.hpp"

namespace rmpl::grammar {
namespace {

using Kind = NotationSymbol::Kind;

/// Rules that are tokens here: the scanner knows what they look like.
const std::map<std::string_view, Kind> tokens = {
    {"name", Kind::name}, {"number", Kind::number}, {"whole-number", Kind::whole_number}, {"string", Kind::string}};

bool is_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '-'; }

}  // namespace

/// Reads one rule after the other; a rule that is there already is left as it is.
class NotationReader {
 public:
  NotationReader(Notation& notation, std::map<std::string, std::size_t>& rules) : notation_(notation), rules_(rules) {}

  void run(std::string_view text) {
    text_ = text;
    at_ = 0;
    while (peek()) {
      const std::string name = word();
      expect('=');
      const bool known = defined(name) || tokens.contains(name);
      owner_ = known ? std::string() : name;
      const std::size_t rule = known ? notation_.add_rule(name) : number(name);
      alternatives(rule);
      expect(';');
    }
  }

 private:
  bool defined(const std::string& name) {
    const auto found = rules_.find(name);
    return found != rules_.end() && !notation_.by_rule_[found->second].empty();
  }
  std::size_t number(const std::string& name) {
    const auto found = rules_.find(name);
    if (found != rules_.end()) return found->second;
    return rules_[name] = notation_.add_rule(name);
  }

  std::optional<char> peek() {
    while (at_ < text_.size()) {
      if (text_.substr(at_).starts_with("(*")) {
        at_ = std::min(text_.find("*)", at_), text_.size() - 2) + 2;
      } else if (std::isspace(static_cast<unsigned char>(text_[at_])) != 0) {
        ++at_;
      } else {
        return text_[at_];
      }
    }
    return std::nullopt;
  }
  bool take(char c) {
    if (peek() != c) return false;
    ++at_;
    return true;
  }
  void expect(char c) { CHECK(take(c) && "the notation is that of ISO/IEC 14977"); }
  std::string word() {
    const std::size_t begin = at_;
    while (at_ < text_.size() && is_word(text_[at_])) ++at_;
    CHECK(at_ > begin);
    return std::string(text_.substr(begin, at_ - begin));
  }
  std::string until(char end) {
    const std::size_t begin = at_;
    at_ = std::min(text_.find(end, at_), text_.size() - 1) + 1;
    return std::string(text_.substr(begin, at_ - 1 - begin));
  }

  void alternatives(std::size_t rule) {
    do {
      Production production{rule, {}};
      do {
        if (auto symbol = factor()) production.symbols.push_back(std::move(*symbol));
      } while (take(','));
      add(std::move(production));
    } while (take('|'));
  }
  void add(Production production) {
    notation_.by_rule_[production.rule].push_back(notation_.productions_.size());
    notation_.productions_.push_back(std::move(production));
  }
  /// Brackets as a rule that belongs to the one around them.
  std::size_t bracket(char close) {
    const std::size_t rule = notation_.add_rule(owner_);
    alternatives(rule);
    expect(close);
    return rule;
  }
  std::optional<NotationSymbol> factor() {
    const auto next = peek();
    CHECK(next.has_value());
    std::optional<NotationSymbol> symbol;
    if (*next == '"' || *next == '\'') {
      ++at_;
      symbol = NotationSymbol{Kind::literal, 0, until(*next)};
    } else if (take('?')) {
      until('?');
    } else if (take('(')) {
      symbol = NotationSymbol{Kind::rule, bracket(')'), {}};
    } else if (take('[')) {
      const std::size_t rule = bracket(']');
      add({rule, {}});
      symbol = NotationSymbol{Kind::rule, rule, {}};
    } else if (take('{')) {
      const std::size_t inner = bracket('}');
      const std::size_t rule = notation_.add_rule(owner_);
      add({rule, {}});
      add({rule, {{Kind::rule, rule, {}}, {Kind::rule, inner, {}}}});
      symbol = NotationSymbol{Kind::rule, rule, {}};
    } else {
      const std::string name = word();
      const auto token = tokens.find(name);
      symbol =
          token != tokens.end() ? NotationSymbol{token->second, 0, {}} : NotationSymbol{Kind::rule, number(name), {}};
    }
    if (take('-')) (void)factor();  // an exception: only of tokens
    return symbol;
  }

  Notation& notation_;
  std::map<std::string, std::size_t>& rules_;
  std::string_view text_;
  std::size_t at_ = 0;
  std::string owner_;
};

Notation::Notation(const std::vector<std::string_view>& texts) {
  std::map<std::string, std::size_t> rules;
  NotationReader reader(*this, rules);
  for (const std::string_view text : texts) reader.run(text);
  find_empty();
}

std::size_t Notation::add_rule(std::string name) {
  names_.push_back(std::move(name));
  by_rule_.emplace_back();
  return names_.size() - 1;
}

void Notation::find_empty() {
  empty_.assign(names_.size(), false);
  for (bool more = true; more;) {
    more = false;
    for (const Production& production : productions_) {
      const bool empty = std::all_of(production.symbols.begin(), production.symbols.end(),
                                     [&](const NotationSymbol& s) { return s.kind == Kind::rule && empty_[s.rule]; });
      if (!empty || empty_[production.rule]) continue;
      empty_[production.rule] = true;
      more = true;
    }
  }
}

const Notation& notation(Language language) {
  static const std::array<Notation, 5> all = {
      Notation({rmpl_notation}), Notation({tcca_notation, rmpl_notation}), Notation({scn_notation, rmpl_notation}),
      Notation({props_notation, rmpl_notation}), Notation({mon_notation, rmpl_notation})};
  return all[static_cast<std::size_t>(language)];
}

}  // namespace rmpl::grammar
