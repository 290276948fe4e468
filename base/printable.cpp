// Control characters by their numbers.
// SPDX-License-Identifier: MIT
#include "base/printable.hpp"

namespace rmpl::base {

std::string printable(std::string_view text) {
  constexpr std::string_view digits = "0123456789abcdef";
  constexpr unsigned base = 16;
  std::string result;
  for (const char c : text) {
    if (!is_control(c) || c == '\n') {
      result += c;
      continue;
    }
    const auto byte = static_cast<unsigned char>(c);
    result += "\\x";
    result += digits[byte / base];
    result += digits[byte % base];
  }
  return result;
}

}  // namespace rmpl::base
