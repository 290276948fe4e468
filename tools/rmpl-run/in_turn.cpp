// One after the other.
// SPDX-License-Identifier: MIT
#include "tools/rmpl-run/in_turn.hpp"

#include "tools/shared/terminal.hpp"

namespace rmpl::tools {
namespace {

void tell(InTurn::To to, const std::string& text) {
  switch (to) {
    case InTurn::To::output:
      return print(text);
    case InTurn::To::error:
      return print_error(text);
  }
}

}  // namespace

void InTurn::say(std::size_t speaker, To to, const std::string& text) {
  const std::lock_guard lock(mutex_);
  if (speaker == first_) {
    tell(to, text);
  } else {
    kept_[speaker].emplace_back(to, text);
  }
}

void InTurn::done(std::size_t speaker) {
  const std::lock_guard lock(mutex_);
  done_[speaker] = true;
  while (first_ < done_.size() && done_[first_]) {
    if (++first_ == kept_.size()) break;
    for (const auto& [to, text] : std::exchange(kept_[first_], {})) tell(to, text);
  }
}

bool InTurn::has_the_word(std::size_t speaker) {
  const std::lock_guard lock(mutex_);
  return speaker == first_;
}

}  // namespace rmpl::tools
