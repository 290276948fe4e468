// Lines, and the column of the comments behind them.
// SPDX-License-Identifier: MIT
#include "compiler/format/writer.hpp"

#include <algorithm>

#include "compiler/format/format.hpp"
#include "compiler/format/tokens.hpp"

namespace rmpl::compiler {

void Writer::end_line(bool blank) {
  if (text_.empty()) return;
  text_ += blank ? "\n\n" : "\n";
  if (blank) ++paragraph_;
  column_ = 0;
}

void Writer::blanks(std::uint32_t count) {
  text_.append(count, ' ');
  column_ += count;
}

void Writer::write(std::string_view text) {
  text_ += text;
  column_ += width_of(text);
}

void Writer::write_comment(std::string_view text, std::size_t column) {
  const std::size_t old_column = column;
  const std::size_t new_column = column_;
  std::size_t end = std::min(text.find('\n'), text.size());
  write(without_trailing_blanks(text.substr(0, end)));
  while (end < text.size()) {
    text.remove_prefix(end + 1);
    end = std::min(text.find('\n'), text.size());
    std::string_view line = without_trailing_blanks(text.substr(0, end));
    text_ += '\n';
    column_ = 0;
    const std::size_t indent = std::min(line.find_first_not_of(" \t"), line.size());
    if (old_column > new_column) line.remove_prefix(std::min(indent, old_column - new_column));
    if (new_column > old_column && !line.empty()) blanks(static_cast<std::uint32_t>(new_column - old_column));
    write(line);
  }
}

void Writer::start_trailing_comment(std::uint32_t width) {
  trailing_.push_back({text_.size(), column_, width, paragraph_});
}

std::string Writer::finish() {
  constexpr std::uint32_t gap = 2;
  std::string result;
  result.reserve(text_.size() + 16 * trailing_.size() + 1);
  std::size_t copied = 0;
  for (std::size_t first = 0; first < trailing_.size();) {
    std::size_t end = first;
    std::uint32_t column = 0;
    const auto fits = [&](const Trailing& one, std::uint32_t at) { return at + gap + one.width <= line_width; };
    for (; end < trailing_.size() && trailing_[end].paragraph == trailing_[first].paragraph; ++end) {
      if (fits(trailing_[end], trailing_[end].column)) column = std::max(column, trailing_[end].column);
    }
    for (; first < end; ++first) {
      const Trailing& one = trailing_[first];
      result.append(text_, copied, one.place - copied);
      copied = one.place;
      const std::uint32_t at = fits(one, column) ? std::max(column, one.column) : one.column;
      result.append(at + gap - one.column, ' ');
    }
  }
  result.append(text_, copied);
  if (!result.empty()) result += '\n';
  return result;
}

}  // namespace rmpl::compiler
