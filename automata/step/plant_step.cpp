// One step of a TCCA: the rules of semantics 3, in one place.
// SPDX-License-Identifier: MIT
#include "automata/step/plant_step.hpp"

#include <algorithm>
#include <cassert>
#include <numeric>

#include "automata/step/transition_rules.hpp"
#include "automata/store/model.hpp"

namespace rmpl::automata {
namespace {

/// How many whole states are remembered: so many that their modes, all together, are no more than this.
std::size_t states_remembered(const Plant& plant) {
  constexpr std::size_t modes_remembered = 1u << 16;
  return modes_remembered / (plant.components.size() + 1) + 1;
}

std::size_t combine(std::size_t hash, std::size_t value) { return (hash ^ value) * 0x100000001b3u; }

}  // namespace

std::size_t PlantStep::StateActionHash::operator()(const StateAction& key) const noexcept {
  std::size_t hash = ModesHash{}(key.modes);
  for (const ValueId value : key.action) hash = combine(hash, value.value);
  return hash;
}

PlantStep::PlantStep(const Plant& plant)
    : plant_(plant),
      locality_(plant),
      theory_(model_theory(plant)),
      possible_(plant.components.size(), 0),
      consistent_(plant.components.size(), plant.controls.size()),
      enabled_(plant.components.size(), plant.controls.size()),
      wholes_(states_remembered(plant)),
      factors_(plant.components.size(), 0) {
  for (const Locality::Island& island : locality_.islands()) {
    islands_.emplace_back(plant, island);
    if (!islands_.back().excludes()) continue;
    constrained_.push_back(islands_.size() - 1);
    possible_.add({island.support.components, {}});
    consistent_.add(island.support);
  }
  for (std::size_t c = 0; c < plant.components.size(); ++c) {
    const Component& component = plant.components[c];
    auto& handles = guards_.emplace_back();
    auto& exits = exits_.emplace_back(component.modes.size());
    auto& supports = supports_.emplace_back(component.modes.size());
    Support all{{ComponentId(c)}, {}};
    for (const Transition& t : component.transitions) {
      handles.push_back(theory_.encode(t.guard));
      const Support support = locality_.support_of(t.guard);
      supports[t.from.index()].join(support);
      all.join(support);
      if (!can_ever_be_taken(t)) continue;
      Exit& exit = exits[t.from.index()].all.emplace_back();
      exit.transition = TransitionId(handles.size() - 1);
      for (const Formula& conjunct : conjuncts_of(t.guard)) {
        if (!conjunct.is_true()) exit.parts.push_back(part(conjunct));
      }
    }
    enabled_.add(all);
  }
  for (IslandStore& island : islands_) island.prepare();
}

PlantStep::Part PlantStep::part(const Formula& conjunct) {
  const std::vector<VariableId> variables = variables_of(conjunct);
  const auto home = variables.empty() ? std::nullopt : locality_.island_of(variables.front());
  const bool local = home && std::all_of(variables.begin(), variables.end(),
                                         [&](VariableId v) { return locality_.island_of(v) == home; });
  if (local) return {*home, islands_[*home].watch(conjunct)};
  Support support = locality_.support_of(conjunct);
  Memory<bool> memory(plant_, support);
  wide_.push_back({theory_.encode(conjunct), std::move(support), std::move(memory)});
  return {no_island, wide_.size() - 1};
}

bool PlantStep::possible(const Modes& modes) {
  possible_.ask(modes, {});
  for (std::size_t i = 0; i < constrained_.size(); ++i) {
    auto& answer = possible_[i];
    if (!answer) answer = islands_[constrained_[i]].possible(modes);
    if (!*answer) return false;
  }
  return true;
}

std::vector<ComponentId> PlantStep::conflict(const Modes& modes) {
  const auto at = std::find_if(constrained_.begin(), constrained_.end(),
                               [&](std::size_t island) { return !islands_[island].possible(modes); });
  assert(at != constrained_.end() && "possible modes are in no conflict");
  return islands_[*at].conflict(modes);
}

bool PlantStep::consistent(const Modes& modes, const ControlAction& action) {
  consistent_.ask(modes, action);
  for (std::size_t i = 0; i < constrained_.size(); ++i) {
    auto& answer = consistent_[i];
    if (!answer) answer = islands_[constrained_[i]].verdicts(modes, action).consistent;
    if (!*answer) return false;
  }
  return true;
}

bool PlantStep::implied(Wide& wide, const Modes& modes, const ControlAction& action) {
  return wide.implied.find(modes, action, [&] {
    std::vector<Assignment> store;
    for (const ComponentId c : wide.support.components) {
      store.push_back({plant_[c].mode, ValueId(modes[c.index()].index())});
    }
    for (const std::size_t i : wide.support.controls) store.push_back({plant_.controls[i].variable, action[i]});
    return theory_.entails(store, wide.formula);
  });
}

/// The set of those exits all of whose parts are implied.
template <class Implied>
const Enabled& PlantStep::sort_out(ComponentId id, ModeId mode, const Implied& implied) {
  Exits& exits = exits_[id.index()][mode.index()];
  found_.assign((exits.all.size() + 63) / 64, 0);
  for (std::size_t i = 0; i < exits.all.size(); ++i) {
    const auto& parts = exits.all[i].parts;
    if (std::all_of(parts.begin(), parts.end(), implied)) found_[i / 64] |= std::uint64_t{1} << (i % 64);
  }
  const auto [at, fresh] = exits.sets.try_emplace(found_);
  for (std::size_t i = 0; fresh && i < exits.all.size(); ++i) {
    if ((found_[i / 64] >> (i % 64) & 1) == 0) continue;
    const TransitionId transition = exits.all[i].transition;
    add_enabled(at->second, plant_[id], transition);
  }
  return at->second;
}

const Enabled& PlantStep::enabled(ComponentId component, const Modes& modes, const ControlAction& action) {
  return sort_out(component, modes[component.index()], [&](const Part& part) {
    if (part.island == no_island) return implied(wide_[part.number], modes, action);
    IslandStore& island = islands_[part.island];
    return island.implies(part.number, island.verdicts(modes, action), modes, action);
  });
}

PlantStep::Whole PlantStep::work_out(const Modes& modes, const ControlAction& action) {
  Whole result{consistent(modes, action), {}};
  result.enabled.sets_.reserve(modes.size());
  if (!result.consistent) {
    for (std::size_t c = 0; c < modes.size(); ++c) {
      result.enabled.sets_.push_back(&sort_out(ComponentId(c), modes[c], [](const Part&) { return true; }));
    }
    return result;
  }
  verdicts_.assign(islands_.size(), nullptr);
  const auto holds = [&](const Part& part) {
    if (part.island == no_island) return implied(wide_[part.number], modes, action);
    IslandStore& island = islands_[part.island];
    auto& verdicts = verdicts_[part.island];
    if (verdicts == nullptr) verdicts = &island.verdicts(modes, action);
    return island.implies(part.number, *verdicts, modes, action);
  };
  enabled_.ask(modes, action);
  for (std::size_t c = 0; c < modes.size(); ++c) {
    auto& answer = enabled_[c];
    if (!answer) answer = &sort_out(ComponentId(c), modes[c], holds);
    result.enabled.sets_.push_back(*answer);
  }
  return result;
}

const PlantStep::Whole& PlantStep::whole(const Modes& modes, const ControlAction& action) {
  asked_.modes = modes;
  asked_.action = action;
  if (const Whole* known = wholes_.find(asked_)) return *known;
  return wholes_.add(asked_, work_out(modes, action));
}

const AllEnabled& PlantStep::enabled(const Modes& modes, const ControlAction& action) {
  return whole(modes, action).enabled;
}

bool PlantStep::permits(const Modes& modes, const ControlAction& action) { return whole(modes, action).consistent; }

std::vector<Move> PlantStep::moves(ComponentId id, ModeId mode, const Enabled& enabled, Ticks clock_start, Ticks before,
                                   Ticks now) const {
  return moves_of(plant_[id], mode, enabled, now - clock_start, now - before);
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
  return automata::advance(state, next, now);
}

void PlantStep::observe(const Observation& observation) {
  if (observation == observed_) return;
  observed_ = observation;
  std::vector<std::vector<Assignment>> readings(islands_.size());
  for (const Assignment& reading : observation) readings[*locality_.island_of(reading.variable)].push_back(reading);
  weighed_.clear();
  factors_.clear();
  for (std::size_t i = 0; i < islands_.size(); ++i) {
    islands_[i].observe(readings[i]);
    if (!islands_[i].excludes() && readings[i].empty()) continue;
    weighed_.push_back(i);
    factors_.add({locality_.islands()[i].support.components, {}});
  }
}

double PlantStep::observation_factor(const Modes& modes, const Observation& observation) {
  observe(observation);
  factors_.ask(modes, {});
  double product = 1;
  for (std::size_t i = 0; i < weighed_.size() && product > 0; ++i) {
    auto& factor = factors_[i];
    if (!factor) factor = islands_[weighed_[i]].factor(modes);
    product *= *factor;
  }
  return product;
}

Refutation PlantStep::refutation(const Modes& modes, const Observation& observation) {
  [[maybe_unused]] const double factor = observation_factor(modes, observation);
  assert(factor == 0);
  std::size_t first = 0;
  while (factors_[first] != 0.0) ++first;
  return islands_[weighed_[first]].refutation(modes);
}

std::size_t PlantStep::questions() const {
  return std::accumulate(islands_.begin(), islands_.end(), theory_.questions(),
                         [](std::size_t sum, const IslandStore& island) { return sum + island.questions(); });
}

std::size_t PlantStep::solver_calls() const {
  return std::accumulate(islands_.begin(), islands_.end(), theory_.solver_calls(),
                         [](std::size_t sum, const IslandStore& island) { return sum + island.solver_calls(); });
}

bool PlantStep::explains(const Modes& modes, const Observation& observation) {
  return observation_factor(modes, observation) > 0;
}

std::vector<std::vector<Move>> PlantStep::initial_moves() const {
  std::vector<std::vector<Move>> all;
  for (const Component& component : plant_.components) all.push_back(initial_moves_of(component));
  return all;
}

}  // namespace rmpl::automata
