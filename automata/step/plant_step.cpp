// One step of a TCCA: the rules of semantics 3, in one place.
// SPDX-License-Identifier: MIT
#include "automata/step/plant_step.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "automata/step/model.hpp"

namespace automata {
namespace {

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

PlantStep::PlantStep(const Plant& plant) : plant_(plant), locality_(plant), theory_(model_theory(plant)) {
  for (const Component& component : plant.components) {
    auto& handles = guards_.emplace_back();
    std::vector<Support> supports(component.modes.size());
    for (const Transition& t : component.transitions) {
      handles.push_back(theory_.encode(t.guard));
      supports[t.from.index()].join(locality_.support_of(t.guard));
    }
    auto& parts = parts_.emplace_back();
    for (Support& support : supports) {
      Memory<Enabled> memory(plant, support);
      parts.push_back({std::move(support), std::move(memory)});
    }
  }
  for (const Locality::Island& island : locality_.islands()) {
    const Support modes{island.support.components, {}};
    if (island.constrained) constrained_.push_back(islands_.size());
    islands_.push_back({{plant, modes}, {plant, island.support}, {plant, modes}});
  }
}

std::vector<Assignment> PlantStep::assumptions(const Support& support, const Modes& modes,
                                               const ControlAction& action) const {
  std::vector<Assignment> result;
  for (const ComponentId c : support.components) {
    result.push_back({plant_[c].mode, ValueId(modes[c.index()].index())});
  }
  for (const std::size_t i : support.controls) result.push_back({plant_.controls[i].variable, action[i]});
  return result;
}

bool PlantStep::possible(const Modes& modes) {
  for (const std::size_t i : constrained_) {
    const Support support{locality_.islands()[i].support.components, {}};
    const auto ask = [&] { return theory_.consistent(assumptions(support, modes, {})); };
    if (!islands_[i].possible.find(modes, ControlAction{}, ask)) return false;
  }
  return true;
}

bool PlantStep::consistent(const Modes& modes, const ControlAction& action) {
  for (const std::size_t i : constrained_) {
    const Support& support = locality_.islands()[i].support;
    const auto ask = [&] { return theory_.consistent(assumptions(support, modes, action)); };
    if (!islands_[i].consistent.find(modes, action, ask)) return false;
  }
  return true;
}

template <class Test>
Enabled PlantStep::sort_out(ComponentId id, ModeId mode, const Test& test) const {
  const Component& component = plant_[id];
  Enabled result;
  for (std::size_t i = 0; i < component.transitions.size(); ++i) {
    const Transition& t = component.transitions[i];
    const bool weightless = t.weight.kind != Weight::Kind::none && !(t.weight.value > 0);
    if (t.from != mode || weightless || !test(i)) continue;
    auto& kind = component.is_fault(t) ? result.faults : t.timing ? result.timed : result.untimed;
    kind.emplace_back(i);
  }
  return result;
}

Enabled PlantStep::work_out(ComponentId id, const Modes& modes, const ControlAction& action) {
  const Component& component = plant_[id];
  const ModeId mode = modes[id.index()];
  const std::vector<Assignment> store = assumptions(support(id, mode), modes, action);
  // One model of the store refutes most guards that are not implied.
  [[maybe_unused]] const bool consistent = theory_.consistent(store);
  assert(consistent && "what contradicts itself enables everything");
  std::vector<bool> possible;
  for (const Transition& t : component.transitions) {
    possible.push_back(t.from == mode && evaluate(t.guard, [&](VariableId v) { return theory_.value(v); }));
  }
  return sort_out(id, mode, [&](std::size_t t) {
    return possible[t] && (component.transitions[t].guard.is_true() || theory_.entails(store, guards_[id.index()][t]));
  });
}

const Enabled& PlantStep::enabled(ComponentId component, const Modes& modes, const ControlAction& action) {
  return parts_[component.index()][modes[component.index()].index()].enabled.find(
      modes, action, [&] { return work_out(component, modes, action); });
}

const std::vector<Enabled>& PlantStep::enabled(const Modes& modes, const ControlAction& action) {
  const bool implies_all = !consistent(modes, action);
  answer_.resize(plant_.components.size());
  for (std::size_t c = 0; c < answer_.size(); ++c) {
    const ComponentId id(c);
    answer_[c] = implies_all ? sort_out(id, modes[c], [](std::size_t) { return true; }) : enabled(id, modes, action);
  }
  return answer_;
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

const PlantStep::Seen& PlantStep::see(std::size_t island, const Modes& modes, std::span<const Assignment> readings) {
  std::vector<std::uint64_t> words;
  for (const Assignment& a : readings) words.push_back(std::uint64_t{a.variable.value} << 32 | a.value.value);
  return islands_[island].seen.find(modes, words, [&] {
    const Support support{locality_.islands()[island].support.components, {}};
    const std::vector<Assignment> store = assumptions(support, modes, {});
    std::vector<Assignment> with = store;
    with.insert(with.end(), readings.begin(), readings.end());
    Seen answer{theory_.consistent(with), {}};
    for (const Assignment& a : readings) answer.entailed.push_back(answer.consistent && theory_.entails(store, a));
    return answer;
  });
}

double PlantStep::observation_factor(const Modes& modes, const Observation& observation) {
  if (!possible(modes)) return 0;
  std::vector<std::vector<Assignment>> by_island(islands_.size());
  for (const Assignment& reading : observation) {
    if (const auto island = locality_.island_of(reading.variable)) {
      by_island[*island].push_back(reading);
    } else if (modes[plant_.component_of(reading.variable)->index()].index() != reading.value.index()) {
      return 0;
    }
  }
  std::vector<bool> entailed(plant_.variables.size(), true);
  for (std::size_t i = 0; i < by_island.size(); ++i) {
    if (by_island[i].empty()) continue;
    const Seen& seen = see(i, modes, by_island[i]);
    if (!seen.consistent) return 0;
    for (std::size_t r = 0; r < by_island[i].size(); ++r) entailed[by_island[i][r].variable.index()] = seen.entailed[r];
  }
  double factor = 1;
  for (const Assignment& reading : observation) {
    if (!entailed[reading.variable.index()]) {
      factor /= static_cast<double>(plant_.variables[reading.variable].values.size());
    }
  }
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
