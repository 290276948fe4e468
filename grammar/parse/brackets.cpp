// A stack of brackets; one that closes another kind leaves what is inside it unclosed.
// SPDX-License-Identifier: MIT
#include "grammar/parse/brackets.hpp"

#include <algorithm>

#include "grammar/parse/scan.hpp"

namespace rmpl::grammar {

const char* Brackets::open(char kind, const char* place) {
  for (at_ = skip_blank(at_, end_); at_ < place; at_ = skip_blank(at_, end_)) {
    const std::string_view token = token_at(at_, end_);
    if (token == "(" || token == "[" || token == "{") open_.push_back(at_);
    if (token == ")") close('(');
    if (token == "]") close('[');
    if (token == "}") close('{');
    // A statement ends, and so does what it left open.
    while (token == ";" && !open_.empty() && *open_.back() != '{') open_.pop_back();
    at_ += token.size();
  }
  const auto found = std::find_if(open_.rbegin(), open_.rend(), [&](const char* one) { return *one == kind; });
  return found == open_.rend() ? nullptr : *found;
}

void Brackets::close(char kind) {
  const auto same = std::find_if(open_.rbegin(), open_.rend(), [&](const char* one) { return *one == kind; });
  if (same != open_.rend()) open_.erase(std::prev(same.base()), open_.end());
}

}  // namespace rmpl::grammar
