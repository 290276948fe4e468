// Earley's recogniser, run up to the cursor; what its items wait for is what may come.
// SPDX-License-Identifier: MIT
#include "grammar/editor/expectation.hpp"

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <tuple>

#include "grammar/editor/notation.hpp"
#include "grammar/editor/tokens.hpp"
#include "grammar/parse/scan.hpp"

namespace rmpl::grammar {
namespace {

using Kind = NotationSymbol::Kind;

/// A production up to its dot, begun behind so many tokens.
struct Item {
  std::size_t production;
  std::size_t dot;
  std::size_t origin;
  auto operator<=>(const Item&) const = default;
};

bool is_word(std::string_view text) {
  return !text.empty() && (std::isalpha(static_cast<unsigned char>(text.front())) != 0 || text.front() == '_');
}

bool matches(const NotationSymbol& symbol, std::string_view token) {
  switch (symbol.kind) {
    case Kind::rule:
      return false;
    case Kind::literal:
      return token == symbol.text;
    case Kind::name:
      return is_word(token) && !is_reserved(token);
    case Kind::number:
    case Kind::whole_number:
      return std::isdigit(static_cast<unsigned char>(token.front())) != 0;
    case Kind::string:
      return token.front() == '"';
  }
  return false;
}

class Recogniser {
 public:
  explicit Recogniser(const Notation& notation) : notation_(notation) {
    sets_.emplace_back();
    for (const std::size_t production : notation_.of(0)) add({production, 0, 0});
    complete();
  }

  void feed(std::string_view token) {
    std::vector<Item> moved;
    for (const Item& item : sets_.back()) {
      const NotationSymbol* next = symbol(item);
      if (next != nullptr && matches(*next, token)) moved.push_back({item.production, item.dot + 1, item.origin});
    }
    if (moved.empty()) return;
    sets_.emplace_back();
    seen_.clear();
    for (const Item& item : moved) add(item);
    complete();
  }

  Expectation expected() const {
    Expectation result;
    for (const Item& item : sets_.back()) {
      const NotationSymbol* next = symbol(item);
      if (next == nullptr) continue;
      if (next->kind == Kind::literal && is_word(next->text)) result.words.insert(next->text);
      if (next->kind == Kind::name) result.name_rules.insert(notation_.name(rule(item)));
    }
    return result;
  }

 private:
  [[nodiscard]] std::size_t rule(const Item& item) const { return notation_.productions()[item.production].rule; }
  [[nodiscard]] const NotationSymbol* symbol(const Item& item) const {
    const auto& symbols = notation_.productions()[item.production].symbols;
    return item.dot < symbols.size() ? &symbols[item.dot] : nullptr;
  }
  void add(const Item& item) {
    if (seen_.insert(item).second) sets_.back().push_back(item);
  }
  /// Adds what the items of the last set begin and end. Rules that may be empty are stepped over at once (Aycock and
  /// Horspool, "Practical Earley parsing", 2002).
  void complete() {
    for (std::size_t i = 0; i < sets_.back().size(); ++i) {
      const Item item = sets_.back()[i];
      const NotationSymbol* next = symbol(item);
      if (next == nullptr) {
        end(item);
      } else if (next->kind == Kind::rule) {
        for (const std::size_t production : notation_.of(next->rule)) add({production, 0, sets_.size() - 1});
        if (notation_.may_be_empty(next->rule)) add({item.production, item.dot + 1, item.origin});
      }
    }
  }
  void end(const Item& ended) {
    for (std::size_t i = 0; i < sets_[ended.origin].size(); ++i) {
      const Item item = sets_[ended.origin][i];
      const NotationSymbol* next = symbol(item);
      if (next != nullptr && next->kind == Kind::rule && next->rule == rule(ended))
        add({item.production, item.dot + 1, item.origin});
    }
  }

  const Notation& notation_;
  std::vector<std::vector<Item>> sets_;  ///< per token that was fed
  std::set<Item> seen_;                  ///< in the last set
};

constexpr std::size_t most_tokens = 2000;

}  // namespace

Expectation expected_after(Language language, const std::vector<std::string_view>& tokens) {
  if (tokens.size() > most_tokens) return {};
  Recogniser recogniser(notation(language));
  for (const std::string_view token : tokens) recogniser.feed(token);
  return recogniser.expected();
}

std::vector<std::string_view> open_statement(std::string_view text) {
  std::vector<std::string_view> kept;
  std::vector<std::size_t> open{0};  // per bracket that is open, where what stands in it begins
  for (const TextToken& token : tokens_of(text)) {
    if (token.kind == TokenKind::comment) continue;
    const std::string_view word = token.in(text);
    kept.push_back(word);
    if (word == "{") open.push_back(kept.size());
    if (word == "}" && open.size() > 1) open.pop_back();
    if (word == ";" || (word == "}" && open.size() == 1)) kept.resize(open.back());
  }
  return kept;
}

}  // namespace rmpl::grammar
