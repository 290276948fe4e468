// Characters beyond ASCII: what to call them, and how to spell them in a name.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace rmpl::grammar {

/// What a code point beyond ASCII is in a text of the languages.
enum class Foreign {
  letter,  ///< could be part of a name, if names were not of ASCII
  mark,    ///< belongs to the letter before it
  blank,   ///< looks like a blank, or like nothing
  sign
};

/// `c` is beyond ASCII.
Foreign kind_of(char32_t c);

/// A token as messages show it: `name`, or of a code point beyond ASCII what it is and its number: the letter `ö`
/// (U+00F6), a no-break space (U+00A0).
std::string shown(std::string_view token);

/// A word in ASCII letters, as people transcribe it: `Öffner` is `Oeffner`. Nothing where a letter has no spelling.
std::optional<std::string> in_ascii(std::string_view word);

/// The sign of the languages that a typographic one stands for: `->` for an arrow, `-` for a dash. Empty where there is
/// none.
std::string_view sign_for(std::string_view sign);

}  // namespace rmpl::grammar
