// Formulas with a time.
// SPDX-License-Identifier: MIT
#include "tools/tcca-check/timed_formula.hpp"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "tools/shared/options.hpp"

namespace rmpl::tools {
namespace {

constexpr std::string_view spaces = " \t\n";

std::string_view trimmed(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(spaces);
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(spaces) - begin + 1);
}

/// The first word, and what follows it.
std::pair<std::string_view, std::string_view> first_word(std::string_view text) {
  text = trimmed(text);
  const std::size_t end = std::min(text.find_first_of(spaces), text.size());
  return {text.substr(0, end), trimmed(text.substr(end))};
}

/// What precedes the last word, and that.
std::pair<std::string_view, std::string_view> last_word(std::string_view text) {
  text = trimmed(text);
  const std::size_t before = text.find_last_of(spaces);
  if (before == std::string_view::npos) return {{}, text};
  return {trimmed(text.substr(0, before)), text.substr(before + 1)};
}

/// Whether what follows is the rest of an atom: the word before it is a name, whatever else it could be.
bool goes_on_an_atom(std::string_view text) {
  constexpr std::array<std::string_view, 8> operators{"=", "!=", "≠", "<", ">", "≤", "≥", "∈"};
  return first_word(text).first == "in" ||
         std::any_of(operators.begin(), operators.end(), [&](std::string_view one) { return text.starts_with(one); });
}

/// Whether something has to follow: what does is no time.
bool is_open(std::string_view text) {
  constexpr std::array<std::string_view, 14> operators{"=", "≠", "<", ">", "≤", "≥", "&",
                                                       "|", "∧", "∨", "!", "¬", "(", ","};
  const std::string_view word = last_word(text).second;
  return text.empty() || word == "and" || word == "or" || word == "not" ||
         std::any_of(operators.begin(), operators.end(), [&](std::string_view one) { return text.ends_with(one); });
}

/// `T φ`
std::optional<TimedFormula> time_first(std::string_view text) {
  const auto [number, rest] = first_word(text);
  const auto time = automata::parse_duration(number);
  if (!time || goes_on_an_atom(rest)) return std::nullopt;
  const auto [unit, behind] = first_word(rest);
  const auto with_unit = automata::parse_duration(std::string(number) + " " + std::string(unit));
  if (with_unit && !unit.empty() && !goes_on_an_atom(behind)) return TimedFormula{std::string(behind), with_unit};
  return TimedFormula{std::string(rest), time};
}

/// `φ T`
std::optional<TimedFormula> time_last(std::string_view text) {
  const auto [before, word] = last_word(text);
  if (const auto time = automata::parse_duration(word); time && !is_open(before)) {
    return TimedFormula{std::string(before), time};
  }
  const auto [formula, number] = last_word(before);
  const auto time = automata::parse_duration(std::string(number) + " " + std::string(word));
  if (!time || is_open(formula)) return std::nullopt;
  return TimedFormula{std::string(formula), time};
}

TimedFormula either_way(std::string_view text) {
  if (auto found = time_first(text)) return *found;
  if (auto found = time_last(text)) return *found;
  return {std::string(trimmed(text)), std::nullopt};
}

/// Where the word `within` begins; behind the end where it does not stand there.
std::size_t find_within(std::string_view text) {
  constexpr std::string_view keyword = "within";
  for (std::size_t at = text.find(keyword); at != std::string_view::npos; at = text.find(keyword, at + 1)) {
    const std::size_t end = at + keyword.size();
    const bool begins = at == 0 || spaces.find(text[at - 1]) != std::string_view::npos || text[at - 1] == ')';
    const bool ends = end == text.size() || spaces.find(text[end]) != std::string_view::npos;
    if (begins && ends) return at;
  }
  return text.size();
}

constexpr std::size_t keyword_length = 6;

bool is_model(std::string_view text) {
  return text == "-" || text.ends_with(".tcca") || text.ends_with(".rmpl") || text.ends_with(".json") ||
         text.ends_with(".props");
}

/// Whether a word is meant as a time, right or wrong: no name begins so.
bool is_meant_as_time(std::string_view word) {
  return !word.empty() && std::string_view("0123456789.+-").find(word.front()) != std::string_view::npos;
}

/// Throws BadValue where the first or the last word is meant as a time: none was found.
void expect_no_time(std::string_view text) {
  const auto [first, rest] = first_word(text);
  if (is_meant_as_time(first) && !goes_on_an_atom(rest)) static_cast<void>(duration(std::string(first)));
  const auto [before, last] = last_word(text);
  if (is_meant_as_time(last) && !is_open(before)) static_cast<void>(duration(std::string(last)));
}

/// Whether the word may be the formula, or the time, of a `--within` that has just the other one so far.
bool completes(const std::string& so_far, const std::string& word) {
  if (word.empty() || word.starts_with("-") || is_model(word)) return false;
  const TimedFormula known = either_way(so_far);
  if (known.time) return known.formula.empty();
  // Where the time is wrong, that is to be told.
  return is_meant_as_time(so_far) || is_meant_as_time(word) || automata::parse_duration(so_far) ||
         automata::parse_duration(word) || word.find('=') != std::string::npos;
}

}  // namespace

TimedFormula timed_formula(const std::string& text) {
  const std::size_t at = find_within(text);
  if (at == text.size()) {
    TimedFormula result = either_way(text);
    if (!result.time) expect_no_time(text);
    return result;
  }
  const std::string_view before = trimmed(std::string_view(text).substr(0, at));
  const std::string_view after = std::string_view(text).substr(at + keyword_length);
  if (!before.empty()) return {std::string(before), duration(std::string(trimmed(after)))};
  const TimedFormula result = either_way(after);
  if (!result.time) static_cast<void>(duration(std::string(first_word(after).first)));
  return result;
}

TimedResponse timed_response(const std::string& text) {
  const std::size_t at = find_within(text);
  if (at == text.size()) return {text, {}};
  const std::string_view after = std::string_view(text).substr(at + keyword_length);
  TimedFormula then = either_way(after);
  if (!then.time && !then.formula.empty()) static_cast<void>(duration(std::string(first_word(after).first)));
  if (!then.time || then.formula.empty()) {
    throw BadValue("expected a time and a formula after 'within'");
  }
  return {std::string(trimmed(std::string_view(text).substr(0, at))), std::move(then)};
}

std::vector<std::string> with_joined_times(int count, const char* const* arguments) {
  std::vector<std::string> result(arguments, arguments + count);
  for (std::size_t i = 0; i + 2 < result.size(); ++i) {
    if (result[i] == "--") break;
    if (result[i] != "--within" || !completes(result[i + 1], result[i + 2])) continue;
    result[i + 1] += " " + result[i + 2];
    result.erase(result.begin() + static_cast<std::ptrdiff_t>(i) + 2);
  }
  return result;
}

}  // namespace rmpl::tools
