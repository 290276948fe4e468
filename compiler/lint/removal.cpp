// Statements as tokens, and what stands around them.
// SPDX-License-Identifier: MIT
#include "compiler/lint/removal.hpp"

#include <algorithm>
#include <utility>

namespace rmpl::compiler {

using grammar::Edit;
using grammar::Span;

namespace {

std::uint32_t end_of(const Token& token) { return token.begin + static_cast<std::uint32_t>(token.text.size()); }

bool ends_statement(std::string_view token) { return token == ";" || token == "{" || token == "}"; }

/// A statement, and how far a removal of it reaches.
class Statement {
 public:
  Statement(const Tokens& tokens, std::string_view text, std::size_t part)
      : tokens_(tokens), text_(text), first_(part), last_(part) {
    while (first_ > 0 && !ends_statement(tokens_[first_ - 1].text)) --first_;
    while (last_ + 1 < tokens_.count() && tokens_[last_].text != ";") ++last_;
  }

  /// Whether no comment stands within, right above or right behind but such as go with the statement.
  bool is_uncommented() { return tokens_[last_].text == ";" && settle_comments(); }

  std::vector<Edit> removal(std::uint32_t file) {
    if (!is_uncommented()) return {};
    const bool alone = tokens_[first_].starts_line && tokens_[last_ + 1].starts_line && !next_on_line_;
    if (!alone && tokens_[first_].starts_line) return {{{file, tokens_[first_].begin, behind()}, ""}};
    if (!alone) return {{{file, end_of(tokens_[first_ - 1]), end_of(tokens_[last_])}, ""}};
    take_lines();
    return {{{file, begin_, end_}, ""}};
  }

 private:
  /// Finds the allowances that go with the statement. Whether there are no other comments.
  bool settle_comments() {
    for (std::size_t t = first_ + 1; t <= last_; ++t) {
      if (!tokens_.comments_before(t).empty()) return false;
    }
    begin_ = tokens_[first_].begin;
    const auto before = tokens_.comments_before(first_);
    above_blank_ = tokens_[first_].behind_blank_line;
    for (std::size_t c = before.size(); c-- > 0 && !above_blank_;) {
      if (!before[c].starts_line && first_ > 0) break;  // behind the statement before
      if (!speaks_to_lint(before[c].text) || !before[c].starts_line) return false;
      begin_ = before[c].begin;
      above_blank_ = before[c].behind_blank_line;
    }
    // One that stands before the statement on its own line.
    if (!tokens_[first_].starts_line && !before.empty()) return false;
    end_ = end_of(tokens_[last_]);
    for (const Comment& comment : tokens_.comments_before(last_ + 1)) {
      if (comment.starts_line) break;
      if (!speaks_to_lint(comment.text)) return false;
      end_ = comment.begin + static_cast<std::uint32_t>(comment.text.size());
    }
    next_on_line_ = !tokens_[last_ + 1].starts_line;
    return true;
  }

  [[nodiscard]] std::uint32_t behind() const { return tokens_[last_ + 1].begin; }

  /// Widens [begin_, end_) to whole lines, with the blank lines that are then one too many.
  void take_lines() {
    begin_ = static_cast<std::uint32_t>(text_.substr(0, begin_).rfind('\n') + 1);
    end_ = line_behind(end_);
    const auto after = tokens_.comments_before(last_ + 1);
    const auto next = std::find_if(after.begin(), after.end(), [](const Comment& one) { return one.starts_line; });
    const bool below_blank = next == after.end() ? tokens_[last_ + 1].behind_blank_line : next->behind_blank_line;
    const bool at_end = next == after.end() && (tokens_[last_ + 1].text == "}" || tokens_[last_ + 1].text.empty());
    if (above_blank_ && (below_blank || at_end)) {
      begin_ = static_cast<std::uint32_t>(text_.find_last_not_of(" \t\r\n", begin_ - 1) + 1);
      begin_ = std::min(line_behind(begin_), end_);
    } else if (below_blank && (first_ == 0 || tokens_[first_ - 1].text == "{")) {
      const std::size_t content = std::min(text_.find_first_not_of(" \t\r\n", end_), text_.size());
      end_ = static_cast<std::uint32_t>(text_.substr(0, content).rfind('\n') + 1);
    }
  }

  /// The start of the line below the one of a byte that blanks follow.
  [[nodiscard]] std::uint32_t line_behind(std::uint32_t byte) const {
    const std::size_t end = std::min(text_.find('\n', byte), text_.size());
    return static_cast<std::uint32_t>(std::min(end + 1, text_.size()));
  }

  const Tokens& tokens_;
  std::string_view text_;
  std::size_t first_, last_;  ///< tokens
  std::uint32_t begin_ = 0, end_ = 0;
  bool above_blank_ = false;   ///< a blank line stands above all that goes
  bool next_on_line_ = false;  ///< something else follows on the line
};

}  // namespace

bool speaks_to_lint(std::string_view comment) {
  comment.remove_prefix(std::min<std::size_t>(2, comment.size()));
  comment.remove_prefix(std::min(comment.find_first_not_of(" \t\r\n"), comment.size()));
  return comment.starts_with("lint:");
}

const Tokens& Removals::tokens(std::uint32_t file) {
  const auto known = tokens_.find(file);
  return known != tokens_.end() ? known->second : tokens_.emplace(file, Tokens(sources_[file].text())).first->second;
}

std::vector<Edit> Removals::of_statement(Span part) {
  const Tokens& all = tokens(part.file);
  const std::size_t token = all.at(part.begin);
  if (token + 1 >= all.count()) return {};
  return Statement(all, sources_[part.file].text(), token).removal(part.file);
}

std::vector<Edit> Removals::of_name(Span name) {
  const Tokens& all = tokens(name.file);
  const std::size_t token = all.at(name.begin);
  if (token == 0 || token + 2 >= all.count()) return {};
  const std::size_t first = all[token - 1].text == "," ? token - 1 : token;
  if (first == token && all[token + 1].text != ",") return of_statement(name);
  if (!Statement(all, sources_[name.file].text(), token).is_uncommented()) return {};
  if (first < token) return {{{name.file, all[first].begin, end_of(all[token])}, ""}};
  return {{{name.file, all[token].begin, all[token + 2].begin}, ""}};
}

void propose(grammar::Diagnostic& finding, std::vector<Edit> removal) {
  if (removal.empty()) return;
  finding.suggestion = "remove it";
  finding.fix = std::move(removal);
}

}  // namespace rmpl::compiler
