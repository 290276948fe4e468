// The likeliest step from a belief, by conflict-directed search from each of its states.
// SPDX-License-Identifier: MIT
#include "runtime/reasoning/estimate/successor.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "runtime/reasoning/estimate/order.hpp"

namespace rmpl::runtime {
namespace {

using automata::Modes;
using automata::Move;

Modes modes_of(std::span<const std::uint32_t> values) {
  Modes modes;
  for (const std::uint32_t value : values) modes.emplace_back(value);
  return modes;
}

OptimalSearch::Costs costs_of(const std::vector<std::vector<Move>>& moves) {
  OptimalSearch::Costs costs;
  for (const auto& component : moves) {
    auto& values = costs.emplace_back();
    for (const Move& move : component) {
      values.resize(std::max(values.size(), move.mode.index() + 1), std::numeric_limits<double>::infinity());
      values[move.mode.index()] = std::max(0.0, -std::log(move.probability));
    }
  }
  return costs;
}

}  // namespace

std::optional<Modes> likeliest_successor(automata::PlantStep& step, const Belief& belief,
                                         const automata::ControlAction& action, automata::Ticks before,
                                         automata::Ticks now, const ConflictSet& avoided) {
  const auto impossible = [&step](std::span<const std::uint32_t> candidate) -> std::optional<Conflict> {
    const Modes modes = modes_of(candidate);
    if (step.possible(modes)) return std::nullopt;
    Conflict conflict;
    for (const automata::ComponentId c : step.conflict(modes)) conflict.push_back({c.value, modes[c.index()].value});
    return conflict;
  };
  const auto conflicts = std::make_shared<ConflictSet>(avoided);
  std::optional<Modes> best;
  double most = 0;
  for (const BeliefEntry& entry : belief) {
    OptimalSearch search(costs_of(step.moves(entry.state, action, before, now)), conflicts);
    const auto promise = [&] { return entry.probability * std::exp(-search.bound()); };
    if (promise() <= most * (1 + tie_tolerance)) continue;
    if (search.next(impossible) != OptimalSearch::Outcome::solution) continue;
    const double probability = entry.probability * std::exp(-search.cost());
    if (probability <= most * (1 + tie_tolerance)) continue;
    most = probability;
    best = modes_of(search.values());
  }
  return best;
}

}  // namespace rmpl::runtime
