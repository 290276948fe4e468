// Tokens and comments, by the scanner of the parsers.
// SPDX-License-Identifier: MIT
#include "grammar/editor/tokens.hpp"

#include <algorithm>

#include "grammar/parse/scan.hpp"

namespace rmpl::grammar {
namespace {

bool is_blank(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

/// The length of the comment at the start of a text; 0 where there is none.
std::size_t comment_length(std::string_view text) {
  if (text.starts_with("//")) return std::min(text.find('\n'), text.size());
  if (!text.starts_with("/*")) return 0;
  const std::size_t close = text.find("*/", 2);
  return close == std::string_view::npos ? text.size() : close + 2;
}

TokenKind kind_of(std::string_view token) {
  const char* const first = token.data();
  const char* const last = first + token.size();
  if (token.front() == '"') return TokenKind::string;
  if (!identifier_at(first, last).empty()) return TokenKind::word;
  return number_at(first, last).empty() ? TokenKind::symbol : TokenKind::number;
}

}  // namespace

std::vector<TextToken> tokens_of(std::string_view text) {
  std::vector<TextToken> tokens;
  const char* const last = text.data() + text.size();
  for (std::size_t at = 0; at < text.size();) {
    if (is_blank(text[at])) {
      ++at;
      continue;
    }
    TextToken token{TokenKind::comment, static_cast<std::uint32_t>(at), 0};
    std::size_t length = comment_length(text.substr(at));
    if (length == 0) {
      const std::string_view found = token_at(text.data() + at, last);
      length = found.size();
      token.kind = kind_of(found);
    }
    at += length;
    token.end = static_cast<std::uint32_t>(at);
    tokens.push_back(token);
  }
  return tokens;
}

}  // namespace rmpl::grammar
