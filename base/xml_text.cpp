// UTF-8, character by character (RFC 3629).
// SPDX-License-Identifier: MIT
#include "base/xml_text.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "base/printable.hpp"

namespace rmpl::base {
namespace {

std::string by_number(char byte) {
  constexpr std::string_view digits = "0123456789abcdef";
  const auto number = static_cast<unsigned char>(byte);
  return {'\\', 'x', digits[number / digits.size()], digits[number % digits.size()]};
}

/// The bytes of the character beyond ASCII that the text begins with; 0 where it is none, or none of XML's.
std::size_t wide_character(std::string_view text) {
  struct Form {
    unsigned char first, last;  ///< of the leading byte
    std::size_t size;
    std::uint32_t least;  ///< what is less is written shorter
  };
  constexpr std::array<Form, 3> forms{{{0xc2, 0xdf, 2, 0x80}, {0xe0, 0xef, 3, 0x800}, {0xf0, 0xf4, 4, 0x10000}}};
  constexpr std::uint32_t greatest = 0x10ffff, surrogates = 0xd800, after_surrogates = 0xe000, none = 0xfffe;
  const auto lead = static_cast<unsigned char>(text.front());
  const auto form = std::ranges::find_if(forms, [&](const Form& f) { return f.first <= lead && lead <= f.last; });
  if (form == forms.end() || text.size() < form->size) return 0;
  std::uint32_t character = lead & (0xffu >> (form->size + 1));
  for (const char c : text.substr(1, form->size - 1)) {
    const auto byte = static_cast<unsigned char>(c);
    if ((byte & 0xc0u) != 0x80u) return 0;
    character = character << 6 | (byte & 0x3fu);
  }
  const bool surrogate = surrogates <= character && character < after_surrogates;
  const bool excluded = surrogate || character == none || character == none + 1;
  return form->least <= character && character <= greatest && !excluded ? form->size : 0;
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
