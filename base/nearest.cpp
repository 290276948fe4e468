// Edit distance, and the nearest name by it.
// SPDX-License-Identifier: MIT
#include "base/nearest.hpp"

#include <algorithm>
#include <cctype>

namespace rmpl::base {
namespace {

bool same_but_for_case(std::string_view a, std::string_view b) {
  const auto lower = [](char c) { return std::tolower(static_cast<unsigned char>(c)); };
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [&](char x, char y) { return lower(x) == lower(y); });
}

}  // namespace

std::size_t edit_distance(std::string_view a, std::string_view b, std::size_t limit) {
  const std::size_t difference = a.size() > b.size() ? a.size() - b.size() : b.size() - a.size();
  if (difference > limit) return limit + 1;
  // Three rows of the table: a swap looks two rows back.
  std::vector<std::size_t> before(b.size() + 1);
  std::vector<std::size_t> last(b.size() + 1);
  std::vector<std::size_t> row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) last[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    row[0] = i;
    std::size_t least = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + (a[i - 1] == b[j - 1] ? 0u : 1u)});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) row[j] = std::min(row[j], before[j - 2] + 1);
      least = std::min(least, row[j]);
    }
    if (least > limit) return limit + 1;
    std::swap(before, last);
    std::swap(last, row);
  }
  return std::min(last[b.size()], limit + 1);
}

std::optional<std::string> nearest(std::string_view name, const std::vector<std::string_view>& candidates) {
  std::size_t limit = std::max<std::size_t>(1, (name.size() + 2) / 3);
  std::optional<std::string> best;
  for (const std::string_view candidate : candidates) {
    if (candidate == name) continue;
    if (same_but_for_case(candidate, name)) return std::string(candidate);
    // An edit of everything is no resemblance: one letter is near no other letter.
    const std::size_t distance = edit_distance(name, candidate, limit);
    if (distance > limit || distance >= std::max(name.size(), candidate.size())) continue;
    if (best && distance == limit) continue;
    best = candidate;
    limit = distance;
  }
  return best;
}

std::optional<std::string> nearest(std::string_view name, const std::vector<std::string>& candidates) {
  return nearest(name, std::vector<std::string_view>(candidates.begin(), candidates.end()));
}

std::string suggestion(std::string_view name, const std::vector<std::string_view>& candidates) {
  const auto near = nearest(name, candidates);
  return near ? "; did you mean '" + *near + "'?" : std::string();
}

std::string suggestion(std::string_view name, const std::vector<std::string>& candidates) {
  return suggestion(name, std::vector<std::string_view>(candidates.begin(), candidates.end()));
}

}  // namespace rmpl::base
