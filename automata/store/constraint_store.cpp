// The constraint store of a plant, island by island.
// SPDX-License-Identifier: MIT
#include "automata/store/constraint_store.hpp"

#include <algorithm>
#include <numeric>

#include "automata/store/model.hpp"
#include "base/check.hpp"

namespace rmpl::automata {

ConstraintStore::ConstraintStore(const Plant& plant)
    : plant_(plant),
      dependencies_(plant),
      locality_(dependencies_),
      theory_(model_theory(plant)),
      possible_(plant.components.size(), 0),
      consistent_(plant.components.size(), plant.controls.size()),
      factors_(plant.components.size(), 0) {
  for (const Island& island : locality_.islands()) {
    islands_.emplace_back(plant, island);
    if (!islands_.back().excludes()) continue;
    constrained_.push_back(islands_.size() - 1);
    possible_.add({island.support.components, {}});
    consistent_.add(island.support);
  }
}

std::vector<ConstraintStore::Part> ConstraintStore::watch(const Formula& formula) {
  std::vector<Part> parts;
  for (const Formula& conjunct : conjuncts_of(formula)) {
    if (!conjunct.is_true()) parts.push_back(part(conjunct));
  }
  return parts;
}

ConstraintStore::Part ConstraintStore::part(const Formula& conjunct) {
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

void ConstraintStore::prepare() {
  for (IslandStore& island : islands_) island.prepare();
}

bool ConstraintStore::possible(const Modes& modes) {
  possible_.ask(modes, {});
  for (std::size_t i = 0; i < constrained_.size(); ++i) {
    auto& answer = possible_[i];
    if (!answer) answer = islands_[constrained_[i]].possible(modes);
    if (!*answer) return false;
  }
  return true;
}

std::vector<ComponentId> ConstraintStore::conflict(const Modes& modes) {
  const auto at = std::find_if(constrained_.begin(), constrained_.end(),
                               [&](std::size_t island) { return !islands_[island].possible(modes); });
  CHECK(at != constrained_.end() && "possible modes are in no conflict");
  return islands_[*at].conflict(modes);
}

bool ConstraintStore::consistent(const Modes& modes, const ControlAction& action) {
  consistent_.ask(modes, action);
  for (std::size_t i = 0; i < constrained_.size(); ++i) {
    auto& answer = consistent_[i];
    if (!answer) answer = islands_[constrained_[i]].verdicts(modes, action).consistent;
    if (!*answer) return false;
  }
  return true;
}

bool ConstraintStore::implies(Wide& wide, const Modes& modes, const ControlAction& action) {
  return wide.implied.find(modes, action, [&] {
    std::vector<Assignment> store;
    for (const ComponentId c : wide.support.components) {
      store.push_back({plant_[c].mode, ValueId(modes[c.index()].index())});
    }
    for (const std::size_t i : wide.support.controls) store.push_back({plant_.controls[i].variable, action[i]});
    return theory_.entails(store, wide.formula);
  });
}

bool ConstraintStore::implies(const Part& part, const Modes& modes, const ControlAction& action) {
  if (part.island == no_island) return implies(wide_[part.number], modes, action);
  IslandStore& island = islands_[part.island];
  return island.implies(part.number, island.verdicts(modes, action), modes, action);
}

ConstraintStore::Consequences::Consequences(ConstraintStore& store, const Modes& modes, const ControlAction& action)
    : store_(store), modes_(modes), action_(action) {
  store_.verdicts_.assign(store_.islands_.size(), nullptr);
}

bool ConstraintStore::Consequences::operator()(const Part& part) {
  if (part.island == no_island) return store_.implies(store_.wide_[part.number], modes_, action_);
  IslandStore& island = store_.islands_[part.island];
  auto& verdicts = store_.verdicts_[part.island];
  if (verdicts == nullptr) verdicts = &island.verdicts(modes_, action_);
  return island.implies(part.number, *verdicts, modes_, action_);
}

void ConstraintStore::observe(const Observation& observation) {
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

double ConstraintStore::observation_factor(const Modes& modes, const Observation& observation) {
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

Refutation ConstraintStore::refutation(const Modes& modes, const Observation& observation) {
  const double factor = observation_factor(modes, observation);
  CHECK(factor == 0 && "only what is refuted has somebody to blame");
  std::size_t first = 0;
  while (factors_[first] != 0.0) ++first;
  return islands_[weighed_[first]].refutation(modes);
}

std::size_t ConstraintStore::questions() const {
  return std::accumulate(islands_.begin(), islands_.end(), theory_.questions(),
                         [](std::size_t sum, const IslandStore& island) { return sum + island.questions(); });
}

std::size_t ConstraintStore::solver_calls() const {
  return std::accumulate(islands_.begin(), islands_.end(), theory_.solver_calls(),
                         [](std::size_t sum, const IslandStore& island) { return sum + island.solver_calls(); });
}

}  // namespace rmpl::automata
