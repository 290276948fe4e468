// Control characters by their numbers.
// SPDX-License-Identifier: MIT
#include "base/printable.hpp"

#include <algorithm>

#include "base/utf8.hpp"

namespace rmpl::base {
namespace {

std::string escape(char kind, char32_t number, std::size_t digits) {
  constexpr std::string_view hexadecimal = "0123456789abcdef";
  std::string text(digits + 2, '0');
  text[0] = '\\';
  text[1] = kind;
  for (std::size_t i = text.size(); number != 0; number >>= 4U) text[--i] = hexadecimal[number & 0xFU];
  return text;
}

/// The length of a colour of `Painter` at the start of the text; 0 where there is none.
std::size_t colour_length(std::string_view text) {
  if (!text.starts_with("\x1b[")) return 0;
  const std::size_t end = text.find_first_not_of("0123456789;", 2);
  return end != std::string_view::npos && text[end] == 'm' ? end + 1 : 0;
}

/// Nothing steers in most texts: then they are copied as they are. Block by block, with no branch within one, so that
/// many bytes are looked at together.
bool is_harmless(std::string_view text) {
  constexpr std::size_t block = 64;
  const auto suspects = [&text](std::size_t count) {
    unsigned char any = 0;
    for (std::size_t i = 0; i < count; ++i) {
      const auto byte = static_cast<unsigned char>(text[i]);
      any = static_cast<unsigned char>(any | (text[i] != '\n' && (is_control(text[i]) || byte >= 0x80)));
    }
    return any != 0;
  };
  for (; text.size() >= block; text.remove_prefix(block)) {
    if (suspects(block)) return false;
  }
  return !suspects(text.size());
}

std::string escaped(std::string_view text, bool tabs_stay) {
  if (is_harmless(text)) return std::string(text);
  std::string result;
  result.reserve(text.size());
  while (!text.empty()) {
    const std::size_t length = code_point_length(text);
    const char32_t c = code_point(text);
    if (length == 0 || (length == 1 && steers(c) && c != '\n' && (c != '\t' || !tabs_stay))) {
      result += escape('x', c, 2);
    } else if (length > 1 && steers(c)) {
      result += escape('u', c, 4);
    } else {
      result += text.substr(0, length);
    }
    text.remove_prefix(std::max<std::size_t>(1, length));
  }
  return result;
}

}  // namespace

std::string printable(std::string_view text) { return escaped(text, false); }

std::string printable_in_colour(std::string_view text) {
  std::string result;
  while (true) {
    std::size_t colour = text.find('\x1b');
    while (colour != std::string_view::npos && colour_length(text.substr(colour)) == 0) {
      colour = text.find('\x1b', colour + 1);
    }
    result += escaped(text.substr(0, colour), true);
    if (colour == std::string_view::npos) return result;
    const std::size_t length = colour_length(text.substr(colour));
    result += text.substr(colour, length);
    text.remove_prefix(colour + length);
  }
}

std::string printable_json(std::string_view document) {
  if (is_harmless(document)) return std::string(document);
  std::string result;
  result.reserve(document.size());
  while (!document.empty()) {
    const std::size_t length = std::max<std::size_t>(1, code_point_length(document));
    const char32_t c = code_point(document);
    const bool escaped = steers(c) && c != '\n' && c != '\t' && c != '\r';
    result += escaped ? escape('u', c, 4) : std::string(document.substr(0, length));
    document.remove_prefix(length);
  }
  return result;
}

}  // namespace rmpl::base
