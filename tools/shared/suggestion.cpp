// Finds the nearest name, or lists all.
// SPDX-License-Identifier: MIT
#include "tools/shared/suggestion.hpp"

#include "base/nearest.hpp"

namespace rmpl::tools {

std::string suggestion_or_list(std::string_view name, const std::vector<std::string_view>& candidates) {
  std::string text = base::suggestion(name, candidates);
  if (!text.empty() || candidates.empty()) return text;
  for (std::size_t c = 0; c < candidates.size(); ++c) {
    text += c == 0 ? "; expected '" : c + 1 == candidates.size() ? "' or '" : "', '";
    text += candidates[c];
  }
  return text + "'";
}

}  // namespace rmpl::tools
