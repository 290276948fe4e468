// Text for XML.
// SPDX-License-Identifier: MIT
#include "base/xml_text.hpp"

#include <algorithm>
#include <cstddef>

#include "base/printable.hpp"
#include "base/utf8.hpp"

namespace rmpl::base {
namespace {

std::string by_number(char byte) {
  constexpr std::string_view digits = "0123456789abcdef";
  const auto number = static_cast<unsigned char>(byte);
  return {'\\', 'x', digits[number / digits.size()], digits[number % digits.size()]};
}

/// The bytes of the character beyond ASCII that the text begins with; 0 where it is none, or none of XML's.
std::size_t wide_character(std::string_view text) {
  const std::size_t size = code_point_length(text);
  const std::string_view character = text.substr(0, size);
  return character == "\xEF\xBF\xBE" || character == "\xEF\xBF\xBF" ? 0 : size;  // U+FFFE and U+FFFF
}

}  // namespace

std::string xml_text(std::string_view text) {
  std::string result;
  while (!text.empty()) {
    const bool ascii = static_cast<unsigned char>(text.front()) < 0x80;
    const std::size_t size =
        ascii ? std::size_t{!is_control(text.front()) || text.front() == '\n'} : wide_character(text);
    result += size == 0 ? by_number(text.front()) : std::string(text.substr(0, size));
    text.remove_prefix(std::max<std::size_t>(size, 1));
  }
  return result;
}

}  // namespace rmpl::base
