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
  const automata::Refutation refutation = step_.refutation(modes, observation_);
  Conflict conflict;
  for (const automata::ComponentId c : refutation.components) conflict.push_back({c.value, modes[c.index()].value});
  if (refutation.lasting) lasting_.add(conflict);
  return conflict;
}

Extensions::Extensions(Evidence& evidence, const std::vector<std::vector<automata::Move>>& moves)
    : evidence_(&evidence), search_({}) {
  restart(evidence, moves);
}

void Extensions::restart(Evidence& evidence, const std::vector<std::vector<automata::Move>>& moves) {
  evidence_ = &evidence;
  found_.clear();
  priors_.clear();
  begin_.assign(1, 0);
  best_ = 1;
  started_ = false;
  for (const std::vector<automata::Move>& component : moves) {
    double greatest = 0;
    priors_.resize(begin_.back() + (component.empty() ? 0 : component.back().mode.index() + 1), 0.0);
    for (const automata::Move& move : component) {
      priors_[begin_.back() + move.mode.index()] = move.probability;
      greatest = std::max(greatest, move.probability);
    }
    begin_.push_back(static_cast<std::uint32_t>(priors_.size()));
    best_ *= greatest;
  }
}

void Extensions::start() {
  started_ = true;
  costs_.resize(begin_.size() - 1);
  for (std::size_t c = 0; c < costs_.size(); ++c) {
    costs_[c].clear();
    // A rounded probability may exceed 1 in the last bit.
    for (std::uint32_t i = begin_[c]; i < begin_[c + 1]; ++i) {
      costs_[c].push_back(std::max(0.0, -std::log(priors_[i])));
    }
  }
  search_.restart(costs_, evidence_->conflicts());
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

}  // namespace runtime
