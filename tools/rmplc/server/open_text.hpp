// A text in which something is being written: what stands before the cursor, and the text without it.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "grammar/editor/keywords.hpp"

namespace rmpl::tools {

/// The text up to the cursor: the statement that is open, and the word that is being written.
struct Before {
  std::vector<std::string_view> tokens;  ///< without the word
  std::string_view word;                 ///< `engine.` too
  bool in_comment = false;
  bool in_string = false;

  explicit Before(std::string_view text);
  /// The token so many before the word; empty where there is none.
  [[nodiscard]] std::string_view back(std::size_t n) const {
    return n < tokens.size() ? tokens[tokens.size() - 1 - n] : "";
  }
};

/// The text without the statement that is being written: what holds it in braces may be no statement without it, so
/// innermost first, what might be meant; each also with what is open closed at the end, where all is yet to be written.
std::vector<std::string> without_statement(std::string_view text, const Before& before, std::uint32_t offset);

/// The position of the first text with the fewest errors.
std::size_t best_of(grammar::Language language, const std::vector<std::string>& texts);

}  // namespace rmpl::tools
