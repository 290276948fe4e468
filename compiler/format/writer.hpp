// The text as it is written, line by line; comments at the ends of lines stand below each other.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace rmpl::compiler {

class Writer {
 public:
  [[nodiscard]] std::uint32_t column() const { return column_; }
  [[nodiscard]] bool is_empty() const { return text_.empty(); }

  /// Ends the line, if there is one; `blank`: and leaves one blank.
  void end_line(bool blank);
  void blanks(std::uint32_t count);
  void write(std::string_view text);
  /// A comment of one or more lines that stood at `column` in its text: its lines move together.
  void write_comment(std::string_view text, std::size_t column);
  /// The place behind a statement where a comment of this width comes next, to be aligned with those around it.
  void start_trailing_comment(std::uint32_t width);
  /// All that was written, with the end of its last line.
  std::string finish();

 private:
  /// A place where blanks go in once the paragraph is known.
  struct Trailing {
    std::size_t place = 0;     ///< in the text
    std::uint32_t column = 0;  ///< where the code ends
    std::uint32_t width = 0;
    std::size_t paragraph = 0;
  };

  std::string text_;
  std::uint32_t column_ = 0;
  std::vector<Trailing> trailing_;
  std::size_t paragraph_ = 0;
};

}  // namespace rmpl::compiler
