// Drawing sentences: an alternative by chance, and from some depth on the shallowest.
// SPDX-License-Identifier: MIT
#include "tests/sentences/sentences.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include "tests/paths.hpp"

namespace rmpl::sentences {
namespace {

using compiler::Kind;
using Part = Expression::Kind;

constexpr std::size_t no_depth = 1000;
constexpr std::size_t depth_limit = 24;
/// Definitions that are called so cannot be called (grammar/rmpl.ebnf).
constexpr std::array<std::string_view, 5> uncallable = {"surprise", "noplan", "possible", "likely", "repeat"};
/// Rules whose characters make one token.
constexpr std::array<std::string_view, 7> token_names = {"name",         "identifier", "number", "signed-number",
                                                         "whole-number", "string",     "digits"};

std::string read(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw std::runtime_error(path + ": cannot be read");
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

const char* start_of(Kind kind) {
  switch (kind) {
    case Kind::program:
      return "program-file";
    case Kind::plant:
      return "plant-file";
    case Kind::scenario:
      return "scenario-file";
    default:
      return "property-file";
  }
}

std::uint64_t below(Random& random, std::uint64_t count) { return random() % count; }
bool one_in(Random& random, std::uint64_t count) { return below(random, count) == 0; }

bool is_word(const std::string& token) {
  return std::isalpha(static_cast<unsigned char>(token.front())) != 0 || token.front() == '_';
}
bool is_number(const std::string& token) { return std::isdigit(static_cast<unsigned char>(token.front())) != 0; }

}  // namespace

/// One sentence on its way.
class Sentences::Drawing {
 public:
  Drawing(const Sentences& sentences, Random& random) : sentences_(sentences), random_(random) {}

  std::vector<std::string> draw(const std::string& start) {
    do {
      all_.clear();
      lone_.clear();
      unitless_.clear();
      calls_.clear();
      open_ifs_.clear();
      stolen_ = false;
      expand(sentences_.grammar_.at(start), 0);
    } while (is_excluded());
    return std::move(all_);
  }

 private:
  /// Appends tokens.
  void expand(const Expression& from, std::size_t depth) {
    switch (from.kind) {
      case Part::sequence:
        for (const Expression& part : from.parts) expand(part, depth);
        break;
      case Part::choice:
        expand(choose(from, depth), depth);
        break;
      case Part::optional:
        if (depth < depth_limit && one_in(random_, 2)) expand(from.parts.front(), depth);
        break;
      case Part::repeated:
        // Several items of a file and of what is in braces, and few of all else, so that sentences stay small.
        while (depth < depth_limit && (depth <= 2 ? !one_in(random_, 4) : one_in(random_, 5))) {
          expand(from.parts.front(), depth);
        }
        break;
      case Part::terminal:
        if (from.text == "elsenext") meet_else();
        all_.push_back(from.text);
        break;
      case Part::rule:
        expand_rule(from.text, depth + 1);
        break;
      default:
        throw std::runtime_error("only tokens have exceptions and specials");
    }
  }

  void expand_rule(const std::string& name, std::size_t depth) {
    if (std::find(token_names.begin(), token_names.end(), name) != token_names.end()) {
      all_.push_back(name == "name" ? draw_name() : characters(sentences_.grammar_.at(name)));
      return;
    }
    const std::size_t first = all_.size();
    if (name == "simple-step") has_else_.push_back(false);
    if (name == "call") calls_.push_back(first);
    expand(sentences_.grammar_.at(name), depth);
    if (name == "simple-step") {
      if (all_[first] == "if" && !has_else_.back()) open_ifs_.push_back(all_.size());
      has_else_.pop_back();
    }
    // `maintaining` too belongs to the nearest step, and so an `if` before it is still open behind it.
    const bool is_ending = name == "constraint" && first > 0 && all_[first - 1] == "maintaining";
    if (is_ending && is_open_if(first - 1)) open_ifs_.push_back(all_.size());
    const bool is_bare = name == "atom" && all_.size() == first + 1 && all_.back() != "true" && all_.back() != "false";
    if (is_bare) lone_.push_back(first);
    if (name == "duration" && all_.size() == first + 1) unitless_.push_back(first);
  }

  /// An `elsenext` behind an `if` that has none: it is that one's, and not this step's.
  void meet_else() {
    has_else_.back() = true;
    stolen_ = stolen_ || is_open_if(all_.size());
  }
  /// Whether an `if` without `elsenext` ends before this token.
  [[nodiscard]] bool is_open_if(std::size_t token) const {
    return std::find(open_ifs_.begin(), open_ifs_.end(), token) != open_ifs_.end();
  }

  const Expression& choose(const Expression& from, std::size_t depth) {
    if (depth < depth_limit) return from.parts[below(random_, from.parts.size())];
    return *std::min_element(from.parts.begin(), from.parts.end(), [&](const Expression& one, const Expression& other) {
      return sentences_.depth_of(one) < sentences_.depth_of(other);
    });
  }

  /// Now and then a keyword that is not reserved.
  std::string draw_name() {
    if (one_in(random_, 40)) return sentences_.keywords_[below(random_, sentences_.keywords_.size())];
    return characters(sentences_.grammar_.at("name"));
  }

  /// The characters of one token.
  std::string characters(const Expression& from) {
    std::string text;
    switch (from.kind) {
      case Part::sequence:
        for (const Expression& part : from.parts) text += characters(part);
        return text;
      case Part::choice:
        return characters(from.parts[below(random_, from.parts.size())]);
      case Part::optional:
        return one_in(random_, 3) ? characters(from.parts.front()) : "";
      case Part::repeated:
        for (std::size_t length = 0; length < 12 && !one_in(random_, 4); ++length)
          text += characters(from.parts.front());
        return text;
      case Part::terminal:
        return from.text;
      case Part::rule:
        return from.text == "digits" ? draw_digits() : characters(sentences_.grammar_.at(from.text));
      case Part::exception:
        do {
          text = characters(from.parts.front());
        } while (is_alternative(from.parts.back(), text));
        return text;
      case Part::special:
        return special(from.text);
    }
    return text;
  }

  /// Within the range of a double, also as an exponent.
  std::string draw_digits() { return std::to_string(below(random_, one_in(random_, 3) ? 100 : 10)); }

  [[nodiscard]] bool is_alternative(const Expression& rule, const std::string& text) const {
    const auto& words = sentences_.grammar_.at(rule.text).parts;
    return std::any_of(words.begin(), words.end(), [&](const Expression& word) { return word.text == text; });
  }

  std::string special(const std::string& words) {
    static constexpr std::string_view letters = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ";
    static const std::vector<std::string> others = {"a", "Z", "0", " ", "/", "*", "'", "é", "∧", ";", "{", "}", "-"};
    if (words == " A to Z, a to z ") return std::string(1, letters[below(random_, letters.size())]);
    static constexpr std::string_view digits = "0123456789";
    const std::string_view either = one_in(random_, 3) ? digits : letters;
    if (words == " 0 to 9 ") return std::string(1, digits[below(random_, digits.size())]);
    if (words == " before a letter or digit ") return std::string(1, either[below(random_, either.size())]);
    if (words == " any character but \" and control characters ") return others[below(random_, others.size())];
    throw std::runtime_error("the grammar says in words what is not programmed:" + words);
  }

  /// What the grammar says in its comments: of a bare name that no name or number may follow it; of a number, that a
  /// unit behind it is its own; and that definitions with some names cannot be called.
  [[nodiscard]] bool is_excluded() const {
    const Expression reserved{Part::rule, "reserved", {}};
    const Expression unit{Part::rule, "unit", {}};
    const auto next = [&](std::size_t at) { return at + 1 == all_.size() ? std::string(";") : all_[at + 1]; };
    const auto is_value = [&](const std::string& token) {
      return is_number(token) || token == "true" || token == "false" ||
             (is_word(token) && !is_alternative(reserved, token));
    };
    const auto is_uncallable = [&](std::size_t at) {
      return std::find(uncallable.begin(), uncallable.end(), all_[at]) != uncallable.end();
    };
    return stolen_ || std::any_of(calls_.begin(), calls_.end(), is_uncallable) ||
           std::any_of(lone_.begin(), lone_.end(), [&](std::size_t at) { return is_value(next(at)); }) ||
           std::any_of(unitless_.begin(), unitless_.end(),
                       [&](std::size_t at) { return is_alternative(unit, next(at)); });
  }

  const Sentences& sentences_;
  Random& random_;
  std::vector<std::string> all_;
  std::vector<std::size_t> lone_;      ///< bare names that stand for constraints
  std::vector<std::size_t> unitless_;  ///< durations without a unit
  std::vector<bool> has_else_;         ///< of each step that is not at its end, whether it has an `elsenext` of its own
  std::vector<std::size_t> open_ifs_;  ///< the ends of those that could have one and have not
  std::vector<std::size_t> calls_;     ///< where they begin
  bool stolen_ = false;
};

Sentences::Sentences() {
  for (const char* name : {"rmpl", "tcca", "scn", "props"}) {
    // Rules that several files define are the same there.
    Grammar own;
    read_ebnf(read(paths::source() + "/grammar/" + name + ".ebnf"), own);
    for (auto& [rule, expression] : own) grammar_.emplace(std::string(rule), std::move(expression));
  }
  find_depths();
  for (const auto& [name, expression] : grammar_) find_keywords(expression);
}

std::vector<std::string> Sentences::draw(Kind kind, Random& random) const {
  return Drawing(*this, random).draw(start_of(kind));
}

std::size_t Sentences::depth_of(const Expression& expression) const {
  std::size_t depth = 0;
  switch (expression.kind) {
    case Part::sequence:
      for (const Expression& part : expression.parts) depth = std::max(depth, depth_of(part));
      return depth;
    case Part::choice:
      depth = no_depth;
      for (const Expression& part : expression.parts) depth = std::min(depth, depth_of(part));
      return depth;
    case Part::rule:
      if (!grammar_.contains(expression.text)) throw std::runtime_error("there is no rule " + expression.text);
      return std::min(no_depth, 1 + depths_.at(expression.text));
    case Part::exception:
      return depth_of(expression.parts.front());
    default:
      return 0;
  }
}

void Sentences::find_depths() {
  for (const auto& [name, expression] : grammar_) depths_[name] = no_depth;
  for (bool changed = true; changed;) {
    changed = false;
    for (const auto& [name, expression] : grammar_) {
      const std::size_t depth = depth_of(expression);
      changed = changed || depth != depths_[name];
      depths_[name] = depth;
    }
  }
}

void Sentences::find_keywords(const Expression& expression) {
  for (const Expression& part : expression.parts) find_keywords(part);
  if (expression.kind != Part::terminal || expression.text.size() < 3 || !is_word(expression.text)) return;
  const auto& reserved = grammar_.at("reserved").parts;
  const auto same = [&](const Expression& one) { return one.text == expression.text; };
  // By itself after `expect`, each of these is what scn.ebnf says, and no name.
  const std::string& word = expression.text;
  const bool expected = word == "truth" || word == "never" || word == "finished";
  if (!expected && std::none_of(reserved.begin(), reserved.end(), same)) keywords_.push_back(word);
}

std::string plain_text(const std::vector<std::string>& tokens) {
  std::string text;
  for (std::size_t i = 0; i < tokens.size(); ++i) text += (i == 0 ? "" : i % 12 == 0 ? "\n" : " ") + tokens[i];
  return text;
}

std::string scattered_text(const std::vector<std::string>& tokens, bool comments, Random& random) {
  std::string text;
  std::size_t count = 0;
  const auto scatter = [&] {
    // Without comments also without blank lines, of which one stays.
    const std::uint64_t kinds = comments ? 13 : 5;
    const std::string number = std::to_string(++count);
    switch (below(random, kinds)) {
      case 0:
        return std::string("\n");
      case 2:
        return std::string("\r\n\t");
      case 3:
        return std::string("      ");
      case 5:
        return std::string("\n\n \n");
      case 6:
        return " // " + number + "\n";
      case 7:
        return "\n  // " + number + "  \r\n";
      case 8:
        return "\n\n// " + number + "\n\n";
      case 9:
        return " /* " + number + " */ ";
      case 10:
        return "\n /* " + number + " */\n";
      case 11:
        return "   /* " + number + "\n  \n   more\nand */" + (one_in(random, 2) ? "\n" : "");
      case 12:
        return " /**/ /* " + number + "*/ // \"" + number + "\n";
      default:
        return std::string(" ");
    }
  };
  // Comments in every place are rare in one text, and dense in another.
  const std::uint64_t rarity = std::uint64_t{1} << below(random, 7);
  for (const std::string& token : tokens) {
    text += one_in(random, rarity) ? scatter() : " ";
    if (comments && one_in(random, 2 * rarity)) text += scatter();
    text += token;
  }
  return text + (one_in(random, 2) ? scatter() : "");
}

}  // namespace rmpl::sentences
