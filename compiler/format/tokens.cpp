// Tokens and what stands between them: one pass over the text.
// SPDX-License-Identifier: MIT
#include "compiler/format/tokens.hpp"

#include <algorithm>

#include "base/utf8.hpp"
#include "grammar/parse/scan.hpp"

namespace rmpl::compiler {
namespace {

constexpr std::string_view blanks = " \t\n\v\f\r";

/// A comment line by line, each line without the blanks around it: what must survive.
bool same_comment(std::string_view one, std::string_view other) {
  while (true) {
    const std::size_t one_end = std::min(one.find('\n'), one.size());
    const std::size_t other_end = std::min(other.find('\n'), other.size());
    const auto bare = [](std::string_view line) {
      line.remove_prefix(std::min(line.find_first_not_of(blanks), line.size()));
      return without_trailing_blanks(line);
    };
    if (bare(one.substr(0, one_end)) != bare(other.substr(0, other_end))) return false;
    if (one_end == one.size() || other_end == other.size()) return one_end == one.size() && other_end == other.size();
    one.remove_prefix(one_end + 1);
    other.remove_prefix(other_end + 1);
  }
}

}  // namespace

class Tokens::Reader {
 public:
  Reader(std::string_view text, Tokens& tokens) : text_(text), tokens_(tokens) {}

  void read() {
    if (text_.starts_with("\xEF\xBB\xBF")) at_ = 3;  // a byte order mark
    for (newlines_ = 1;; newlines_ = 0) {
      skip_blanks();
      if (const std::size_t end = comment_end(); end != at_) {
        take_comment(end);
      } else {
        take_token();
        if (tokens_.tokens_.back().text.empty()) return;
      }
    }
  }

 private:
  /// Behind the comment that starts here; here, where there is none. One that is not closed is none.
  std::size_t comment_end() {
    const std::string_view mark = text_.substr(at_, 2);
    if (mark == "//") return std::min(text_.find('\n', at_), text_.size());
    if (mark != "/*" || at_ >= last_open_) return at_;
    const std::size_t close = text_.find("*/", at_ + 2);
    if (close != std::string_view::npos) return close + 2;
    last_open_ = at_;
    return at_;
  }

  void skip_blanks() {
    for (; at_ < text_.size() && blanks.find(text_[at_]) != std::string_view::npos; ++at_) {
      if (text_[at_] == '\n') ++newlines_;
    }
  }

  void take_comment(std::size_t end) {
    Comment comment;
    comment.text = without_trailing_blanks(text_.substr(at_, end - at_));
    comment.begin = static_cast<std::uint32_t>(at_);
    comment.to_end_of_line = comment.text.starts_with("//");
    comment.starts_line = newlines_ > 0;
    comment.behind_blank_line = newlines_ > 1;
    tokens_.comments_.push_back(comment);
    at_ = end;
  }

  void take_token() {
    Token token;
    token.begin = static_cast<std::uint32_t>(at_);
    token.comments_end = static_cast<std::uint32_t>(tokens_.comments_.size());
    token.starts_line = newlines_ > 0 || at_ == text_.size();
    token.behind_blank_line = newlines_ > 1;
    const char* end = text_.data() + text_.size();
    if (at_ < text_.size()) token.text = grammar::token_at(text_.data() + at_, end);
    at_ += token.text.size();
    tokens_.tokens_.push_back(token);
  }

  std::string_view text_;
  Tokens& tokens_;
  std::size_t at_ = 0;
  std::size_t newlines_ = 0;                        ///< since the last token or comment; the text starts a line
  std::size_t last_open_ = std::string_view::npos;  ///< from here on no comment is closed
};

Tokens::Tokens(std::string_view text) : text_(text) {
  tokens_.reserve(text.size() / 4 + 1);
  Reader(text, *this).read();
}

std::span<const Comment> Tokens::comments_before(std::size_t token) const {
  const std::size_t first = token == 0 ? 0 : tokens_[token - 1].comments_end;
  return std::span(comments_).subspan(first, tokens_[token].comments_end - first);
}

bool Tokens::is_behind_blank_line(std::size_t token) const {
  const auto comments = comments_before(token);
  return tokens_[token].behind_blank_line ||
         std::any_of(comments.begin(), comments.end(), [](const Comment& one) { return one.behind_blank_line; });
}

std::size_t Tokens::at(std::uint32_t byte) const {
  const auto found = std::lower_bound(tokens_.begin(), tokens_.end(), byte,
                                      [](const Token& token, std::uint32_t place) { return token.begin < place; });
  return static_cast<std::size_t>(found - tokens_.begin());
}

std::size_t Tokens::column(std::uint32_t byte) const {
  const std::string_view before = text_.substr(0, byte);
  return width_of(before.substr(before.rfind('\n') + 1));
}

bool Tokens::same(const Tokens& other) const {
  const auto same_token = [](const Token& one, const Token& two) {
    return one.text == two.text && one.comments_end == two.comments_end;
  };
  const auto same_text = [](const Comment& one, const Comment& two) { return same_comment(one.text, two.text); };
  return std::equal(tokens_.begin(), tokens_.end(), other.tokens_.begin(), other.tokens_.end(), same_token) &&
         std::equal(comments_.begin(), comments_.end(), other.comments_.begin(), other.comments_.end(), same_text);
}

std::uint32_t width_of(std::string_view text) { return static_cast<std::uint32_t>(base::code_points(text)); }

std::string_view without_trailing_blanks(std::string_view text) {
  const std::size_t last = text.find_last_not_of(blanks);
  return text.substr(0, last == std::string_view::npos ? 0 : last + 1);
}

}  // namespace rmpl::compiler
