// One step of a TCCA: the rules of semantics 3, in one place.
// SPDX-License-Identifier: MIT
#include "automata/step/plant_step.hpp"

#include <algorithm>
#include <cmath>

#include "automata/step/model.hpp"

namespace automata {
namespace {

/// Beyond this many remembered answers a memory is emptied: long runs through ever new states stay flat.
constexpr std::size_t memory_limit = 1u << 16;

template <class Memory>
void bound_memory(Memory& memory) {
  if (memory.size() >= memory_limit) memory.clear();
}

std::size_t combine(std::size_t hash, std::size_t value) { return (hash ^ value) * 0x100000001b3u; }

/// The share of a nominal transition among those that take the nominal share together.
double share_weight(const Weight& weight) { return weight.kind == Weight::Kind::none ? 1.0 : weight.value; }

/// Adds up probabilities by target mode, in order of mode.
class Moves {
 public:
  explicit Moves(std::size_t modes) : by_mode_(modes, 0.0) {}
  void add(ModeId mode, double probability) { by_mode_[mode.index()] += probability; }
  [[nodiscard]] std::vector<Move> positive() const {
    std::vector<Move> moves;
    for (std::size_t m = 0; m < by_mode_.size(); ++m) {
      if (by_mode_[m] > 0) moves.push_back({ModeId(m), by_mode_[m]});
    }
    return moves;
  }

 private:
  std::vector<double> by_mode_;
};

}  // namespace

std::size_t PlantStep::StateActionHash::operator()(const StateAction& key) const noexcept {
  std::size_t hash = ModesHash{}(key.modes);
  for (const ValueId value : key.action) hash = combine(hash, value.value);
  return hash;
}

std::size_t PlantStep::StateObservationHash::operator()(const StateObservation& key) const noexcept {
  std::size_t hash = ModesHash{}(key.modes);
  for (const Assignment& a : key.observation) hash = combine(combine(hash, a.variable.value), a.value.value);
  return hash;
}

PlantStep::PlantStep(const Plant& plant) : plant_(plant), theory_(model_theory(plant)) {
  for (const Component& component : plant.components) {
    auto& handles = guards_.emplace_back();
    for (const Transition& t : component.transitions) handles.push_back(theory_.encode(t.guard));
  }
}

bool PlantStep::possible(const Modes& modes) {
  if (const auto known = possible_.find(modes); known != possible_.end()) return known->second;
  bound_memory(possible_);
  const bool answer = theory_.consistent(assignments_of(plant_, modes));
  possible_.emplace(modes, answer);
  return answer;
}

const std::vector<Enabled>& PlantStep::enabled(const Modes& modes, const ControlAction& action) {
  StateAction key{modes, action};
  if (const auto known = enabled_.find(key); known != enabled_.end()) return known->second;
  bound_memory(enabled_);

  std::vector<Assignment> known = assignments_of(plant_, modes);
  const std::vector<Assignment> controls = assignments_of(plant_, action);
  known.insert(known.end(), controls.begin(), controls.end());
  // A store that contradicts the control action implies every guard. Else one model of it refutes most guards that are
  // not implied, and a guard over control variables alone (the most common kind) is decided by it.
  const bool consistent = theory_.consistent(known);
  std::vector<std::vector<bool>> possible(plant_.components.size());
  for (std::size_t c = 0; c < possible.size(); ++c) {
    for (const Transition& t : plant_.components[c].transitions) {
      const bool asked = consistent && t.from == modes[c];
      possible[c].push_back(!asked || evaluate(t.guard, [&](VariableId id) { return theory_.value(id); }));
    }
  }
  const auto decided_by_controls = [&](const Formula& guard) {
    const auto reads = variables_of(guard);
    return std::all_of(reads.begin(), reads.end(), [&](VariableId id) {
      return std::any_of(controls.begin(), controls.end(), [&](const Assignment& a) { return a.variable == id; });
    });
  };

  std::vector<Enabled> answer(plant_.components.size());
  for (std::size_t c = 0; c < answer.size(); ++c) {
    const Component& component = plant_.components[c];
    for (std::size_t i = 0; i < component.transitions.size(); ++i) {
      const Transition& t = component.transitions[i];
      const bool weightless = t.weight.kind != Weight::Kind::none && !(t.weight.value > 0);
      if (t.from != modes[c] || weightless || !possible[c][i]) continue;
      if (consistent && !decided_by_controls(t.guard) && !theory_.entails(known, guards_[c][i])) continue;
      auto& kind = component.is_fault(t) ? answer[c].faults : t.timing ? answer[c].timed : answer[c].untimed;
      kind.emplace_back(i);
    }
  }
  return enabled_.emplace(std::move(key), std::move(answer)).first->second;
}

std::vector<Move> PlantStep::moves(ComponentId id, ModeId mode, const Enabled& enabled, Ticks clock_start, Ticks before,
                                   Ticks now) const {
  const Component& component = plant_[id];
  const auto transition = [&](TransitionId t) -> const Transition& { return component.transitions[t.index()]; };
  const Ticks from = before - clock_start;
  const Ticks to = now - clock_start;
  Moves result(component.modes.size());

  double faulty = 0;
  for (const TransitionId t : enabled.faults) {
    const auto& timing = transition(t).timing;
    if (timing && (to < timing->lower || to > timing->upper)) continue;
    const double probability = transition(t).weight.fault_probability(now - before);
    faulty += probability;
    result.add(transition(t).to, probability);
  }
  const double nominal = std::max(0.0, 1.0 - faulty);

  // Untimed nominal transitions leave nothing to wait for.
  if (!enabled.untimed.empty()) {
    double total = 0;
    for (const TransitionId t : enabled.untimed) total += share_weight(transition(t).weight);
    for (const TransitionId t : enabled.untimed) {
      result.add(transition(t).to, nominal * share_weight(transition(t).weight) / total);
    }
    return result.positive();
  }

  // Timed ones compete as independent risks; the members of one branch are one risk, shared by their weights.
  struct Risk {
    std::uint32_t branch;
    double hazard;
    double weight;
  };
  std::vector<Risk> risks;
  for (const TransitionId t : enabled.timed) {
    const double weight = share_weight(transition(t).weight);
    const auto known =
        std::find_if(risks.begin(), risks.end(), [&](const Risk& r) { return r.branch == transition(t).branch; });
    if (known != risks.end()) {
      known->weight += weight;
    } else {
      risks.push_back({transition(t).branch, transition(t).timing->step_hazard(from, to), weight});
    }
  }
  double total = 0;
  std::size_t certain = 0;
  for (const Risk& risk : risks) {
    if (std::isinf(risk.hazard)) {
      ++certain;
    } else {
      total += risk.hazard;
    }
  }
  const double fires = certain > 0 ? 1.0 : -std::expm1(-total);
  for (const TransitionId t : enabled.timed) {
    const auto risk =
        std::find_if(risks.begin(), risks.end(), [&](const Risk& r) { return r.branch == transition(t).branch; });
    double share = 0;
    if (certain > 0) {
      share = std::isinf(risk->hazard) ? 1.0 / static_cast<double>(certain) : 0.0;
    } else if (total > 0) {
      share = risk->hazard / total;
    }
    result.add(transition(t).to, nominal * fires * share * share_weight(transition(t).weight) / risk->weight);
  }
  if (certain == 0) result.add(mode, nominal * std::exp(-total));
  return result.positive();
}

std::vector<std::vector<Move>> PlantStep::moves(const SystemState& state, const ControlAction& action, Ticks before,
                                                Ticks now) {
  const auto& allowed = enabled(state.modes, action);
  std::vector<std::vector<Move>> all;
  all.reserve(allowed.size());
  for (std::size_t c = 0; c < allowed.size(); ++c) {
    all.push_back(moves(ComponentId(c), state.modes[c], allowed[c], state.clock_starts[c], before, now));
  }
  return all;
}

double PlantStep::probability(const SystemState& state, const ControlAction& action, Ticks before, Ticks now,
                              const Modes& next) {
  double product = 1;
  const auto all = moves(state, action, before, now);
  for (std::size_t c = 0; c < all.size() && product > 0; ++c) {
    const auto at = std::find_if(all[c].begin(), all[c].end(), [&](const Move& m) { return m.mode == next[c]; });
    product *= at == all[c].end() ? 0.0 : at->probability;
  }
  return product;
}

SystemState PlantStep::advance(const SystemState& state, const Modes& next, Ticks now) {
  SystemState result{next, state.clock_starts};
  for (std::size_t c = 0; c < next.size(); ++c) {
    if (next[c] != state.modes[c]) result.clock_starts[c] = now;
  }
  return result;
}

double PlantStep::observation_factor(const Modes& modes, const Observation& observation) {
  StateObservation key{modes, observation};
  if (const auto known = factors_.find(key); known != factors_.end()) return known->second;
  bound_memory(factors_);
  std::vector<Assignment> store = assignments_of(plant_, modes);
  std::vector<Assignment> seen = store;
  seen.insert(seen.end(), observation.begin(), observation.end());
  double factor = theory_.consistent(seen) ? 1.0 : 0.0;
  if (factor > 0) {
    for (const Assignment& reading : observation) {
      if (!theory_.entails(store, reading)) {
        factor /= static_cast<double>(plant_.variables[reading.variable].values.size());
      }
    }
  }
  factors_.emplace(std::move(key), factor);
  return factor;
}

bool PlantStep::explains(const Modes& modes, const Observation& observation) {
  return observation_factor(modes, observation) > 0;
}

std::vector<std::vector<Move>> PlantStep::initial_moves() const {
  std::vector<std::vector<Move>> all;
  for (const Component& component : plant_.components) {
    auto& moves = all.emplace_back();
    for (std::size_t m = 0; m < component.initial.size(); ++m) {
      if (component.initial[m] > 0) moves.push_back({ModeId(m), component.initial[m]});
    }
  }
  return all;
}

}  // namespace automata
