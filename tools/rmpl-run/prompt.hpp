// Lines that somebody types, with editing and history; or those of a file.
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "base/input_file.hpp"

namespace rmpl::tools {

inline constexpr const char* prompt_text = "step> ";

/// Standard input, line by line. On a terminal lines are edited by libedit, with a history and, at a tab, the words
/// that may be meant.
class Prompt {
 public:
  /// `words` gives what may be completed at the time.
  explicit Prompt(std::function<std::vector<std::string>()> words);

  /// Whether somebody sits there.
  [[nodiscard]] bool is_terminal() const { return !input_; }
  /// The next line without its end; nothing at the end of the input, or once a signal came. Throws base::InputError
  /// where it cannot be read.
  std::optional<std::string> next();

 private:
  std::function<std::vector<std::string>()> words_;
  std::optional<base::InputFile> input_;  ///< none on a terminal
};

}  // namespace rmpl::tools
