// Colours of a terminal, or none: by what they mean.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace rmpl::base {

/// Puts ANSI colours around text where they are wanted.
struct Painter {
  bool color = false;

  [[nodiscard]] std::string good(std::string_view text) const { return painted("1;32", text); }
  [[nodiscard]] std::string bad(std::string_view text) const { return painted("1;31", text); }
  [[nodiscard]] std::string doubtful(std::string_view text) const { return painted("1;33", text); }
  [[nodiscard]] std::string note(std::string_view text) const { return painted("1;36", text); }
  [[nodiscard]] std::string place(std::string_view text) const { return painted("1;34", text); }
  [[nodiscard]] std::string strong(std::string_view text) const { return painted("1", text); }
  [[nodiscard]] std::string quiet(std::string_view text) const { return painted("2", text); }

 private:
  [[nodiscard]] std::string painted(std::string_view code, std::string_view text) const {
    if (!color) return std::string(text);
    return "\x1b[" + std::string(code) + "m" + std::string(text) + "\x1b[0m";
  }
};

}  // namespace rmpl::base
