// Widths on one line, and the columns of tables.
// SPDX-License-Identifier: MIT
#include "compiler/format/measure.hpp"

#include <algorithm>

#include "compiler/format/format.hpp"

namespace rmpl::compiler {
namespace {

/// Of a comment its first line counts: where the others start depends on where it does.
std::uint32_t comment_width(const Comment& comment) {
  return width_of(comment.text.substr(0, std::min(comment.text.find('\n'), comment.text.size())));
}

std::uint32_t token_width(const Document& document, const Event& event, bool behind_hard_line) {
  std::uint32_t width = (event.space ? 1 : 0) + event.pad + width_of(document.tokens()[event.target].text);
  for (const Comment& comment : comments_beside(document.tokens(), event.target, behind_hard_line)) {
    width += comment_width(comment) + 1;
  }
  return width;
}

/// The rows of one table.
class TableColumns {
 public:
  TableColumns(Document& document, const Measures& measures, std::span<const Row> rows)
      : tokens_(document.tokens()), events_(document.events()), measures_(measures) {
    for (const Row& row : rows) {
      if (!is_commented(row)) rows_.push_back(row);
    }
  }

  void align() {
    align_keywords();
    std::uint32_t columns[2] = {0, 0};
    for (const Row& row : rows_) {
      if (!fits(row, keyword_pad(row))) continue;
      for (std::size_t i = 0; i < row.stop_count; ++i) columns[i] = std::max(columns[i], part_width(row, i));
    }
    for (const Row& row : rows_) {
      std::uint32_t pads = keyword_pad(row);
      for (std::size_t i = 0; i < row.stop_count; ++i) {
        pads += std::max(columns[i], part_width(row, i)) - part_width(row, i);
      }
      if (!fits(row, pads)) continue;
      for (std::size_t i = 0; i < row.stop_count; ++i) {
        events_[token_at(row.stops[i])].pad = columns[i] - part_width(row, i);
      }
    }
  }

 private:
  [[nodiscard]] std::uint32_t token_at(std::uint32_t event) const {
    while (events_[event].kind != EventKind::token) ++event;
    return event;
  }

  /// With comments inside or right before it, a row stands as it is.
  [[nodiscard]] bool is_commented(const Row& row) const {
    const std::uint32_t first = events_[token_at(row.open)].target;
    const std::uint32_t last = events_[events_[row.open].target - 1].target;
    return tokens_[first].comments_end != tokens_[last].comments_end || !comments_beside(tokens_, first, true).empty();
  }

  /// Keywords are a column also of rows that take several lines.
  void align_keywords() {
    std::uint32_t widest = 0;
    const auto width = [&](const Row& row) { return measures_.between(row.open, row.keyword); };
    for (const Row& row : rows_) {
      if (row.keyword != 0) widest = std::max(widest, width(row));
    }
    for (const Row& row : rows_) {
      if (row.keyword != 0) events_[token_at(row.keyword)].pad = widest - width(row);
    }
  }

  [[nodiscard]] std::uint32_t keyword_pad(const Row& row) const {
    return row.keyword == 0 ? 0 : events_[token_at(row.keyword)].pad;
  }

  [[nodiscard]] std::uint32_t part_width(const Row& row, std::size_t part) const {
    const std::uint32_t from = part == 0 ? (row.keyword == 0 ? row.open : row.keyword) : row.stops[part - 1];
    return measures_.between(from, row.stops[part]);
  }

  [[nodiscard]] bool fits(const Row& row, std::uint32_t pads) const {
    const std::uint32_t close = events_[row.open].target;
    return measures_.hard[row.open] >= close && row.margin + measures_.between(row.open, close) + pads <= line_width;
  }

  const Tokens& tokens_;
  std::vector<Event>& events_;
  const Measures& measures_;
  std::vector<Row> rows_;
};

}  // namespace

std::span<const Comment> comments_beside(const Tokens& tokens, std::size_t token, bool behind_hard_line) {
  const auto comments = tokens.comments_before(token);
  if (!behind_hard_line) return comments;
  if (tokens[token].starts_line) return {};
  std::size_t first = comments.size();
  while (first > 0 && (first == comments.size() || !comments[first].starts_line)) --first;
  return comments.subspan(first);
}

Measures measure(const Document& document) {
  const std::vector<Event>& events = document.events();
  const auto count = static_cast<std::uint32_t>(events.size());
  Measures measures;
  measures.before.resize(count + 1);
  measures.ahead.resize(count + 1);
  measures.hard.resize(count + 1, count);
  bool behind_hard_line = true;
  for (std::uint32_t i = 0; i < count; ++i) {
    measures.before[i + 1] = measures.before[i];
    if (events[i].kind == EventKind::line) behind_hard_line = events[i].hard;
    if (events[i].kind != EventKind::token) continue;
    measures.before[i + 1] += token_width(document, events[i], behind_hard_line);
    behind_hard_line = false;
  }
  for (std::uint32_t i = count; i-- > 0;) {
    const bool is_line = events[i].kind == EventKind::line;
    measures.ahead[i] = is_line ? 0 : measures.ahead[i + 1] + measures.between(i, i + 1);
    measures.hard[i] = is_line && events[i].hard ? i : measures.hard[i + 1];
  }
  return measures;
}

void align_tables(Document& document, const Measures& measures) {
  const std::span<const Row> rows = document.rows();
  for (std::size_t first = 0; first < rows.size();) {
    std::size_t end = first + 1;
    while (end < rows.size() && !rows[end].first) ++end;
    TableColumns(document, measures, rows.subspan(first, end - first)).align();
    first = end;
  }
}

}  // namespace rmpl::compiler
