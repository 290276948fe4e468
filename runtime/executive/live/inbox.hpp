// Bytes into lines, in bounded memory.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace rmpl::runtime {

/// The lines of one connection.
class Inbox {
 public:
  /// Bytes of a line, without its end; what is longer is not kept.
  static constexpr std::size_t longest = std::size_t{1} << 16U;

  struct Line {
    std::string text;  ///< empty where the line was too long
    bool too_long = false;
  };

  void add(std::string_view bytes) { bytes_ += bytes; }
  /// The next line that has ended.
  std::optional<Line> next();
  /// Whether a line was begun that has not ended.
  [[nodiscard]] bool begun() const { return too_long_ || begin_ < bytes_.size(); }
  void clear() { *this = {}; }

 private:
  std::string bytes_;
  std::size_t begin_ = 0;   ///< of what was not handed out yet
  std::size_t looked_ = 0;  ///< there is no line feed before
  bool too_long_ = false;   ///< the line that goes on has been too long already
};

}  // namespace rmpl::runtime
