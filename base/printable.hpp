// Text from outside on a terminal: a name must not move the cursor, colour what follows, or turn it round.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace rmpl::base {

/// Whether a byte is a control character of ASCII: below the blank, or delete.
constexpr bool is_control(char byte) { return static_cast<unsigned char>(byte) < 0x20 || byte == 0x7f; }

/// Whether a code point steers a terminal or the direction of a text: the control characters of ASCII and Latin-1
/// (ECMA-48, C0 and C1), and the overrides, embeddings and isolates of the bidirectional algorithm (UAX #9).
constexpr bool steers(char32_t c) {
  return c < 0x20 || (c >= 0x7F && c <= 0x9F) || (c >= 0x202A && c <= 0x202E) || (c >= 0x2066 && c <= 0x2069);
}

/// The text with everything that steers but the end of a line as an escape: a byte as `\x1b`, a code point as `\u202e`.
/// Bytes that are no UTF-8 are escaped, too. What is ASCII stays ASCII.
std::string printable(std::string_view text);

/// The same for a whole text with tabs and colours of `Painter`, which stay.
std::string printable_in_colour(std::string_view text);

/// The same for a JSON document: an escape within a string leaves its value what it is.
std::string printable_json(std::string_view document);

}  // namespace rmpl::base
