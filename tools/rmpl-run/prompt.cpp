// libedit behind the interface that it shares with readline, or a stream.
// SPDX-License-Identifier: MIT
#include "tools/rmpl-run/prompt.hpp"

#include <editline/readline.h>
#include <unistd.h>

#include <cstdlib>
#include <cstring>
#include <string_view>
#include <utility>

#include "tools/shared/interruption.hpp"

namespace rmpl::tools {
namespace {

/// What libedit's callbacks, which are functions of C, complete from.
std::vector<std::string>& completions() {
  static std::vector<std::string> words;
  return words;
}

/// One match after the other, from state 0 on; null at the end. libedit frees them.
char* next_match(const char* begun, int state) {
  static std::size_t at = 0;
  if (state == 0) at = 0;
  const std::vector<std::string>& words = completions();
  while (at < words.size()) {
    const std::string& word = words[at++];
    if (std::string_view(word).starts_with(begun)) return ::strdup(word.c_str());
  }
  return nullptr;
}

}  // namespace

Prompt::Prompt(std::function<std::vector<std::string>()> words) : words_(std::move(words)) {
  if (::isatty(STDIN_FILENO) == 0) {
    input_.emplace("-", interrupted);
    return;
  }
  using_history();
  rl_completion_entry_function = next_match;
}

std::optional<std::string> Prompt::next() {
  if (input_) {
    std::string line;
    if (!std::getline(input_->stream(), line)) return std::nullopt;
    return line;
  }
  completions() = words_();
  char* line = readline(prompt_text);
  if (line == nullptr || interrupted()) {
    std::free(line);
    return std::nullopt;
  }
  std::string text = line;
  std::free(line);
  if (!text.empty()) add_history(text.c_str());
  return text;
}

}  // namespace rmpl::tools
