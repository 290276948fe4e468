// The constraint store of a plant, island by island.
// SPDX-License-Identifier: MIT
#include "automata/store/constraint_store.hpp"

#include <algorithm>

#include "automata/store/model.hpp"
#include "automata/store/totality.hpp"
#include "base/check.hpp"

namespace rmpl::automata {

ConstraintStore::ConstraintStore(const Plant& plant)
    : plant_(plant),
      dependencies_(plant),
      locality_(dependencies_),
      theory_(model_theory(plant)),
      known_(std::in_place, plant, dependencies_.index(), constraints_of(plant), std::span<const Assignment>()),
      commanded_locality_(Dependencies(plant, known_->take_constraints()), Locality::Commanded::yes),
      watched_(commanded_locality_.islands().size()),
      possible_(plant.components.size(), 0),
      consistent_(plant.components.size(), plant.controls.size()),
      factors_(plant.components.size(), 0) {
  for (const Island& island : locality_.islands()) {
    islands_.emplace_back(plant, dependencies_.index(), island);
    if (!islands_.back().excludes()) continue;
    constrained_.push_back(islands_.size() - 1);
    possible_.add({island.support.components, {}});
  }
}

std::vector<ConstraintStore::Part> ConstraintStore::watch(const Formula& formula) {
  CHECK(known_ && "formulas are watched before the first question");
  std::vector<Part> parts;
  for (const Formula& conjunct : conjuncts_of(known_->rewritten(formula))) {
    if (!conjunct.is_true()) parts.push_back(part(conjunct));
  }
  return parts;
}

ConstraintStore::Part ConstraintStore::part(const Formula& conjunct) {
  std::optional<std::size_t> home;
  Support support;
  bool wide = false;
  for (const VariableId v : variables_of(conjunct)) {
    const auto island = commanded_locality_.island_of(v);
    wide = wide || (home && island && *home != *island);
    if (island) home = island;
    if (const auto component = dependencies_.index().component_of(v)) support.join({{*component}, {}});
    if (const auto control = dependencies_.index().control_of(v)) support.join({{}, {*control}});
  }
  if (wide) {
    support.join(commanded_locality_.support_of(conjunct));
    Memory<bool> memory(plant_, support);
    wide_.push_back({theory_.encode(conjunct), std::move(support), std::move(memory)});
    return {no_island, wide_.size() - 1};
  }
  if (!home) {
    home = of_modes_.try_emplace({support.components, support.controls}, watched_.size()).first->second;
    if (*home == watched_.size()) {
      commanded_locality_.add(support);
      watched_.emplace_back();
    }
  }
  commanded_locality_.widen(*home, support);
  std::vector<Formula>& watched = watched_[*home];
  const auto known = std::find(watched.begin(), watched.end(), conjunct);
  const Part result{*home, static_cast<std::size_t>(known - watched.begin())};
  if (known == watched.end()) watched.push_back(conjunct);
  return result;
}

void ConstraintStore::set_out() {
  if (!known_) return;
  const std::vector<Island>& all = commanded_locality_.islands();
  commanded_.resize(all.size());
  for (std::size_t i = 0; i < all.size(); ++i) {
    // What nothing contradicts under any command is not contradicted in a part.
    const auto whole = all[i].attributes.empty() ? std::nullopt : locality_.island_of(all[i].attributes.front());
    const bool excludes = whole ? islands_[*whole].excludes() && !is_total(plant_, all[i]) : !is_total(plant_, all[i]);
    if (!excludes && watched_[i].empty()) continue;
    commanded_[i] = std::make_unique<CommandedIsland>(plant_, dependencies_.index(), all[i], excludes);
    for (const Formula& formula : watched_[i]) commanded_[i]->watch(formula);
    if (!excludes) continue;
    excluding_.push_back(i);
    consistent_.add(all[i].support);
  }
  known_.reset();
  watched_ = {};
  of_modes_.clear();
}

void ConstraintStore::prepare() {
  std::vector<bool> asked(islands_.size());
  for (const std::size_t i : constrained_) asked[i] = true;
  for (const VariableId v : plant_.observables) asked[*locality_.island_of(v)] = true;
  for (std::size_t i = 0; i < islands_.size(); ++i) {
    if (asked[i]) islands_[i].prepare();
  }
  set_out();
  for (const auto& island : commanded_) {
    if (island) island->prepare();
  }
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
  set_out();
  consistent_.ask(modes, action);
  for (std::size_t i = 0; i < excluding_.size(); ++i) {
    auto& answer = consistent_[i];
    if (!answer) answer = commanded_[excluding_[i]]->consistent(modes, action);
    if (!*answer) return false;
  }
  return true;
}

std::vector<Assignment> ConstraintStore::assumptions(const Support& support, const Modes& modes,
                                                     const ControlAction& action) const {
  std::vector<Assignment> result;
  for (const ComponentId c : support.components) {
    result.push_back({plant_[c].mode, ValueId(modes[c.index()].index())});
  }
  for (const std::size_t i : support.controls) result.push_back({plant_.controls[i].variable, action[i]});
  return result;
}

bool ConstraintStore::implies(Wide& wide, const Modes& modes, const ControlAction& action) {
  return wide.implied.find(modes, action,
                           [&] { return theory_.entails(assumptions(wide.support, modes, action), wide.formula); });
}

bool ConstraintStore::implies(const Part& part, const Modes& modes, const ControlAction& action) {
  if (part.island == no_island) return implies(wide_[part.number], modes, action);
  set_out();
  CommandedIsland& island = *commanded_[part.island];
  return island.implies(part.number, island.verdicts(modes, action), modes, action);
}

const Support& ConstraintStore::support_of(const Part& part) {
  return part.island == no_island ? wide_[part.number].support : commanded_locality_.islands()[part.island].support;
}

std::optional<Reason> ConstraintStore::reason(const Part& part, const Modes& modes, const ControlAction& action,
                                              const std::vector<ComponentId>& unknown) {
  if (part.island != no_island) return commanded_[part.island]->reason(part.number, modes, action, unknown);
  const Wide& wide = wide_[part.number];
  std::vector<Assignment> assumed = assumptions(wide.support, modes, action);
  std::erase_if(assumed, [&](const Assignment& a) {
    const auto component = dependencies_.index().component_of(a.variable);
    return component && std::binary_search(unknown.begin(), unknown.end(), *component);
  });
  const bool implied = theory_.entails(assumed, wide.formula);
  if (!implied && theory_.allows(assumed, wide.formula)) return std::nullopt;
  return Reason{implied, theory_.conflict()};
}

std::optional<bool> ConstraintStore::decided(const Part& part, std::span<const Assignment> assumptions) {
  if (part.island != no_island) return commanded_[part.island]->decided(part.number, assumptions);
  [[maybe_unused]] const bool consistent = theory_.consistent(assumptions);
  CHECK(consistent && "what contradicts itself enables everything");
  if (theory_.known_to_follow(wide_[part.number].formula)) return true;
  if (theory_.known_to_fail(wide_[part.number].formula)) return false;
  return std::nullopt;
}

ConstraintStore::Consequences::Consequences(ConstraintStore& store, const Modes& modes, const ControlAction& action)
    : store_(store), modes_(modes), action_(action) {
  store_.set_out();
  store_.verdicts_.assign(store_.commanded_.size(), nullptr);
}

bool ConstraintStore::Consequences::operator()(const Part& part) {
  if (part.island == no_island) return store_.implies(store_.wide_[part.number], modes_, action_);
  CommandedIsland& island = *store_.commanded_[part.island];
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
  std::size_t sum = theory_.questions();
  for (const IslandStore& island : islands_) sum += island.questions();
  for (const auto& island : commanded_) sum += island ? island->questions() : 0;
  return sum;
}

std::size_t ConstraintStore::solver_calls() const {
  std::size_t sum = theory_.solver_calls();
  for (const IslandStore& island : islands_) sum += island.solver_calls();
  for (const auto& island : commanded_) sum += island ? island->solver_calls() : 0;
  return sum;
}

}  // namespace rmpl::automata
