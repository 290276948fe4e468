// Colours of a terminal, or none.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace rmpl::runtime {

/// Puts ANSI colours around text where they are wanted.
struct Style {
  bool color = false;

  [[nodiscard]] std::string good(std::string_view text) const { return painted("32", text); }
  [[nodiscard]] std::string bad(std::string_view text) const { return painted("31", text); }
  [[nodiscard]] std::string quiet(std::string_view text) const { return painted("2", text); }
  [[nodiscard]] std::string strong(std::string_view text) const { return painted("1", text); }

 private:
  [[nodiscard]] std::string painted(std::string_view code, std::string_view text) const {
    if (!color) return std::string(text);
    return "\x1b[" + std::string(code) + "m" + std::string(text) + "\x1b[0m";
  }
};

}  // namespace rmpl::runtime
