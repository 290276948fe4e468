// Printing the stream: a scope that fits stays on its line, and with each place it is known how much comes before the
// next one, so that nothing is tried twice.
// SPDX-License-Identifier: MIT
#include "compiler/format/layout.hpp"

#include <algorithm>

#include "base/check.hpp"
#include "compiler/format/format.hpp"
#include "compiler/format/measure.hpp"
#include "compiler/format/writer.hpp"

namespace rmpl::compiler {
namespace {

class Printer {
 public:
  explicit Printer(const Document& document)
      : tokens_(document.tokens()), events_(document.events()), measures_(measure(document)) {
    scopes_.push_back({});
  }

  std::string print() {
    for (std::uint32_t i = 0; i < events_.size(); ++i) {
      switch (events_[i].kind) {
        case EventKind::token:
          print_token(events_[i]);
          break;
        case EventKind::line:
          if (breaks(i)) break_line(events_[i]);
          break;
        case EventKind::open:
          open(i);
          break;
        case EventKind::close:
          scopes_.pop_back();
          unset_ = std::min(unset_, scopes_.size());
          break;
      }
    }
    return writer_.finish();
  }

 private:
  struct Scope {
    Breaks breaks = Breaks::all;
    Margin margin = Margin::outer;
    bool flat = false;
    bool nested = false;       ///< its margin has moved
    std::uint32_t column = 0;  ///< where its lines start
  };

  /// The column where what comes next would stand, had it a blank before it or not: widths have it.
  [[nodiscard]] std::uint32_t column() const {
    if (line_ == nullptr) return writer_.column();
    const std::uint32_t margin = scopes_.back().column;
    return line_->space && margin > 0 ? margin - 1 : margin;
  }

  void open(std::uint32_t i) {
    const Scope& outer = scopes_.back();
    Scope scope;
    scope.breaks = events_[i].breaks;
    scope.margin = events_[i].margin;
    scope.column = outer.column;
    const std::uint32_t close = events_[i].target;
    scope.flat =
        outer.flat || (measures_.hard[i] >= close && fits(measures_.between(i, close) + measures_.ahead[close]));
    const bool waits = scope.margin == Margin::aligned || unset_ < scopes_.size();
    scopes_.push_back(scope);
    if (!waits) unset_ = scopes_.size();
  }

  [[nodiscard]] bool fits(std::uint32_t width) const { return column() + width <= line_width; }

  [[nodiscard]] bool breaks(std::uint32_t i) const {
    const Event& line = events_[i];
    if (line.hard) return true;
    const Scope& scope = scopes_.back();
    if (scope.flat) return false;
    if (scope.breaks == Breaks::all) return true;
    if (line.lazy) return !fits(measures_.ahead[i + 1]);
    const std::uint32_t stop = std::min(line.target, measures_.hard[i + 1]);
    const bool closes = events_[stop].kind == EventKind::close;
    return !fits(measures_.between(i, stop) + (closes ? measures_.ahead[stop] : 0));
  }

  void break_line(const Event& line) {
    Scope& scope = scopes_.back();
    if (scope.margin == Margin::nested && !scope.nested) {
      scope.nested = true;
      scope.column += 2;
    }
    line_ = &line;
    comment_column_ = scope.column;
  }

  void print_token(const Event& event) {
    const Token& token = tokens_[event.target];
    if (line_ != nullptr && line_->hard) {
      print_gap(event.target);
    } else {
      if (line_ != nullptr) new_line(scopes_.back().column, false);
      if (line_ == nullptr) writer_.blanks((event.space ? 1 : 0) + event.pad);
      for (const Comment& comment : tokens_.comments_before(event.target)) {
        write_comment(comment);
        writer_.blanks(1);
      }
    }
    line_ = nullptr;
    for (; unset_ < scopes_.size(); ++unset_) {
      if (scopes_[unset_].margin == Margin::aligned) below_ = writer_.column();
      scopes_[unset_].column = below_;
    }
    writer_.write(token.text);
  }

  /// What stands between two lines: the rest of the one, comments on lines of their own, and the start of the other.
  void print_gap(std::size_t token) {
    const auto comments = tokens_.comments_before(token);
    const auto beside = comments_beside(tokens_, token, true);
    const std::size_t own = comments.size() - beside.size();
    bool may_be_blank = line_->blank && token != 0 && tokens_[token - 1].text != "{";
    for (std::size_t i = 0; i < own; ++i) {
      const Comment& comment = comments[i];
      if (comment.starts_line) {
        new_line(comment_column_, may_be_blank && comment.behind_blank_line);
      } else if (i == 0) {
        start_trailing(comments.subspan(0, own));
      } else {
        writer_.blanks(1);
      }
      write_comment(comment);
      may_be_blank = line_->blank;
    }
    const bool closes = tokens_[token].text == "}" || tokens_[token].text.empty();
    if (beside.empty()) {
      if (!tokens_[token].text.empty())
        new_line(scopes_.back().column, may_be_blank && !closes && tokens_[token].behind_blank_line);
      return;
    }
    new_line(closes ? comment_column_ : scopes_.back().column, may_be_blank && beside.front().behind_blank_line);
    for (const Comment& comment : beside) {
      write_comment(comment);
      writer_.blanks(1);
    }
  }

  /// Comments behind a statement, up to one that starts a line. With one of several lines they stand where they are:
  /// its lines move together.
  void start_trailing(std::span<const Comment> comments) {
    std::uint32_t width = 0;
    bool several_lines = false;
    for (const Comment& comment : comments) {
      if (comment.starts_line) break;
      width += (width == 0 ? 0 : 1) + width_of(comment.text);
      several_lines = several_lines || comment.text.find('\n') != std::string_view::npos;
    }
    if (several_lines) {
      writer_.blanks(2);
    } else {
      writer_.start_trailing_comment(width);
    }
  }

  void new_line(std::uint32_t column, bool blank) {
    writer_.end_line(blank);
    writer_.blanks(column);
  }

  void write_comment(const Comment& comment) {
    const bool one_line = comment.text.find('\n') == std::string_view::npos;
    if (one_line) return writer_.write(comment.text);
    writer_.write_comment(comment.text, tokens_.column(comment.begin));
  }

  const Tokens& tokens_;
  const std::vector<Event>& events_;
  const Measures measures_;
  Writer writer_;
  std::vector<Scope> scopes_;
  const Event* line_ = nullptr;  ///< the break since the last token
  std::uint32_t comment_column_ = 0;
  std::size_t unset_ = 1;  ///< from here on the scopes wait for their first token
  std::uint32_t below_ = 0;
};

}  // namespace

std::string lay_out(Document& document) {
  align_tables(document, measure(document));
  return Printer(document).print();
}

}  // namespace rmpl::compiler
