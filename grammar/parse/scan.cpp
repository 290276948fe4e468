// Tokens in plain characters. Written by hand below the rules: one pass, no allocation until a token is kept.
// SPDX-License-Identifier: MIT
#include "grammar/parse/scan.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <system_error>

#include "base/printable.hpp"
#include "base/utf8.hpp"

namespace rmpl::grammar {
namespace {

constexpr std::array<std::string_view, 22> reserved_words = {
    "do",   "watching", "maintaining", "if", "thennext", "elsenext", "unless", "when",  "donext", "whenever", "always",
    "next", "choose",   "with",        "in", "import",   "any",      "true",   "false", "and",    "or",       "not"};
constexpr std::array<std::string_view, 10> units = {"ns", "us", "ms", "s", "min", "mins", "h", "d", "w", "weeks"};

// Longest first where one is the start of another.
constexpr std::array<std::string_view, 33> operators = {"<->", "->", "<=", ">=", "!=", "::", "<", ">", "!", "=", "&",
                                                        "|",   ",",  ";",  ":",  "{",  "}",  "(", ")", "[", "]", "~",
                                                        "/",   "¬",  "∧",  "∨",  "⇒",  "⇔",  "≠", "≤", "≥", "∞", "-"};

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
bool is_digit(char c) { return c >= '0' && c <= '9'; }

std::string_view view(const char* first, const char* last) { return {first, static_cast<std::size_t>(last - first)}; }

bool contains(auto const& words, std::string_view word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

const char* skip_digits(const char* at, const char* last) {
  while (at != last && is_digit(*at)) ++at;
  return at;
}

/// Takes the token `text` that starts at `at`.
template <class Token>
void take(const char*& first, const ParseState& state, const char* at, std::string_view text, Token& token) {
  first = at + text.size();
  token.span = state.span(at, first);
  token.text = text;
}

bool take_number(const char*& first, ParseState& state, bool sign, Number& number) {
  const char* at = skip_blank(first, state.end());
  const char* digits = at;
  if (sign && at != state.end() && (*at == '-' || *at == '+')) digits = skip_blank(at + 1, state.end());
  std::string_view decimal = number_at(digits, state.end());
  if (decimal.empty()) return false;
  first = decimal.data() + decimal.size();
  number.span = state.span(at, first);
  number.text = (*at == '-' ? "-" : "") + std::string(decimal);
  const auto [_, failure] = std::from_chars(decimal.data(), first, number.value);
  if (failure == std::errc::result_out_of_range) {
    // A number too small for a double is as good as 0; one too large is an error.
    const std::size_t exponent = decimal.find_first_of("eE");
    const bool tiny = exponent == std::string_view::npos ? decimal.starts_with("0.") : decimal[exponent + 1] == '-';
    number.value = 0;
    if (!tiny)
      state.diagnostics().error(Code::number_out_of_range, number.span, "number out of range: at most 1.8e308");
  }
  if (*at == '-') number.value = -number.value;
  return true;
}

}  // namespace

bool is_space(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

const char* skip_blank(const char* first, const char* last) {
  while (first != last) {
    if (is_space(*first)) {
      ++first;
    } else if (*first == '/' && last - first > 1 && first[1] == '/') {
      first = std::find(first, last, '\n');
    } else if (*first == '/' && last - first > 1 && first[1] == '*') {
      const std::string_view rest = view(first, last);
      const std::size_t close = rest.find("*/", 2);
      if (close == std::string_view::npos) return first;
      first += close + 2;
    } else {
      return first;
    }
  }
  return first;
}

std::string_view identifier_at(const char* first, const char* last) {
  const char* at = first;
  if (at == last || !(is_letter(*at) || *at == '_')) return {};
  for (++at; at != last; ++at) {
    if (is_letter(*at) || is_digit(*at) || *at == '_') continue;
    const bool joins = (*at == '-' || *at == '.') && last - at > 1 && (is_letter(at[1]) || is_digit(at[1]));
    if (!joins) break;
  }
  return view(first, at);
}

bool is_reserved(std::string_view word) { return contains(reserved_words, word); }

std::string_view operator_at(const char* first, const char* last) {
  const std::string_view rest = view(first, last);
  const auto* found = std::find_if(operators.begin(), operators.end(), [&](auto op) { return rest.starts_with(op); });
  return found == operators.end() ? std::string_view() : rest.substr(0, found->size());
}

std::string_view number_at(const char* first, const char* last) {
  const char* at = skip_digits(first, last);
  if (at == first) return {};
  if (last - at > 1 && *at == '.' && is_digit(at[1])) at = skip_digits(at + 1, last);
  if (at != last && (*at == 'e' || *at == 'E')) {
    const char* exponent = at + 1;
    if (exponent != last && (*exponent == '+' || *exponent == '-')) ++exponent;
    if (exponent != last && is_digit(*exponent)) at = skip_digits(exponent, last);
  }
  return view(first, at);
}

std::string_view token_at(const char* first, const char* last) {
  if (const auto word = identifier_at(first, last); !word.empty()) return word;
  if (const auto number = number_at(first, last); !number.empty()) return number;
  if (*first == '"') {
    const char* at = first + 1;
    while (at != last && *at != '"' && *at != '\n') at += (*at == '\\' && last - at > 1) ? 2 : 1;
    return view(first, at == last || *at == '\n' ? at : at + 1);
  }
  if (const auto symbol = operator_at(first, last); !symbol.empty()) return symbol;
  return view(first, first + std::max<std::size_t>(1, base::code_point_length(view(first, last))));
}

bool scan_name(const char*& first, ParseState& state, Name& name) {
  const char* at = skip_blank(first, state.end());
  const std::string_view word = identifier_at(at, state.end());
  if (word.empty() || is_reserved(word)) return false;
  take(first, state, at, word, name);
  return true;
}

bool scan_value(const char*& first, ParseState& state, Name& value) {
  const char* at = skip_blank(first, state.end());
  const std::string_view word = identifier_at(at, state.end());
  if (word.empty() || (is_reserved(word) && word != "true" && word != "false")) return false;
  take(first, state, at, word, value);
  return true;
}

bool scan_unit(const char*& first, ParseState& state, Name& unit) {
  const char* at = skip_blank(first, state.end());
  const std::string_view word = identifier_at(at, state.end());
  if (!contains(units, word)) return false;
  take(first, state, at, word, unit);
  return true;
}

bool scan_number(const char*& first, ParseState& state, Number& number) {
  return take_number(first, state, false, number);
}

bool scan_signed_number(const char*& first, ParseState& state, Number& number) {
  return take_number(first, state, true, number);
}

bool scan_whole_number(const char*& first, ParseState& state, std::uint64_t& number) {
  const char* at = skip_blank(first, state.end());
  const char* behind = skip_digits(at, state.end());
  // `0.5` and `1e3` are numbers, but not whole ones.
  if (behind == at || number_at(at, state.end()).size() != static_cast<std::size_t>(behind - at)) return false;
  if (std::from_chars(at, behind, number).ec != std::errc()) {
    state.diagnostics().error(Code::number_out_of_range, state.span(at, behind),
                              "number out of range: a whole number below 2^64 was expected");
  }
  first = behind;
  return true;
}

bool scan_duration(const char*& first, ParseState& state, Duration& duration) {
  const char* at = skip_blank(first, state.end());
  const std::string_view decimal = number_at(at, state.end());
  if (decimal.empty()) return false;
  first = at + decimal.size();
  duration.number = decimal;
  Name unit;
  scan_unit(first, state, unit);
  duration.unit = std::move(unit.text);
  duration.infinite = false;
  duration.span = state.span(at, first);
  return true;
}

bool scan_bound(const char*& first, ParseState& state, Duration& bound) {
  const char* at = skip_blank(first, state.end());
  const char* behind = at;
  if (!scan_word(behind, state, "inf") && !scan_operator(behind, state, "∞")) return scan_duration(first, state, bound);
  first = behind;
  bound = Duration{state.span(at, first), "", "", true};
  return true;
}

bool scan_string(const char*& first, ParseState& state, String& string) {
  const char* at = skip_blank(first, state.end());
  if (at == state.end() || *at != '"') return false;
  const std::string_view token = token_at(at, state.end());
  if (token.size() < 2 || token.back() != '"' || std::any_of(token.begin(), token.end(), base::is_control))
    return false;
  string.text.clear();
  for (std::size_t i = 1; i + 1 < token.size(); ++i) {
    if (token[i] == '\\' && (token[i + 1] == '"' || token[i + 1] == '\\')) ++i;
    string.text.push_back(token[i]);
  }
  first = at + token.size();
  string.span = state.span(at, first);
  return true;
}

bool scan_zero(const char*& first, ParseState& state) {
  const char* at = skip_blank(first, state.end());
  if (number_at(at, state.end()) != "0") return false;
  first = at + 1;
  return true;
}

bool scan_word(const char*& first, ParseState& state, std::string_view word) {
  const char* at = skip_blank(first, state.end());
  if (!view(at, state.end()).starts_with(word) || identifier_at(at, state.end()) != word) return false;
  first = at + word.size();
  return true;
}

bool scan_operator(const char*& first, ParseState& state, std::string_view symbol) {
  const char* at = skip_blank(first, state.end());
  if (!view(at, state.end()).starts_with(symbol) || operator_at(at, state.end()) != symbol) return false;
  first = at + symbol.size();
  return true;
}

bool scan_end(const char*& first, ParseState& state) {
  const char* at = skip_blank(first, state.end());
  if (at != state.end()) return false;
  first = at;
  return true;
}

}  // namespace rmpl::grammar
