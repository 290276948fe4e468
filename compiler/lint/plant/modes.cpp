// Findings: modes that are impossible, never entered, or never the first.
// SPDX-License-Identifier: MIT
#include "compiler/lint/plant/findings.hpp"

namespace rmpl::compiler {

using automata::ComponentId;
using automata::ModeId;

namespace {

template <class Has>
std::vector<PlantMode> modes_with(const PlantAnalysis& analysis, const Has& has) {
  std::vector<PlantMode> found;
  const automata::Plant& plant = analysis.plant();
  for (std::size_t c = 0; c < plant.components.size(); ++c) {
    for (std::size_t m = 0; m < plant.components[c].modes.size(); ++m) {
      if (has(c, m)) found.push_back({ComponentId(c), ModeId(m)});
    }
  }
  return found;
}

}  // namespace

std::vector<PlantMode> find_impossible_modes(const PlantAnalysis& analysis) {
  const Reach& reach = analysis.reach();
  return modes_with(analysis, [&](std::size_t c, std::size_t m) { return !reach.possible[c][m]; });
}

std::vector<PlantMode> find_unreachable_modes(const PlantAnalysis& analysis) {
  const Reach& reach = analysis.reach();
  if (!reach.has_initial_state) return {};
  return modes_with(analysis,
                    [&](std::size_t c, std::size_t m) { return reach.possible[c][m] && !reach.reached[c][m]; });
}

std::vector<PlantMode> find_impossible_initial_modes(const PlantAnalysis& analysis) {
  const Reach& reach = analysis.reach();
  if (!reach.has_initial_state) return {};
  return modes_with(analysis, [&](std::size_t c, std::size_t m) {
    return analysis.plant().components[c].initial[m] > 0 && reach.possible[c][m] && !reach.initial[c][m];
  });
}

}  // namespace rmpl::compiler
