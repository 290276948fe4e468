// A function of modes, as conditions.
// SPDX-License-Identifier: MIT
#include "verifier/markov/mode_cases.hpp"

#include <algorithm>
#include <map>
#include <optional>

namespace rmpl::verifier {

using automata::ModeId;

namespace {

using ModeRow = std::pair<std::vector<ModeId>, std::size_t>;

/// The rows without that column; nothing where it decides something.
std::optional<std::vector<ModeRow>> without(const std::vector<ModeRow>& rows, std::size_t column) {
  std::map<std::vector<ModeId>, std::size_t> rest;
  for (const auto& [modes, number] : rows) {
    std::vector<ModeId> others = modes;
    others.erase(others.begin() + static_cast<std::ptrdiff_t>(column));
    if (rest.emplace(std::move(others), number).first->second != number) return std::nullopt;
  }
  return std::vector<ModeRow>(rest.begin(), rest.end());
}

}  // namespace

std::vector<Condition> ModeCases::conditions() const {
  std::vector<automata::ComponentId> components = components_;
  std::vector<ModeRow> rows = rows_;
  for (std::size_t c = components.size(); c-- > 0;) {
    auto fewer = without(rows, c);
    if (!fewer) continue;
    rows = std::move(*fewer);
    components.erase(components.begin() + static_cast<std::ptrdiff_t>(c));
  }
  std::vector<Condition> result;
  for (const auto& [modes, number] : rows) {
    if (result.size() <= number) result.resize(number + 1);
    auto& combination = result[number].emplace_back();
    for (std::size_t c = 0; c < components.size(); ++c) combination.push_back({components[c], modes[c]});
  }
  return result;
}

}  // namespace rmpl::verifier
