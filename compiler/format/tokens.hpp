// A text as its tokens, each with the comments and blank lines before it: what no layout may lose.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace rmpl::compiler {

/// A comment, without the end of its line.
struct Comment {
  std::string_view text;
  std::uint32_t begin = 0;  ///< its byte in the text
  bool to_end_of_line = false;
  bool starts_line = false;  ///< only blanks stand before it on its line
  bool behind_blank_line = false;
};

struct Token {
  std::string_view text;    ///< empty at the end of the text
  std::uint32_t begin = 0;  ///< its byte in the text
  std::uint32_t comments_end = 0;
  bool starts_line = false;        ///< as of a comment; the end of the text does
  bool behind_blank_line = false;  ///< a blank line stands between it and the last comment or token before it
};

/// The tokens of a text, which outlives them. The last one is the end of the text.
class Tokens {
 public:
  explicit Tokens(std::string_view text);

  /// The number of tokens, the end among them.
  [[nodiscard]] std::size_t count() const { return tokens_.size(); }
  [[nodiscard]] const Token& operator[](std::size_t token) const { return tokens_[token]; }
  /// What stands between a token and the one before it.
  [[nodiscard]] std::span<const Comment> comments_before(std::size_t token) const;
  /// Whether a blank line stands between a token and the one before it, comments or not.
  [[nodiscard]] bool is_behind_blank_line(std::size_t token) const;
  /// The first token that begins at this byte or behind it.
  [[nodiscard]] std::size_t at(std::uint32_t byte) const;
  /// Where on its line a byte stands, from 0, in code points.
  [[nodiscard]] std::size_t column(std::uint32_t byte) const;
  /// Whether both are the same tokens with the same comments between them; of comments, blanks at the ends of their
  /// lines do not count.
  [[nodiscard]] bool same(const Tokens& other) const;

 private:
  class Reader;
  std::string_view text_;
  std::vector<Token> tokens_;
  std::vector<Comment> comments_;
};

/// The number of code points of a text.
std::uint32_t width_of(std::string_view text);
/// The text without blanks at its end.
std::string_view without_trailing_blanks(std::string_view text);

}  // namespace rmpl::compiler
