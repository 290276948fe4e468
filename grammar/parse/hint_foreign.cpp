// Hints about characters beyond ASCII: letters in names, blanks that look like blanks, typographic signs.
// SPDX-License-Identifier: MIT
#include "base/utf8.hpp"
#include "grammar/parse/foreign.hpp"
#include "grammar/parse/hint_words.hpp"

namespace rmpl::grammar {
namespace {

bool is_ascii(char c) { return static_cast<unsigned char>(c) < 0x80; }

/// The length of what belongs to a word at the start of a text: a character of a name, or a letter or mark.
std::size_t part_of_word(std::string_view text) {
  if (text.empty()) return 0;
  if (is_ascii(text.front())) return joins_words(text.front()) ? 1 : 0;
  const Foreign kind = kind_of(base::code_point(text));
  return kind == Foreign::letter || kind == Foreign::mark ? base::code_point_length(text) : 0;
}

/// The whole word around the token: what was meant as a name.
std::string_view word_around(const Unexpected& place) {
  std::size_t before = place.before.size();
  while (before > 0 && joins_words(place.before[before - 1])) --before;
  std::size_t behind = 0;
  while (const std::size_t length = part_of_word(place.behind.substr(behind))) behind += length;
  return joined(place.before.substr(before), std::string_view(place.found.data(), place.found.size() + behind));
}

Hint letter_hint(const Unexpected& place) {
  constexpr std::string_view rule = "names are of ASCII letters, digits and `_`";
  const std::string_view word = word_around(place);
  const auto spelling = in_ascii(word);
  if (!spelling) return say(std::string(rule));
  return {std::string(rule) + ": `" + *spelling + "`", word, *spelling};
}

}  // namespace

std::optional<Hint> foreign_hint(const Unexpected& place) {
  if (is_ascii(place.found.front())) return std::nullopt;
  switch (kind_of(base::code_point(place.found))) {
    case Foreign::letter:
    case Foreign::mark:
      return letter_hint(place);
    case Foreign::blank:
      return Hint{"write a blank in its place", place.found, " "};
    case Foreign::sign: {
      const std::string_view meant = sign_for(place.found);
      if (meant.empty()) return std::nullopt;
      return did_you_mean(meant, place.found);
    }
  }
  return std::nullopt;
}

}  // namespace rmpl::grammar
