// A text as tokens, comments too: for what looks at a text without understanding it.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

namespace rmpl::grammar {

enum class TokenKind { word, number, string, symbol, comment };

struct TextToken {
  TokenKind kind = TokenKind::symbol;
  std::uint32_t begin = 0;
  std::uint32_t end = 0;
  [[nodiscard]] std::string_view in(std::string_view text) const { return text.substr(begin, end - begin); }
};

/// The tokens of any text in order, with nothing but white space between them; a comment or string that is not closed
/// goes to the end of the text, or of the line. Linear.
std::vector<TextToken> tokens_of(std::string_view text);

}  // namespace rmpl::grammar
