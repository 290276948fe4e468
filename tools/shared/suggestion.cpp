// Finds the nearest name, or lists them.
// SPDX-License-Identifier: MIT
#include "tools/shared/suggestion.hpp"

#include "base/nearest.hpp"

namespace rmpl::tools {
namespace {

/// Names that a message lists; of more, the first few.
constexpr std::size_t most_listed = 24;
constexpr std::size_t few_listed = 5;

}  // namespace

std::string suggestion_or_list(std::string_view name, const std::vector<std::string_view>& candidates) {
  std::string text = base::suggestion(name, candidates);
  if (!text.empty() || candidates.empty()) return text;
  const bool all = candidates.size() <= most_listed;
  const std::size_t listed = all ? candidates.size() : few_listed;
  text = all ? "; expected '" : "; expected one of " + std::to_string(candidates.size()) + ", such as '";
  for (std::size_t c = 0; c < listed; ++c) {
    if (c > 0) text += c + 1 == listed ? "' or '" : "', '";
    text += candidates[c];
  }
  return text + "'";
}

}  // namespace rmpl::tools
