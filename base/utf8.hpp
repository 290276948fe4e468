// UTF-8, character by character (RFC 3629).
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string_view>

namespace rmpl::base {

/// Whether the byte goes on a code point that begins before it.
inline bool is_continuation(char c) { return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U; }

/// How many code points begin in the text.
std::size_t code_points(std::string_view text);

/// The length in bytes, 1 to 4, of the well-formed code point at the start of `text` (no overlong forms, no
/// surrogates); 0 where there is none.
std::size_t code_point_length(std::string_view text);

/// The code point at the start of a text that is not empty; its first byte where it is not well-formed.
char32_t code_point(std::string_view text);

}  // namespace rmpl::base
