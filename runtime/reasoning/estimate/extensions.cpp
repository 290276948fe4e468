// One-step extensions as an optimal constraint satisfaction problem.
// SPDX-License-Identifier: MIT
#include "runtime/reasoning/estimate/extensions.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
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

ReadingEvidence::ReadingEvidence(automata::PlantStep& step, automata::Observation observation, ConflictSet& lasting,
                                 OpenReadings* open)
    : step_(step),
      observation_(std::move(observation)),
      lasting_(lasting),
      open_(open),
      conflicts_(std::make_shared<ConflictSet>(lasting)) {}

double ReadingEvidence::factor(const automata::Modes& modes) { return step_.observation_factor(modes, observation_); }

Conflict ReadingEvidence::blame(const automata::Modes& modes) {
  const automata::Refutation refutation = step_.refutation(modes, observation_);
  Conflict conflict;
  for (const automata::ComponentId c : refutation.components) conflict.push_back({c.value, modes[c.index()].value});
  if (refutation.lasting) lasting_.add(conflict);
  return conflict;
}

const OpeningFactors& ReadingEvidence::opening_factors() {
  if (!opening_factors_) opening_factors_.emplace(step_.plant(), open_->openings(), observation_);
  return *opening_factors_;
}

const FactorBound& ReadingEvidence::factor_bound(const automata::Modes& base) {
  constexpr std::size_t most = 64;
  const auto known = bounds_.find(base);
  if (known != bounds_.end()) return known->second;
  if (bounds_.size() >= most) bounds_.clear();
  return bounds_.emplace(base, factor_bound(base, &opening_factors())).first->second;
}

/// Each reading that the base leaves open stays open until one of the components that this rests on changes. What a
/// component opens by itself is counted where it is: in the base it is left out here, and in another mode taken back.
FactorBound ReadingEvidence::factor_bound(const automata::Modes& base, const OpeningFactors* counted) const {
  FactorBound bound{1, std::vector<double>(base.size(), 1.0)};
  for (std::size_t i = 0; i < observation_.size(); ++i) {
    const Opening* const opening = counted != nullptr ? counted->opening(i) : nullptr;
    if (opening != nullptr && opening->modes[base[opening->component.index()].index()]) continue;
    const automata::Assignment reading = observation_[i];
    const std::vector<automata::ComponentId>* components = open_->components(base, reading);
    if (components == nullptr) continue;
    const auto values = static_cast<double>(step_.plant().variables[reading.variable].values.size());
    bound.most /= values;
    for (const automata::ComponentId c : *components) bound.gains[c.index()] *= values;
    if (opening == nullptr) continue;
    if (std::find(components->begin(), components->end(), opening->component) != components->end()) continue;
    bound.gains[opening->component.index()] *= values;
  }
  return bound;
}

double ReadingEvidence::greatest_factor() const {
  double most = 1;
  for (const automata::Assignment& reading : observation_) {
    if (open_->may_be_implied(reading)) continue;
    most /= static_cast<double>(step_.plant().variables[reading.variable].values.size());
  }
  return most;
}

NearbyFactors ReadingEvidence::nearby_factors(const automata::Modes& base) const {
  const FactorBound bound = factor_bound(base, nullptr);
  NearbyFactors result{bound.most, {}};
  for (std::size_t c = 0; c < base.size(); ++c) {
    if (bound.gains[c] == 1) continue;
    const automata::ComponentId own(c);
    std::vector<double>& gains =
        result.gains.try_emplace(c, step_.plant()[own].modes.size(), bound.gains[c]).first->second;
    gains[base[c].index()] = 1;
    automata::Modes modes = base;
    for (const automata::Assignment& reading : observation_) {
      const std::vector<automata::ComponentId>* rests_on = open_->components(base, reading);
      if (rests_on == nullptr || std::find(rests_on->begin(), rests_on->end(), own) == rests_on->end()) continue;
      for (std::size_t m = 0; m < gains.size(); ++m) {
        modes[c] = automata::ModeId(m);
        if (modes[c] == base[c]) continue;
        const std::vector<automata::ComponentId>* still = open_->components(modes, reading);
        const bool by_itself =
            still != nullptr && std::all_of(still->begin(), still->end(), [&](auto d) { return d == own; });
        if (by_itself) gains[m] /= static_cast<double>(step_.plant().variables[reading.variable].values.size());
      }
    }
  }
  return result;
}

Extensions::Extensions(ReadingEvidence& evidence, const std::vector<std::vector<automata::Move>>& moves) {
  own_.reserve(moves.size());
  std::vector<const ComponentMoves*> all;
  all.reserve(moves.size());
  for (const auto& component : moves) all.push_back(&own_.emplace_back(component));
  restart(evidence, all);
}

void Extensions::restart(ReadingEvidence& evidence, const std::vector<const ComponentMoves*>& moves) {
  evidence_ = &evidence;
  moves_ = moves;
  found_.clear();
  best_ = 1;
  mass_ = 1;
  started_ = false;
  tight_ = looked_ = false;
  base_.clear();
  factors_ = {};
  openings_ = nullptr;
  offset_ = 0;
  for (const ComponentMoves* const component : moves_) best_ *= component->greatest();
}

void Extensions::start() {
  started_ = true;
  std::vector<const OptimalSearch::Domain*> domains;
  domains.reserve(moves_.size());
  for (const ComponentMoves* const component : moves_) domains.push_back(&component->domain());
  offset_ = 0;
  if (adjusts()) adjust(domains);
  search_.restart(domains, evidence_->conflicts());
}

/// Domains of their own for the components that may gain or lose. Where only what a component opens counts, all sources
/// share them.
void Extensions::adjust(std::vector<const OptimalSearch::Domain*>& domains) {
  adjusted_.clear();
  adjusted_.reserve(domains.size());
  offset_ = -std::log(factors_.most);
  std::vector<double> gains;
  for (std::size_t c = 0; c < domains.size(); ++c) {
    const bool near_base = factors_.gains[c] != 1;
    if (!near_base && !openings_->opens(c)) continue;
    if (near_base) {
      gains.assign(evidence_->modes_of(c), 1.0);
      for (std::size_t m = 0; m < gains.size(); ++m) gains[m] = gain(c, automata::ModeId(m));
    }
    const WeightedDomain& weighted =
        near_base ? adjusted_.emplace_back(*domains[c], gains) : moves_[c]->weighted(openings_->of(c));
    offset_ += weighted.least;
    domains[c] = &weighted.domain;
  }
}

void Extensions::look_at_factors() {
  if (looked_) return;
  looked_ = true;
  if (!evidence_->bounds_factors()) return;
  for (const ComponentMoves* const component : moves_) {
    if (component->domain().choices().empty()) return;
    base_.emplace_back(component->domain().choices().front().value);
  }
  factors_ = evidence_->factor_bound(base_);
  const OpeningFactors& openings = evidence_->opening_factors();
  if (factors_.most == 1 && openings.empty()) return;
  openings_ = &openings;
  mass_ = factors_.most;
  for (std::size_t c = 0; c < moves_.size(); ++c) {
    double all = 0;
    for (const OptimalSearch::PricedValue& choice : moves_[c]->domain().choices()) {
      all += promise(c, automata::ModeId(choice.value));
    }
    mass_ *= all;
  }
}

bool Extensions::tighten() {
  if (tight_) return adjusts();
  tight_ = true;
  look_at_factors();
  if (!adjusts()) return false;
  found_.clear();
  started_ = false;
  best_ = factors_.most;
  for (std::size_t c = 0; c < moves_.size(); ++c) {
    double greatest = 0;
    for (const OptimalSearch::PricedValue& choice : choices(c)) {
      greatest = std::max(greatest, promise(c, automata::ModeId(choice.value)));
    }
    best_ *= greatest;
  }
  return true;
}

double Extensions::mass() {
  look_at_factors();
  return mass_;
}

double Extensions::share(const automata::Modes& modes, double prior) const {
  if (!informed()) return prior;
  double share = prior * factors_.most;
  for (std::size_t c = 0; c < modes.size(); ++c) share *= gain(c, modes[c]);
  return share;
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
  found_.push_back({std::move(modes), probability, factor, adjusts() ? bound_of(search_.cost()) : probability});
}

double Extensions::bound(std::size_t i) const {
  if (!started_) return best_;
  return i < found_.size() ? found_[i].bound : bound_of(search_.bound());
}

double Extensions::bound_of(double cost) const { return std::exp(-(cost + offset_)); }

}  // namespace rmpl::runtime
