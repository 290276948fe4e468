// Lines that belong together, and hunks of those that differ.
// SPDX-License-Identifier: MIT
#include "compiler/format/difference.hpp"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace rmpl::compiler {
namespace {

/// The lines of a text, each with its end, where it has one.
class Lines {
 public:
  explicit Lines(std::string_view text) {
    while (!text.empty()) {
      const std::size_t end = std::min(text.find('\n'), text.size() - 1) + 1;
      lines_.push_back(text.substr(0, end));
      text.remove_prefix(end);
    }
  }
  [[nodiscard]] std::size_t count() const { return lines_.size(); }
  [[nodiscard]] std::string_view operator[](std::size_t line) const { return lines_[line]; }
  /// The number of characters that are no blanks.
  [[nodiscard]] std::size_t weight(std::size_t line) const {
    std::string_view text = lines_[line];
    if (line == 0 && text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);  // a byte order mark goes
    return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) {
      return std::string_view(" \t\n\v\f\r").find(c) == std::string_view::npos;
    }));
  }

 private:
  std::vector<std::string_view> lines_;
};

/// Lines [old_begin, old_end) become [new_begin, new_end); or, not `changed`, they are one line that stays.
struct Stretch {
  std::size_t old_begin = 0, old_end = 0, new_begin = 0, new_end = 0;
  bool changed = false;
};

std::vector<Stretch> stretches(const Lines& before, const Lines& after) {
  std::vector<Stretch> all;
  std::size_t i = 0, j = 0;
  while (i < before.count() || j < after.count()) {
    Stretch one{i, i, j, j, true};
    const bool old_blank = i < before.count() && before.weight(i) == 0;
    const bool new_blank = j < after.count() && after.weight(j) == 0;
    if (old_blank != new_blank || i == before.count() || j == after.count()) {
      // A blank line on one side, or the rest of it.
      (new_blank || i == before.count() ? j : i) += 1;
    } else {
      std::size_t old_weight = before.weight(i++), new_weight = after.weight(j++);
      while (old_weight != new_weight && (i < before.count() || j < after.count())) {
        const bool take_old = j == after.count() || (old_weight < new_weight && i < before.count());
        take_old ? old_weight += before.weight(i++) : new_weight += after.weight(j++);
      }
      one.changed = i - one.old_begin != 1 || j - one.new_begin != 1 || before[one.old_begin] != after[one.new_begin];
    }
    one.old_end = i;
    one.new_end = j;
    all.push_back(one);
  }
  return all;
}

class Hunks {
 public:
  Hunks(const Lines& before, const Lines& after) : before_(before), after_(after), all_(stretches(before, after)) {}

  std::string write() {
    for (std::size_t i = 0; i < all_.size();) {
      if (!all_[i].changed) {
        ++i;
        continue;
      }
      std::size_t last = i;
      for (std::size_t next = i + 1; next < all_.size() && next - last <= 2 * context + 1; ++next) {
        if (all_[next].changed) last = next;
      }
      write_hunk(i - std::min(i, context), std::min(last + context + 1, all_.size()), i);
      i = std::min(last + context + 1, all_.size());
    }
    return std::move(text_);
  }

 private:
  static constexpr std::size_t context = 3;

  /// The stretches [begin, end); context before the first change does not reach back into the last hunk.
  void write_hunk(std::size_t begin, std::size_t end, std::size_t change) {
    begin = std::max(begin, written_);
    while (begin < change && all_[begin].changed) ++begin;
    written_ = end;
    text_ += "@@ -" + range(all_[begin].old_begin, all_[end - 1].old_end) + " +" +
             range(all_[begin].new_begin, all_[end - 1].new_end) + " @@\n";
    for (std::size_t i = begin; i < end;) {
      if (!all_[i].changed) {
        write_line(' ', before_[all_[i++].old_begin]);
        continue;
      }
      const std::size_t first = i;
      while (i < end && all_[i].changed) ++i;
      for (std::size_t line = all_[first].old_begin; line < all_[i - 1].old_end; ++line) write_line('-', before_[line]);
      for (std::size_t line = all_[first].new_begin; line < all_[i - 1].new_end; ++line) write_line('+', after_[line]);
    }
  }

  /// Of no lines, it is the line before them that is named.
  static std::string range(std::size_t begin, std::size_t end) {
    const std::size_t count = end - begin;
    const std::string start = std::to_string(count == 0 ? begin : begin + 1);
    return count == 1 ? start : start + "," + std::to_string(count);
  }

  void write_line(char mark, std::string_view line) {
    text_ += mark;
    text_ += line;
    if (!line.ends_with('\n')) text_ += "\n\\ No newline at end of file\n";
  }

  const Lines& before_;
  const Lines& after_;
  std::vector<Stretch> all_;
  std::size_t written_ = 0;
  std::string text_;
};

}  // namespace

std::string layout_difference(std::string_view before, std::string_view after, const std::string& name) {
  if (before == after) return {};
  return "--- " + name + "\n+++ " + name + "\n" + Hunks(Lines(before), Lines(after)).write();
}

}  // namespace rmpl::compiler
