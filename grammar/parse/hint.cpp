// Hints: a table of habits first, then the nearest keyword.
// SPDX-License-Identifier: MIT
#include "grammar/parse/hint.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <vector>

#include "base/nearest.hpp"
#include "grammar/parse/scan.hpp"

namespace rmpl::grammar {
namespace {

std::string did_you_mean(std::string_view word) { return "did you mean `" + std::string(word) + "`?"; }

/// The words between backquotes: the keywords that would have been right.
std::vector<std::string> keywords_in(std::string_view expected) {
  std::vector<std::string> keywords;
  for (std::size_t open = expected.find('`'); open != std::string_view::npos;) {
    const std::size_t close = expected.find('`', open + 1);
    if (close == std::string_view::npos) break;
    std::string word(expected.substr(open + 1, close - open - 1));
    if (identifier_at(word.data(), word.data() + word.size()) == word) keywords.push_back(std::move(word));
    open = expected.find('`', close + 1);
  }
  return keywords;
}

bool is_word(std::string_view text) { return !identifier_at(text.data(), text.data() + text.size()).empty(); }

bool joins_words(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '.' || c == '-';
}

std::string_view without_blank_behind(std::string_view text) {
  while (!text.empty() && std::isspace(static_cast<unsigned char>(text.back())) != 0) text.remove_suffix(1);
  return text;
}

/// The word or number that ends a text, but for blank behind it. (A comment between them hides it: then no hint.)
std::string_view last_word(std::string_view text) {
  text = without_blank_behind(text);
  std::size_t begin = text.size();
  while (begin > 0 && joins_words(text[begin - 1])) --begin;
  return text.substr(begin);
}

struct Spelling {
  std::string_view found;
  std::string_view meant;
};

/// Words of other languages; `meant` counts where it is expected.
constexpr std::array<Spelling, 12> words{{{"then", "thennext"},
                                          {"do", "donext"},
                                          {"do", "thennext"},
                                          {"donext", "thennext"},
                                          {"thennext", "donext"},
                                          {"then", "donext"},
                                          {"if", "when"},
                                          {"in", "within"},
                                          {"until", "watching"},
                                          {"while", "maintaining"},
                                          {"during", "for"},
                                          {"default", "initial"}}};

constexpr std::array<Spelling, 17> units{{{"usec", "us"},
                                          {"microseconds", "us"},
                                          {"msec", "ms"},
                                          {"millis", "ms"},
                                          {"milliseconds", "ms"},
                                          {"sec", "s"},
                                          {"secs", "s"},
                                          {"second", "s"},
                                          {"seconds", "s"},
                                          {"m", "min"},
                                          {"minute", "min"},
                                          {"minutes", "min"},
                                          {"hr", "h"},
                                          {"hour", "h"},
                                          {"hours", "h"},
                                          {"day", "d"},
                                          {"days", "d"}}};

/// A misspelled unit behind a number, or where a unit is needed.
std::optional<std::string> unit_hint(const Unexpected& place) {
  const std::string_view number = last_word(place.before);
  const bool measured = !number.empty() && std::isdigit(static_cast<unsigned char>(number.front())) != 0;
  if (!measured && !place.expected.starts_with("a unit")) return std::nullopt;
  for (const auto& [found, meant] : units) {
    if (found == place.found) return did_you_mean(meant) + " Units of time are us, ms, s, min, h and d";
  }
  return std::nullopt;
}

/// Signs that other languages write otherwise.
std::optional<std::string> sign_hint(const Unexpected& place) {
  const auto after = [&](char c) { return place.before.ends_with(c); };
  if (after('=') && (place.found == "=" || place.found == ">")) {
    return place.found == "=" ? "equality is written with one `=`" : "an arrow is written `->`";
  }
  if (place.found == "=" && place.behind.starts_with(">")) return "an arrow is written `->`";
  if (place.found == ":" && place.behind.starts_with("=")) return "equality is written `=`";
  if (after('&') && place.found == "&") return "`and` is written with one `&`";
  if (after('|') && place.found == "|") return "`or` is written with one `|`";
  if (after('<') && place.found == ">") return "`different` is written `!=`";
  if (place.found == "=" && place.expected.find("`default`") != std::string_view::npos) return did_you_mean("default");
  if (place.found == "%") return "a probability is a number from 0 to 1";
  if (place.expected == "`::`" || (place.expected == "`(`" && place.found == "::")) {
    return "a definition is written `Name() :: { … }`";
  }
  return std::nullopt;
}

/// What stands in the place of a value, a string or a bound.
std::optional<std::string> value_hint(const Unexpected& place) {
  const bool number = std::isdigit(static_cast<unsigned char>(place.found.front())) != 0;
  if (place.expected == "a value" && place.found == "0") return "a clock is started by a step of its own: `t = 0`";
  if (place.expected == "a value" && number) return "a clock is compared with <, <=, > or >=";
  if (place.expected == "a value" && place.found.front() == '"') return "a value is written without quotes";
  if (place.expected == "a duration" && is_word(place.found)) {
    const std::string_view before = without_blank_behind(place.before);
    const bool compared = before.ends_with('<') || before.ends_with('>') || before.ends_with('=');
    if (compared) return "only clocks are compared with <, <=, > and >=";
  }
  if (place.expected.starts_with("a string") && is_word(place.found)) {
    return "write it between quotes: \"" + std::string(place.found) + "\"";
  }
  return std::nullopt;
}

/// Where two words stand side by side, the first may be no name but a keyword misspelled.
std::optional<std::string> word_before_hint(const Unexpected& place) {
  static const std::vector<std::string> keywords = {"if",       "unless", "when",     "whenever", "always", "next",
                                                    "do",       "choose", "observe",  "control",  "input",  "output",
                                                    "internal", "never",  "finished", "import",   "domain", "initial"};
  const std::string_view word = last_word(place.before);
  const bool relation = place.found == "=" || place.found == "!=" || place.found == "<" || place.found == ">" ||
                        place.found == "<=" || place.found == ">=";
  if (relation && is_reserved(word)) return "`" + std::string(word) + "` is a reserved word and cannot be a name";
  const bool names = place.expected.starts_with("`=`, `!=`") || place.expected.starts_with("`:` and");
  if (!names || !is_word(place.found)) return std::nullopt;
  if (word == "while") return "`do … maintaining c` runs while c is entailed, `whenever c donext …` again and again";
  if (word == "eventually") return "`expect c` is met as soon as c holds, `expect c within 5 s` if that is in time";
  if (const auto near = base::nearest(word, keywords)) return did_you_mean(*near);
  if (place.expected.starts_with("`:` and")) {
    return "an instance is written `" + std::string(place.found) + " : " + std::string(word) + "`";
  }
  return std::nullopt;
}

/// A keyword that is misspelled, cut short, or another language's.
std::optional<std::string> keyword_hint(const Unexpected& place) {
  if (!is_word(place.found)) return std::nullopt;
  if (place.found == "else") return "did you mean `elsenext`? It belongs to `if … thennext …`";
  if (place.found == "elseif" || place.found == "elif") return did_you_mean("elsenext if");
  if (place.found == "AND") return did_you_mean("and");
  if (place.found == "OR") return did_you_mean("or");
  const auto keywords = keywords_in(place.expected);
  for (const auto& [found, meant] : words) {
    if (found == place.found && std::find(keywords.begin(), keywords.end(), meant) != keywords.end()) {
      return did_you_mean(meant);
    }
  }
  if (const auto near = base::nearest(place.found, keywords)) return did_you_mean(*near);
  constexpr std::size_t shortest = 3;
  for (const std::string& keyword : keywords) {
    if (place.found.size() >= shortest && keyword.starts_with(place.found)) return did_you_mean(keyword);
  }
  return std::nullopt;
}

}  // namespace

std::optional<std::string> hint(const Unexpected& place) {
  for (const auto& find : {unit_hint, sign_hint, value_hint, word_before_hint, keyword_hint}) {
    if (auto found = find(place)) return found;
  }
  return std::nullopt;
}

}  // namespace rmpl::grammar
