// One-step extensions as an optimal constraint satisfaction problem.
// SPDX-License-Identifier: MIT
#include "runtime/reasoning/estimate/extensions.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

namespace rmpl::runtime {
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
  const automata::Refutation refutation = step_.refutation(modes, observation_);
  Conflict conflict;
  for (const automata::ComponentId c : refutation.components) conflict.push_back({c.value, modes[c.index()].value});
  if (refutation.lasting) lasting_.add(conflict);
  return conflict;
}

Extensions::Extensions(Evidence& evidence, const std::vector<std::vector<automata::Move>>& moves) {
  own_.reserve(moves.size());
  std::vector<const ComponentMoves*> all;
  for (const auto& component : moves) all.push_back(&own_.emplace_back(component));
  restart(evidence, all);
}

void Extensions::restart(Evidence& evidence, const std::vector<const ComponentMoves*>& moves) {
  evidence_ = &evidence;
  moves_ = moves;
  found_.clear();
  best_ = 1;
  started_ = false;
  for (const ComponentMoves* const component : moves_) best_ *= component->greatest();
}

void Extensions::start() {
  started_ = true;
  std::vector<const OptimalSearch::Domain*> domains;
  domains.reserve(moves_.size());
  for (const ComponentMoves* const component : moves_) domains.push_back(&component->domain());
  search_.restart(domains, evidence_->conflicts());
}

void Extensions::check_one() {
  if (!started_) start();
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
  if (!started_) return best_;
  return i < found_.size() ? found_[i].prior : std::exp(-search_.bound());
}

}  // namespace rmpl::runtime
