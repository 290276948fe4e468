// The stream of tokens, breaks and scopes.
// SPDX-License-Identifier: MIT
#include "compiler/format/document.hpp"

#include <algorithm>

#include "base/check.hpp"

namespace rmpl::compiler {

void Document::take() {
  CHECK(next_ < tokens_.count());
  const bool is_hard = pending_line_ != no_line && events_[pending_line_].hard;
  if (!is_hard && line_comment_before_next()) {
    if (pending_line_ == no_line) add_line(true, false);
    events_[pending_line_].hard = true;
  }
  Event event;
  event.target = static_cast<std::uint32_t>(next_);
  const bool behind_hard_line = pending_line_ != no_line && events_[pending_line_].hard;
  event.space = !behind_hard_line && (space_before_next() || has_comments_before_next());
  if (pending_line_ != no_line) events_[pending_line_].space = event.space;
  events_.push_back(event);
  pending_line_ = no_line;
  glued_ = false;
  ++next_;
}

void Document::take_to(std::uint32_t byte) {
  while (next_ + 1 < tokens_.count() && next_begin() < byte) take();
}

void Document::hard_line() {
  add_line(true, false);
  events_.back().blank = true;
}

void Document::open(Breaks breaks, Margin margin) {
  scopes_.push_back({here(), 0});
  Event event;
  event.kind = EventKind::open;
  event.breaks = breaks;
  event.margin = margin;
  events_.push_back(event);
}

void Document::close() {
  CHECK(!scopes_.empty());
  const OpenScope scope = scopes_.back();
  scopes_.pop_back();
  events_[scope.open].target = here();
  if (scope.last_line != 0) events_[scope.last_line].target = here();
  Event event;
  event.kind = EventKind::close;
  events_.push_back(event);
}

void Document::add_line(bool hard, bool lazy) {
  if (!scopes_.empty()) {
    OpenScope& scope = scopes_.back();
    if (scope.last_line != 0) events_[scope.last_line].target = here();
    scope.last_line = here();
  }
  pending_line_ = here();
  Event event;
  event.kind = EventKind::line;
  event.hard = hard;
  event.lazy = lazy;
  events_.push_back(event);
}

void Document::open_statement(Table table) {
  const bool follows = table == table_ && !tokens_.is_behind_blank_line(next_);
  table_ = table;
  if (table != Table::none) {
    Row row;
    row.open = here();
    row.margin = 2 * depth_;
    row.first = !follows;
    rows_.push_back(row);
  }
  open(Breaks::needed, Margin::nested);
}

void Document::take_keyword() {
  take();
  rows_.back().keyword = here();
}

void Document::stop() {
  Row& row = rows_.back();
  row.stops[row.stop_count++] = here();
}

bool Document::space_before_next() const {
  if (glued_ || next_ == 0) return false;
  const std::string_view before = tokens_[next_ - 1].text;
  const std::string_view after = tokens_[next_].text;
  const auto is_one_of = [](std::string_view text, auto... others) { return ((text == others) || ...); };
  if (before == "-" && after.starts_with('"')) return true;  // between channels, and no sign
  return !is_one_of(after, ",", ";", ")", "]") && !is_one_of(before, "(", "[", "!", "¬", "+", "-", "/");
}

bool Document::line_comment_before_next() const {
  const auto comments = tokens_.comments_before(next_);
  return std::any_of(comments.begin(), comments.end(), [](const Comment& one) { return one.to_end_of_line; });
}

}  // namespace rmpl::compiler
