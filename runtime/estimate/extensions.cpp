// One-step extensions as an optimal constraint satisfaction problem.
// SPDX-License-Identifier: MIT
#include "runtime/estimate/extensions.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

namespace runtime {
namespace {

std::vector<std::vector<double>> by_mode(const std::vector<std::vector<automata::Move>>& moves) {
  std::vector<std::vector<double>> priors(moves.size());
  for (std::size_t c = 0; c < moves.size(); ++c) {
    for (const automata::Move& move : moves[c]) {
      priors[c].resize(move.mode.index() + 1);
      priors[c].back() = move.probability;
    }
  }
  return priors;
}

OptimalSearch::Costs costs(const std::vector<std::vector<double>>& priors) {
  OptimalSearch::Costs costs = priors;
  for (auto& component : costs) {
    // A rounded probability may exceed 1 in the last bit.
    for (double& value : component) value = std::max(0.0, -std::log(value));
  }
  return costs;
}

automata::Modes modes_of(std::span<const std::uint32_t> candidate) {
  automata::Modes modes;
  modes.reserve(candidate.size());
  for (const std::uint32_t mode : candidate) modes.emplace_back(mode);
  return modes;
}

}  // namespace

Evidence::Evidence(automata::PlantStep& step, automata::Observation observation, ConflictSet& lasting)
    : step_(step),
      observation_(std::move(observation)),
      lasting_(lasting),
      conflicts_(std::make_shared<ConflictSet>(lasting)) {}

double Evidence::factor(const automata::Modes& modes) { return step_.observation_factor(modes, observation_); }

Conflict Evidence::blame(const automata::Modes& modes) {
  std::vector<automata::Assignment> assumptions = automata::assignments_of(step_.plant(), modes);
  if (!step_.theory().consistent(assumptions)) {
    Conflict conflict = decisions_in(step_.theory().conflict(), modes);
    lasting_.add(conflict);
    return conflict;
  }
  assumptions.insert(assumptions.end(), observation_.begin(), observation_.end());
  [[maybe_unused]] const bool consistent = step_.theory().consistent(assumptions);
  assert(!consistent);
  return decisions_in(step_.theory().conflict(), modes);
}

Conflict Evidence::decisions_in(std::span<const automata::Assignment> conflict, const automata::Modes& modes) const {
  Conflict decisions;
  // The modes were assumed in order of component, so the conflict names them in that order.
  const auto& components = step_.plant().components;
  std::uint32_t component = 0;
  for (const automata::Assignment& a : conflict) {
    std::uint32_t at = component;
    while (at < components.size() && components[at].mode != a.variable) ++at;
    if (at == components.size() || modes[at].value != a.value.value) continue;
    decisions.push_back({at, a.value.value});
    component = at + 1;
  }
  return decisions;
}

Extensions::Extensions(Evidence& evidence, const std::vector<std::vector<automata::Move>>& moves)
    : evidence_(evidence), priors_(by_mode(moves)), search_(costs(priors_), evidence.conflicts()) {}

void Extensions::check_one() {
  search_.set_budget(1);
  double factor = 0;
  const auto check = [&](std::span<const std::uint32_t> candidate) -> std::optional<Conflict> {
    const automata::Modes modes = modes_of(candidate);
    factor = evidence_.factor(modes);
    if (factor > 0) return std::nullopt;
    return evidence_.blame(modes);
  };
  if (search_.next(check) != OptimalSearch::Outcome::solution) return;
  automata::Modes modes = modes_of(search_.values());
  const double probability = prior(modes);
  found_.push_back({std::move(modes), probability, factor});
}

double Extensions::bound(std::size_t i) const {
  return i < found_.size() ? found_[i].prior : std::exp(-search_.bound());
}

}  // namespace runtime
