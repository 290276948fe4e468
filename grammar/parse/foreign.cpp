// Tables of letters, blanks and signs; by the blocks of the Unicode standard.
// SPDX-License-Identifier: MIT
#include "grammar/parse/foreign.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "base/utf8.hpp"
#include "grammar/parse/scan.hpp"

namespace rmpl::grammar {
namespace {

/// Letters and their spellings: Latin, Greek, and Cyrillic by its sound.
constexpr std::string_view spellings =
    " À:A Á:A Â:A Ã:A Ä:Ae Å:Aa Æ:Ae Ç:C È:E É:E Ê:E Ë:E Ì:I Í:I Î:I Ï:I Ð:D Ñ:N Ò:O Ó:O Ô:O Õ:O Ö:Oe Ø:Oe "
    "Ù:U Ú:U Û:U Ü:Ue Ý:Y Þ:Th ß:ss à:a á:a â:a ã:a ä:ae å:aa æ:ae ç:c è:e é:e ê:e ë:e ì:i í:i î:i ï:i ð:d "
    "ñ:n ò:o ó:o ô:o õ:o ö:oe ø:oe ù:u ú:u û:u ü:ue ý:y þ:th ÿ:y Ā:A ā:a Ă:A ă:a Ą:A ą:a Ć:C ć:c Ĉ:C ĉ:c Ċ:C "
    "ċ:c Č:C č:c Ď:D ď:d Đ:D đ:d Ē:E ē:e Ĕ:E ĕ:e Ė:E ė:e Ę:E ę:e Ě:E ě:e Ĝ:G ĝ:g Ğ:G ğ:g Ġ:G ġ:g Ģ:G ģ:g Ĥ:H "
    "ĥ:h Ħ:H ħ:h Ĩ:I ĩ:i Ī:I ī:i Ĭ:I ĭ:i Į:I į:i İ:I ı:i Ĳ:IJ ĳ:ij Ĵ:J ĵ:j Ķ:K ķ:k ĸ:k Ĺ:L ĺ:l Ļ:L ļ:l Ľ:L "
    "ľ:l Ł:L ł:l Ń:N ń:n Ņ:N ņ:n Ň:N ň:n ŉ:n Ŋ:Ng ŋ:ng Ō:O ō:o Ŏ:O ŏ:o Ő:O ő:o Œ:Oe œ:oe Ŕ:R ŕ:r Ŗ:R ŗ:r Ř:R "
    "ř:r Ś:S ś:s Ŝ:S ŝ:s Ş:S ş:s Š:S š:s Ţ:T ţ:t Ť:T ť:t Ŧ:T ŧ:t Ũ:U ũ:u Ū:U ū:u Ŭ:U ŭ:u Ů:U ů:u Ű:U ű:u Ų:U "
    "ų:u Ŵ:W ŵ:w Ŷ:Y ŷ:y Ÿ:Y Ź:Z ź:z Ż:Z ż:z Ž:Z ž:z ſ:s ª:a º:o µ:u Ș:S ș:s Ț:T ț:t Ǎ:A ǎ:a Ǐ:I ǐ:i Ǒ:O ǒ:o "
    "Ǔ:U ǔ:u Ǖ:U ǖ:u Ǘ:U ǘ:u Ǚ:U ǚ:u Ǜ:U ǜ:u ẞ:SS α:alpha Α:Alpha β:beta Β:Beta γ:gamma Γ:Gamma δ:delta "
    "Δ:Delta ε:epsilon Ε:Epsilon ζ:zeta Ζ:Zeta η:eta Η:Eta θ:theta Θ:Theta ι:iota Ι:Iota κ:kappa Κ:Kappa "
    "λ:lambda Λ:Lambda μ:mu Μ:Mu ν:nu Ν:Nu ξ:xi Ξ:Xi ο:omicron Ο:Omicron π:pi Π:Pi ρ:rho Ρ:Rho σ:sigma "
    "Σ:Sigma τ:tau Τ:Tau υ:upsilon Υ:Upsilon φ:phi Φ:Phi χ:chi Χ:Chi ψ:psi Ψ:Psi ω:omega Ω:Ohm ς:sigma "
    "ά:alpha έ:epsilon ή:eta ί:iota ό:omicron ύ:upsilon ώ:omega ϕ:phi ϑ:theta ϵ:epsilon а:a А:A б:b Б:B в:v "
    "В:V г:g Г:G д:d Д:D е:e Е:E ё:yo Ё:Yo ж:zh Ж:Zh з:z З:Z и:i И:I й:y Й:Y к:k К:K л:l Л:L м:m М:M н:n Н:N "
    "о:o О:O п:p П:P р:r Р:R с:s С:S т:t Т:T у:u У:U ф:f Ф:F х:kh Х:Kh ц:ts Ц:Ts ч:ch Ч:Ch ш:sh Ш:Sh щ:shch "
    "Щ:Shch ы:y Ы:Y э:e Э:E ю:yu Ю:Yu я:ya Я:Ya і:i І:I ї:yi Ї:Yi є:ye Є:Ye ґ:g Ґ:G ";

struct Range {
  char32_t first, last;
};

constexpr bool within(const auto& ranges, char32_t c) {
  return std::any_of(ranges.begin(), ranges.end(), [&](Range r) { return r.first <= c && c <= r.last; });
}

constexpr std::array<Range, 11> blanks{{{0x85, 0x85},
                                        {0xA0, 0xA0},
                                        {0xAD, 0xAD},
                                        {0x1680, 0x1680},
                                        {0x180E, 0x180E},
                                        {0x2000, 0x200F},
                                        {0x2028, 0x202F},
                                        {0x205F, 0x2069},
                                        {0x3000, 0x3000},
                                        {0xFEFF, 0xFEFF},
                                        {0xE0000, 0xE007F}}};
constexpr std::array<Range, 5> marks{
    {{0x300, 0x36F}, {0x1AB0, 0x1AFF}, {0x1DC0, 0x1DFF}, {0x20D0, 0x20FF}, {0xFE00, 0xFE2F}}};
/// What is no letter beyond ASCII: punctuation, arrows, operators, symbols, private use, emoji.
constexpr std::array<Range, 11> signs{{{0x80, 0xA9},
                                       {0xAB, 0xB4},
                                       {0xB6, 0xB9},
                                       {0xBB, 0xBF},
                                       {0xD7, 0xD7},
                                       {0xF7, 0xF7},
                                       {0x2010, 0x2BFF},
                                       {0x3001, 0x303F},
                                       {0xD800, 0xF8FF},
                                       {0xFF00, 0xFFEF},
                                       {0x1F000, 0x1FBFF}}};

constexpr std::array<std::pair<char32_t, std::string_view>, 9> blank_names{{{0xA0, "a no-break space"},
                                                                            {0xAD, "a soft hyphen"},
                                                                            {0x2007, "a figure space"},
                                                                            {0x2009, "a thin space"},
                                                                            {0x200B, "a zero-width space"},
                                                                            {0x200D, "a zero-width joiner"},
                                                                            {0x202F, "a narrow no-break space"},
                                                                            {0x3000, "an ideographic space"},
                                                                            {0xFEFF, "a byte order mark"}}};

/// Typographic signs that editors and word processors put in.
constexpr std::string_view signs_meant =
    " –:- —:- −:- ‐:- ‑:- →:-> ⟶:-> ⇨:-> ↔:<-> “:\" ”:\" „:\" ‟:\" «:\" »:\" ＝:= ：:: ；:; ，:, （:( ）:) ｛:{ ｝:} "
    "≥:>= "
    "≦:<= ≧:>= ⩽:<= ⩾:>= ＆:& ｜:| ！:! ";

/// `U+00F6`.
std::string number_of(char32_t c) {
  constexpr std::string_view digits = "0123456789ABCDEF";
  std::string text = "U+";
  const unsigned first = c > 0xFFFF ? 20 : 12;
  for (unsigned shift = first; shift < 32; shift -= 4) text += digits[c >> shift & 0xFU];
  return text;
}

std::string_view looked_up(std::string_view table, std::string_view key) {
  const std::string entry = " " + std::string(key) + ":";
  const std::size_t at = table.find(entry);
  if (at == std::string_view::npos) return {};
  const std::size_t begin = at + entry.size();
  return table.substr(begin, table.find(' ', begin) - begin);
}

}  // namespace

Foreign kind_of(char32_t c) {
  if (within(blanks, c)) return Foreign::blank;
  if (within(marks, c)) return Foreign::mark;
  return within(signs, c) ? Foreign::sign : Foreign::letter;
}

std::string shown(std::string_view token) {
  const auto quoted = [&] { return "`" + std::string(token) + "`"; };
  if (token.empty() || static_cast<unsigned char>(token.front()) < 0x80) return quoted();
  if (operator_at(token.data(), token.data() + token.size()) == token) return quoted();
  const char32_t c = base::code_point(token);
  const std::string number = number_of(c);
  switch (kind_of(c)) {
    case Foreign::letter:
      return "the letter " + quoted() + " (" + number + ")";
    case Foreign::mark:
      return "a combining mark (" + number + ")";
    case Foreign::blank: {
      const auto* known =
          std::find_if(blank_names.begin(), blank_names.end(), [&](const auto& n) { return n.first == c; });
      return std::string(known == blank_names.end() ? "an invisible character" : known->second) + " (" + number + ")";
    }
    case Foreign::sign:
      return quoted() + " (" + number + ")";
  }
  return quoted();
}

std::optional<std::string> in_ascii(std::string_view word) {
  constexpr char32_t diaeresis = 0x308;
  std::string spelled;
  while (!word.empty()) {
    const std::size_t length = std::max<std::size_t>(1, base::code_point_length(word));
    const std::string_view letter = word.substr(0, length);
    word.remove_prefix(length);
    if (length == 1) {
      spelled += letter;
      continue;
    }
    const char32_t c = base::code_point(letter);
    if (kind_of(c) == Foreign::mark) {
      const bool umlaut = c == diaeresis && !spelled.empty() &&
                          std::string_view("aouAOU").find(spelled.back()) != std::string_view::npos;
      if (umlaut) spelled += 'e';
      continue;
    }
    if (c == 0x42A || c == 0x42C || c == 0x44A || c == 0x44C) continue;  // the hard and the soft sign
    const std::string_view spelling = looked_up(spellings, letter);
    if (spelling.empty()) return std::nullopt;
    spelled += spelling;
  }
  return spelled;
}

std::string_view sign_for(std::string_view sign) { return looked_up(signs_meant, sign); }

}  // namespace rmpl::grammar
