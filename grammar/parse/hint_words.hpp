// What the hints share: words before a place, and how to say what was meant.
// SPDX-License-Identifier: MIT
#pragma once

#include <cctype>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "grammar/parse/hint.hpp"

namespace rmpl::grammar {

struct Spelling {
  std::string_view found;
  std::string_view meant;
};

/// A habit that no replacement of one stretch of text puts right.
inline Hint say(std::string suggestion) { return {std::move(suggestion), {}, {}}; }

inline Hint did_you_mean(std::string_view word, std::string_view replaced) {
  return {"did you mean `" + std::string(word) + "`?", replaced, std::string(word)};
}

inline bool joins_words(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '.' || c == '-';
}

inline std::string_view without_blank_behind(std::string_view text) {
  while (!text.empty() && std::isspace(static_cast<unsigned char>(text.back())) != 0) text.remove_suffix(1);
  return text;
}

/// The word or number that ends a text, but for blank behind it. (A comment between them hides it: then no hint.)
inline std::string_view last_word(std::string_view text) {
  text = without_blank_behind(text);
  std::size_t begin = text.size();
  while (begin > 0 && joins_words(text[begin - 1])) --begin;
  return text.substr(begin);
}

/// All from the first to the last of two parts of one text.
inline std::string_view joined(std::string_view first, std::string_view last) {
  return {first.data(), static_cast<std::size_t>(last.data() + last.size() - first.data())};
}

/// Letters, blanks and signs beyond ASCII.
std::optional<Hint> foreign_hint(const Unexpected& place);
/// Times as clocks show them, `5min30s` and `00:05:00`; and rates that do not say per what.
std::optional<Hint> time_hint(const Unexpected& place);
/// A misspelled unit behind a number, or where a unit is needed.
std::optional<Hint> unit_hint(const Unexpected& place);

}  // namespace rmpl::grammar
