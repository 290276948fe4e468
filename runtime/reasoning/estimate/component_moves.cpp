// The moves of components.
// SPDX-License-Identifier: MIT
#include "runtime/reasoning/estimate/component_moves.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "runtime/reasoning/estimate/rank.hpp"

namespace rmpl::runtime {
namespace {

std::vector<double> priors_of(const std::vector<automata::Move>& moves) {
  std::vector<double> priors(moves.empty() ? 0 : moves.back().mode.index() + 1, 0.0);
  for (const automata::Move& move : moves) priors[move.mode.index()] = move.probability;
  return priors;
}

std::vector<double> costs_of(const std::vector<double>& priors) {
  std::vector<double> costs;
  costs.reserve(priors.size());
  // A rounded probability may exceed 1 in the last bit.
  for (const double prior : priors) costs.push_back(std::max(0.0, -std::log(prior)));
  return costs;
}

std::vector<double> weighted_costs(const OptimalSearch::Domain& by_prior, std::span<const double> factors) {
  std::vector<double> costs(factors.size(), std::numeric_limits<double>::infinity());
  for (const OptimalSearch::PricedValue& choice : by_prior.choices()) {
    const double factor = factors[choice.value];
    costs[choice.value] = choice.cost - (factor == 1 ? 0.0 : std::log(factor));
  }
  return costs;
}

std::vector<double> less(std::vector<double> costs, double least) {
  for (double& cost : costs) cost -= least;
  return costs;
}

}  // namespace

WeightedDomain::WeightedDomain(const OptimalSearch::Domain& by_prior, std::span<const double> mode_factors)
    : factors(mode_factors.begin(), mode_factors.end()),
      least(std::ranges::min(weighted_costs(by_prior, mode_factors))),
      domain(less(weighted_costs(by_prior, mode_factors), least)) {}

const WeightedDomain& ComponentMoves::weighted(std::span<const double> factors) const {
  for (const auto& known : weighted_) {
    if (std::equal(factors.begin(), factors.end(), known->factors.begin(), known->factors.end())) return *known;
  }
  return *weighted_.emplace_back(std::make_unique<const WeightedDomain>(domain(), factors));
}

ComponentMoves::ComponentMoves(const std::vector<automata::Move>& moves) : moves_(moves), priors_(priors_of(moves)) {
  for (const double prior : priors_) greatest_ = std::max(greatest_, prior);
}

const OptimalSearch::Domain& ComponentMoves::domain() const {
  if (!domain_) domain_.emplace(costs_of(priors_));
  return *domain_;
}

std::size_t MoveTable::KeyHash::operator()(const Key& key) const noexcept {
  std::size_t hash = std::hash<const void*>{}(key.enabled);
  hash = (hash ^ static_cast<std::size_t>(key.clock)) * 0x9e3779b97f4a7c15u;
  hash = (hash ^ static_cast<std::size_t>(key.step)) * 0x9e3779b97f4a7c15u;
  return hash ^ (hash >> 32);
}

void MoveTable::look_up(automata::PlantStep& step, const automata::Modes& modes,
                        std::span<const automata::Ticks> clock_starts, const automata::ControlAction& action,
                        automata::Ticks before, automata::Ticks now, Passing& passing, Moves& moves) {
  enabled_ = step.enabled(modes, action);
  modes_ = modes;
  moves.clear();
  timed_.clear();
  constexpr int let_go = 4;
  for (int i = 0; i < let_go && !retired_.empty(); ++i) retired_.erase(retired_.begin());
  for (std::size_t c = 0; c < enabled_.size(); ++c) {
    const bool timed = automata::clock_matters(plant_.components[c], enabled_[c]);
    if (timed) timed_.push_back(c);
    moves.push_back(entry(step, timed ? passing : lasting_, c, clock_starts[c], timed, before, now));
  }
}

const ComponentMoves* MoveTable::look_up_timed(automata::PlantStep& step, std::size_t component,
                                               automata::Ticks clock_start, automata::Ticks before,
                                               automata::Ticks now) {
  return entry(step, passing_, component, clock_start, true, before, now);
}

const ComponentMoves* MoveTable::entry(automata::PlantStep& step, Table& table, std::size_t component,
                                       automata::Ticks clock_start, bool timed, automata::Ticks before,
                                       automata::Ticks now) {
  const automata::Enabled& enabled = enabled_[component];
  const Key key{&enabled, timed ? (now - clock_start).count : 0, (now - before).count};
  auto at = table.find(key);
  if (at == table.end()) {
    auto own = step.moves(automata::ComponentId(component), modes_[component], enabled, clock_start, before, now);
    if (ranks_) rank(own);
    at = table.try_emplace(key, own).first;
  }
  return &at->second;
}

}  // namespace rmpl::runtime
