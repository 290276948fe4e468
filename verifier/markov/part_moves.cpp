// What a part of a plant may come to.
// SPDX-License-Identifier: MIT
#include "verifier/markov/part_moves.hpp"

#include <algorithm>
#include <utility>

#include "verifier/markov/draws.hpp"

namespace rmpl::verifier {

using automata::Modes;

namespace {

/// Modes of all components together, modes that are met, control actions of one state, and outcomes in all, beyond
/// which nothing is told.
constexpr std::size_t most_mode_products = std::size_t{1} << 14;
constexpr std::size_t most_modes = 4096;
constexpr std::size_t most_actions = 256;
constexpr std::size_t most_outcomes = std::size_t{1} << 19;

std::size_t actions_of(const automata::Plant& plant) {
  std::size_t result = 1;
  for (const automata::Control& control : plant.controls) {
    result = std::min(result * plant.variables[control.variable].values.size(), most_actions + 1);
  }
  return result;
}

double reward_of(const automata::Plant& plant, const Modes& modes) {
  double result = 0;
  for (std::size_t c = 0; c < modes.size(); ++c) {
    result += plant.components[c].modes[modes[c].index()].reward;
  }
  return result;
}

}  // namespace

PartMoves::PartMoves(Cone cone, Part part, automata::Ticks period)
    : cone_(std::move(cone)), part_(std::move(part)), step_(part_.plant()), period_(period) {}

bool PartMoves::is_too_large() const {
  std::size_t combinations = 1;
  for (const automata::Component& component : plant().components) {
    combinations = std::min(combinations * component.modes.size(), most_mode_products + 1);
  }
  return combinations > most_mode_products;
}

void PartMoves::end_in(const automata::Formula& target, bool entailed) {
  target_ = step_.theory().encode(part_.into(target));
  entailed_ = entailed;
}

PartMoves::Number PartMoves::enter(const Modes& modes) {
  const auto [at, fresh] = numbers_.try_emplace(modes, static_cast<Number>(states_.size()));
  if (fresh) {
    State state;
    state.modes = modes;
    state.reward = reward_of(plant(), modes);
    if (target_) {
      const auto store = automata::assignments_of(plant(), modes);
      state.end = entailed_ ? step_.theory().entails(store, *target_) : step_.theory().allows(store, *target_);
    }
    states_.push_back(std::move(state));
  }
  return at->second;
}

PartMoves::Number PartMoves::number(const Modes& whole) {
  Modes modes;
  modes.reserve(cone_.size());
  for (const automata::ComponentId c : cone_) modes.push_back(whole[c.index()]);
  return enter(modes);
}

void PartMoves::assign(Number number, Modes& whole) const {
  const Modes& modes = states_[number].modes;
  for (std::size_t i = 0; i < cone_.size(); ++i) whole[cone_[i].index()] = modes[i];
}

/// Adds what may follow there; false where that is not known.
bool PartMoves::draw(Number from, const automata::AllEnabled& enabled, Steps& steps, Meter& meter) {
  const std::vector<Draws> extremes = StepDraws(step_, states_[from].modes, enabled, period_).extremes(meter);
  for (const Draws& draws : extremes) {
    outcomes_ += draws.outcomes.size();
    if (draws.outcomes.empty() || draws.left_out > 0 || outcomes_ > most_outcomes) return false;
    Enclosure hit;
    for (const Draw& outcome : draws.outcomes) {
      const Number to = enter(outcome.modes);
      if (states_[to].end) hit = hit + outcome.probability;
      steps.to.emplace_back(to, outcome.faults == 0);
    }
    steps.hit = {std::min(steps.hit.lower, hit.lower), std::max(steps.hit.upper, hit.upper)};
  }
  return !extremes.empty() && states_.size() <= most_modes;
}

PartMoves::Steps PartMoves::work_out(Number from, Commands commands, Meter& meter) {
  Steps result;
  if (commands == Commands::any && actions_of(plant()) > most_actions) return result;
  bool known = true;
  bool first = true;
  for_each_action(plant(), commands, [&](const automata::ControlAction& action) {
    const bool idle = std::exchange(first, false);
    if (!known) return;
    meter.poll();
    const automata::AllEnabled* enabled = step_.enabled_if_permitted(states_[from].modes, action);
    if (enabled == nullptr) {
      known = !idle;
    } else {
      const automata::AllEnabled here = *enabled;
      known = draw(from, here, result, meter);
    }
  });
  // Of two ways there the one without faults is first.
  std::sort(result.to.begin(), result.to.end(),
            [](const auto& a, const auto& b) { return a.first != b.first ? a.first < b.first : a.second > b.second; });
  const auto same = [](const auto& a, const auto& b) { return a.first == b.first; };
  result.to.erase(std::unique(result.to.begin(), result.to.end(), same), result.to.end());
  result.known = known;
  return result;
}

const PartMoves::Steps& PartMoves::steps(Number from, Commands commands, Meter& meter) {
  const auto known = [&]() -> std::optional<Steps>& {
    return commands == Commands::none ? states_[from].idle : states_[from].any;
  };
  if (!known()) {
    Steps worked = work_out(from, commands, meter);  // which may enter states
    known() = std::move(worked);
  }
  return *known();
}

/// Visits what may be reached; false where that is not known.
template <class Visit>
bool PartMoves::search(Number from, Commands commands, Along along, To to, Meter& meter, const Visit& visit) {
  std::vector<bool> seen(states_.size(), false);
  std::vector<Number> open{from};
  const auto meet = [&](Number at) {
    if (at >= seen.size()) seen.resize(states_.size(), false);
    if (!seen[at]) open.push_back(at);
    seen[at] = true;
  };
  seen[from] = true;
  while (!open.empty()) {
    const Number at = open.back();
    open.pop_back();
    visit(at);
    if (states_[at].end && to == To::end) continue;
    const Steps& next = steps(at, commands, meter);
    if (!next.known) return false;
    for (const auto& [there, without_fault] : next.to) {
      if (along == Along::every_step || without_fault) meet(there);
    }
  }
  return true;
}

const PartMoves::Reach* PartMoves::reach(Number from, Commands commands, Meter& meter) {
  const auto known = [&]() -> std::optional<const Reach*>& {
    return commands == Commands::none ? states_[from].reach_idle : states_[from].reach_any;
  };
  if (known()) return *known();
  auto found = std::make_unique<Reach>();
  const bool complete =
      search(from, commands, Along::every_step, To::end, meter, [&](Number at) { found->push_back(at); });
  known() = keep(std::move(found), complete);
  return *known();
}

const PartMoves::Reach* PartMoves::reach_past_end(Number from, Meter& meter) {
  if (states_[from].reach_past_end) return *states_[from].reach_past_end;
  auto found = std::make_unique<Reach>();
  const bool complete =
      search(from, Commands::any, Along::every_step, To::everywhere, meter, [&](Number at) { found->push_back(at); });
  states_[from].reach_past_end = keep(std::move(found), complete);
  return *states_[from].reach_past_end;
}

/// Null where it is not complete.
const PartMoves::Reach* PartMoves::keep(std::unique_ptr<Reach> found, bool complete) {
  if (!complete) return nullptr;
  std::sort(found->begin(), found->end());
  reaches_.push_back(std::move(found));
  return reaches_.back().get();
}

const PartMoves::Reach* PartMoves::undecided(const Reach& reach, Meter& meter) {
  if (const auto known = undecided_.find(&reach); known != undecided_.end()) return known->second;
  auto found = std::make_unique<Reach>();
  const Reach* result = found.get();
  for (const Number at : reach) {
    if (states_[at].end) continue;
    const Reach* const next = this->reach(at, Commands::any, meter);
    if (next == nullptr) result = nullptr;
    if (result == nullptr) break;
    if (std::any_of(next->begin(), next->end(), [&](Number to) { return states_[to].end; })) found->push_back(at);
  }
  reaches_.push_back(std::move(found));
  undecided_.emplace(&reach, result);
  return result;
}

bool PartMoves::gains_at(Number from, Meter& meter) {
  double least = states_[from].reward;
  double greatest = least;
  const auto nominal = [&](Commands commands, const auto& visit) {
    return search(from, commands, Along::nominal_steps, To::everywhere, meter, visit);
  };
  const bool at_rest = nominal(Commands::none, [&](Number at) { least = std::min(least, states_[at].reward); });
  const bool commanded = nominal(Commands::any, [&](Number at) { greatest = std::max(greatest, states_[at].reward); });
  return !at_rest || !commanded || greatest > least;
}

bool PartMoves::gains(const Reach& reach, Meter& meter) {
  return std::any_of(reach.begin(), reach.end(), [&](Number at) {
    if (!states_[at].gains) {
      const bool gains = gains_at(at, meter);
      states_[at].gains = gains;
    }
    return *states_[at].gains;
  });
}

Enclosure PartMoves::hazard(const Reach& reach, Commands commands) const {
  Enclosure result{1, 0};
  for (const Number at : reach) {
    if (states_[at].end) continue;
    const std::optional<Steps>& steps = commands == Commands::none ? states_[at].idle : states_[at].any;
    result = {std::min(result.lower, steps->hit.lower), std::max(result.upper, steps->hit.upper)};
  }
  return as_probability(result);
}

}  // namespace rmpl::verifier
