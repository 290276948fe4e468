// One-step extensions as an optimal constraint satisfaction problem.
// SPDX-License-Identifier: MIT
#include "runtime/estimate/extensions.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

namespace runtime {
namespace {

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
    : evidence_(&evidence), search_({}) {
  restart(evidence, moves);
}

void Extensions::restart(Evidence& evidence, const std::vector<std::vector<automata::Move>>& moves) {
  evidence_ = &evidence;
  found_.clear();
  priors_.resize(moves.size());
  costs_.resize(moves.size());
  for (std::size_t c = 0; c < moves.size(); ++c) {
    priors_[c].assign(moves[c].empty() ? 0 : moves[c].back().mode.index() + 1, 0.0);
    for (const automata::Move& move : moves[c]) priors_[c][move.mode.index()] = move.probability;
    costs_[c].clear();
    // A rounded probability may exceed 1 in the last bit.
    for (const double prior : priors_[c]) costs_[c].push_back(std::max(0.0, -std::log(prior)));
  }
  search_.restart(costs_, evidence.conflicts());
}

void Extensions::check_one() {
  search_.set_budget(1);
  double factor = 0;
  const auto check = [&](std::span<const std::uint32_t> candidate) -> std::optional<Conflict> {
    const automata::Modes modes = modes_of(candidate);
    factor = evidence_->factor(modes);
    if (factor > 0) return std::nullopt;
    return evidence_->blame(modes);
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
