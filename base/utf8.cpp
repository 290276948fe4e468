// UTF-8.
// SPDX-License-Identifier: MIT
#include "base/utf8.hpp"

#include <cstdint>
#include <cstring>

namespace rmpl::base {

std::size_t code_points(std::string_view text) {
  // Eight bytes at a time: one bit each for what is no continuation, which has the highest bit and not the next.
  constexpr std::uint64_t ones = 0x0101010101010101;
  std::size_t count = 0;
  std::uint64_t word = 0;
  for (; text.size() >= sizeof word; text.remove_prefix(sizeof word)) {
    std::memcpy(&word, text.data(), sizeof word);
    const std::uint64_t begins = (~word >> 7U | word >> 6U) & ones;
    count += begins * ones >> 56U;
  }
  for (const char c : text) count += is_continuation(c) ? 0 : 1;
  return count;
}

std::size_t code_point_length(std::string_view text) {
  if (text.empty()) return 0;
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char lead = byte(0);
  if (lead < 0x80) return 1;
  // Table 3-7 of the Unicode standard: the second byte's range keeps out overlong forms, surrogates and what is
  // beyond U+10FFFF.
  std::size_t length = 0;
  unsigned char low = 0x80;
  unsigned char high = 0xBF;
  if (lead >= 0xC2 && lead <= 0xDF) {
    length = 2;
  } else if (lead >= 0xE0 && lead <= 0xEF) {
    length = 3;
    if (lead == 0xE0) low = 0xA0;
    if (lead == 0xED) high = 0x9F;
  } else if (lead >= 0xF0 && lead <= 0xF4) {
    length = 4;
    if (lead == 0xF0) low = 0x90;
    if (lead == 0xF4) high = 0x8F;
  }
  if (length == 0 || text.size() < length || byte(1) < low || byte(1) > high) return 0;
  for (std::size_t i = 2; i < length; ++i)
    if (!is_continuation(text[i])) return 0;
  return length;
}

char32_t code_point(std::string_view text) {
  const std::size_t length = code_point_length(text);
  const auto bits = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  if (length < 2) return bits(0);
  char32_t c = bits(0) & (0x7FU >> length);
  for (std::size_t i = 1; i < length; ++i) c = c << 6U | (bits(i) & 0x3FU);
  return c;
}

}  // namespace rmpl::base
