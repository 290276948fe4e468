// One step of a TCCA: the rules of semantics 3, in one place.
// SPDX-License-Identifier: MIT
#include "automata/step/plant_step.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "automata/step/model.hpp"

namespace automata {
namespace {

/// How many whole states are remembered: so many that their modes, all together, are no more than this.
std::size_t states_remembered(const Plant& plant) {
  constexpr std::size_t modes_remembered = 1u << 16;
  return modes_remembered / (plant.components.size() + 1) + 1;
}

std::size_t combine(std::size_t hash, std::size_t value) { return (hash ^ value) * 0x100000001b3u; }

/// The share of a nominal transition among those that take the nominal share together.
double share_weight(const Weight& weight) { return weight.kind == Weight::Kind::none ? 1.0 : weight.value; }

/// The list of enabled transitions that one belongs to.
std::vector<TransitionId>& kind_of(Enabled& enabled, const Component& component, TransitionId id) {
  const Transition& t = component.transitions[id.index()];
  return component.is_fault(t) ? enabled.faults : t.timing ? enabled.timed : enabled.untimed;
}

/// Adds up probabilities by target mode, in order of mode.
class Moves {
 public:
  void add(ModeId mode, double probability) {
    const auto at = std::lower_bound(moves_.begin(), moves_.end(), mode,
                                     [](const Move& move, ModeId other) { return move.mode < other; });
    if (at != moves_.end() && at->mode == mode) {
      at->probability += probability;
    } else {
      moves_.insert(at, {mode, probability});
    }
  }
  [[nodiscard]] std::vector<Move> positive() {
    std::erase_if(moves_, [](const Move& move) { return !(move.probability > 0); });
    return std::move(moves_);
  }

 private:
  std::vector<Move> moves_;
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

PlantStep::PlantStep(const Plant& plant)
    : plant_(plant),
      locality_(plant),
      theory_(model_theory(plant)),
      enabled_(states_remembered(plant)),
      factors_(states_remembered(plant)) {
  for (const Component& component : plant.components) {
    auto& handles = guards_.emplace_back();
    auto& exits = exits_.emplace_back(component.modes.size());
    std::vector<Support> supports(component.modes.size());
    for (const Transition& t : component.transitions) {
      handles.push_back(theory_.encode(t.guard));
      const bool weightless = t.weight.kind != Weight::Kind::none && !(t.weight.value > 0);
      if (!weightless) exits[t.from.index()].push_back({TransitionId(handles.size() - 1), handles.back()});
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
    islands_.push_back({{plant, modes}, {plant, island.support}});
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

std::vector<Assignment> PlantStep::conflict(const Modes& modes) {
  for (const std::size_t i : constrained_) {
    const Support support{locality_.islands()[i].support.components, {}};
    if (!theory_.consistent(assumptions(support, modes, {}))) return theory_.minimal_conflict(theory_.conflict());
  }
  assert(false && "possible modes are in no conflict");
  return {};
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
    kind_of(result, component, TransitionId(i)).emplace_back(i);
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
    possible.push_back(t.from == mode && theory_.holds(guards_[id.index()][possible.size()]));
  }
  return sort_out(id, mode, [&](std::size_t t) {
    return possible[t] && (component.transitions[t].guard.is_true() || theory_.entails(store, guards_[id.index()][t]));
  });
}

const Enabled& PlantStep::enabled(ComponentId component, const Modes& modes, const ControlAction& action) {
  return parts_[component.index()][modes[component.index()].index()].enabled.find(
      modes, action, [&] { return work_out(component, modes, action); });
}

/// One model of the store refutes most guards that are not implied, and propagation proves most that are: few are asked
/// one by one.
PlantStep::Whole PlantStep::work_out(const Modes& modes, const ControlAction& action) {
  std::vector<Assignment> store = assignments_of(plant_, modes);
  const std::vector<Assignment> controls = assignments_of(plant_, action);
  store.insert(store.end(), controls.begin(), controls.end());
  enum class Verdict : std::uint8_t { refuted, implied, open };
  std::vector<Verdict> verdicts;
  const bool consistent = theory_.consistent(store);
  for (std::size_t c = 0; c < modes.size(); ++c) {
    for (const Exit& exit : exits_[c][modes[c].index()]) {
      if (!consistent) {
        verdicts.push_back(Verdict::implied);
      } else if (!theory_.holds(exit.guard)) {
        verdicts.push_back(Verdict::refuted);
      } else {
        verdicts.push_back(theory_.known_to_follow(exit.guard) ? Verdict::implied : Verdict::open);
      }
    }
  }
  std::vector<Enabled> answer(modes.size());
  auto verdict = verdicts.begin();
  for (std::size_t c = 0; c < modes.size(); ++c) {
    for (const Exit& exit : exits_[c][modes[c].index()]) {
      const Verdict given = *verdict++;
      if (given == Verdict::refuted || (given == Verdict::open && !theory_.entails(store, exit.guard))) continue;
      kind_of(answer[c], plant_.components[c], exit.transition).push_back(exit.transition);
    }
  }
  return {consistent, std::move(answer)};
}

const PlantStep::Whole& PlantStep::whole(const Modes& modes, const ControlAction& action) {
  asked_.modes = modes;
  asked_.action = action;
  if (const Whole* known = enabled_.find(asked_)) return *known;
  return enabled_.add(asked_, work_out(modes, action));
}

const std::vector<Enabled>& PlantStep::enabled(const Modes& modes, const ControlAction& action) {
  return whole(modes, action).enabled;
}

bool PlantStep::permits(const Modes& modes, const ControlAction& action) { return whole(modes, action).consistent; }

std::vector<Move> PlantStep::moves(ComponentId id, ModeId mode, const Enabled& enabled, Ticks clock_start, Ticks before,
                                   Ticks now) const {
  const Component& component = plant_[id];
  const auto transition = [&](TransitionId t) -> const Transition& { return component.transitions[t.index()]; };
  const Ticks from = before - clock_start;
  const Ticks to = now - clock_start;
  Moves result;

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

/// A reading that the store entails cannot contradict it; readings are assumed together only where some is open.
double PlantStep::work_out(const Modes& modes, const Observation& observation) {
  std::vector<Assignment> store = assignments_of(plant_, modes);
  if (!theory_.consistent(store)) return 0;
  std::vector<Assignment> open;
  for (const Assignment& reading : observation) {
    if (!theory_.known_to_follow(reading)) open.push_back(reading);
  }
  double factor = 1;
  bool contingent = false;
  for (const Assignment& reading : open) {
    if (theory_.entails(store, reading)) continue;
    contingent = true;
    factor /= static_cast<double>(plant_.variables[reading.variable].values.size());
  }
  if (!contingent) return factor;
  store.insert(store.end(), observation.begin(), observation.end());
  return theory_.consistent(store) ? factor : 0.0;
}

double PlantStep::observation_factor(const Modes& modes, const Observation& observation) {
  seen_.modes = modes;
  seen_.observation = observation;
  if (const double* known = factors_.find(seen_)) return *known;
  return factors_.add(seen_, work_out(modes, observation));
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
