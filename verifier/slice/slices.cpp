// Slices of a plant.
// SPDX-License-Identifier: MIT
#include "verifier/slice/slices.hpp"

#include <algorithm>
#include <map>

#include "automata/store/island_store.hpp"
#include "automata/store/model.hpp"
#include "automata/store/totality.hpp"
#include "base/partition.hpp"
#include "verifier/property/initial_modes.hpp"

namespace rmpl::verifier {

using automata::Assignment;
using automata::ComponentId;
using automata::Formula;
using automata::Island;
using automata::IslandStore;
using automata::ModeId;
using automata::Modes;
using automata::ValueId;
using automata::VariableId;

namespace {

/// Up to so many combinations are looked at: of modes and controls of an island, more are taken to hold a
/// contradiction; of modes that decide a formula, one of more is taken to imply it.
constexpr std::size_t most_combinations = 4096;

}  // namespace

Slices::Slices(const automata::Plant& plant)
    : plant_(plant),
      index_(plant),
      locality_(plant),
      islands_of_(plant.components.size()),
      interconnections_(plant.variables.size()),
      excludes_(locality_.islands().size()) {
  for (std::size_t i = 0; i < locality_.islands().size(); ++i) {
    const Island& island = locality_.islands()[i];
    if (island.constraints.empty()) continue;
    for (const ComponentId c : island.support.components) islands_of_[c.index()].push_back(i);
  }
  for (std::size_t q = 0; q < plant.interconnections.size(); ++q) {
    for (const VariableId v : automata::variables_of(plant.interconnections[q].constraint)) {
      interconnections_[v.index()].push_back(q);
    }
  }
}

automata::PlantStep& Slices::whole() {
  if (!whole_) whole_.emplace(plant_);
  return *whole_;
}

bool Slices::excludes(std::size_t island) {
  auto& answer = excludes_[island];
  if (!answer) answer = !automata::is_total(plant_, locality_.islands()[island]);
  return *answer;
}

/// Whether no control action contradicts the island in modes that are possible.
bool Slices::indifferent(std::size_t number) {
  if (!excludes(number)) return true;
  const Island& island = locality_.islands()[number];
  std::size_t combinations = 1;
  const auto times = [&](std::size_t values) { combinations = std::min(combinations * values, most_combinations + 1); };
  for (const ComponentId c : island.support.components) times(plant_[c].modes.size());
  for (const std::size_t i : island.support.controls) {
    times(plant_.variables[plant_.controls[i].variable].values.size());
  }
  if (combinations > most_combinations) return false;
  automata::IslandTheory store(plant_, island);
  Modes modes(plant_.components.size(), ModeId(0));
  automata::ControlAction action(plant_.controls.size(), ValueId(0));
  for (std::size_t combination = 0; combination < combinations; ++combination) {
    std::size_t rest = combination;
    const auto digit = [&](std::size_t values) {
      const std::size_t value = rest % values;
      rest /= values;
      return value;
    };
    std::vector<Assignment> assumed;
    for (const ComponentId c : island.support.components) {
      modes[c.index()] = ModeId(digit(plant_[c].modes.size()));
      assumed.push_back({plant_[c].mode, ValueId(modes[c.index()].index())});
    }
    for (const std::size_t i : island.support.controls) {
      action[i] = ValueId(digit(plant_.variables[plant_.controls[i].variable].values.size()));
    }
    if (!store().consistent(store.assumptions(modes)) || store().consistent(store.assumptions(modes, action))) continue;
    // Other islands may say that these modes are never together.
    if (!theory_) theory_.emplace(automata::model_theory(plant_));
    if (theory_->consistent(assumed)) return false;
  }
  return true;
}

const std::vector<std::size_t>& Slices::sensitive() {
  if (sensitive_) return *sensitive_;
  std::vector<std::size_t> result;
  for (std::size_t i = 0; i < locality_.islands().size(); ++i) {
    const Island& island = locality_.islands()[i];
    if (island.constraints.empty() || island.support.controls.empty() || indifferent(i)) continue;
    result.push_back(i);
  }
  return sensitive_.emplace(std::move(result));
}

Cone Slices::cone(std::span<const Formula> formulas) {
  std::vector<bool> inside(plant_.components.size(), false);
  Cone result;  // in the order in which they came up
  const auto add = [&](const std::vector<ComponentId>& components) {
    for (const ComponentId c : components) {
      if (!inside[c.index()]) result.push_back(c);
      inside[c.index()] = true;
    }
  };
  for (const Formula& formula : formulas) add(locality_.support_of(formula).components);
  for (const std::size_t i : sensitive()) add(locality_.islands()[i].support.components);
  for (std::size_t next = 0; next < result.size(); ++next) {
    const ComponentId c = result[next];
    for (const automata::Transition& t : plant_[c].transitions) add(locality_.support_of(t.guard).components);
    for (const std::size_t i : islands_of_[c.index()]) add(locality_.islands()[i].support.components);
  }
  std::sort(result.begin(), result.end());
  return result;
}

Part Slices::part(const Cone& cone, std::span<const Formula> formulas) {
  Part::Kept kept{cone, std::vector<bool>(plant_.variables.size(), false), {}};
  std::vector<VariableId> variables;
  const auto keep = [&](VariableId v) {
    if (!kept.variables[v.index()]) variables.push_back(v);
    kept.variables[v.index()] = true;
  };
  const auto keep_island = [&](std::size_t island) {
    for (const VariableId attribute : locality_.islands()[island].attributes) keep(attribute);
  };
  const auto keep_islands = [&](const Formula& formula) {
    for (const VariableId v : automata::variables_of(formula)) {
      const auto island = locality_.island_of(v);
      if (island && !kept.variables[v.index()]) keep_island(*island);
    }
  };
  for (const ComponentId c : cone) {
    keep(plant_[c].mode);
    for (const std::size_t i : islands_of_[c.index()]) keep_island(i);
    for (const automata::Transition& t : plant_[c].transitions) keep_islands(t.guard);
  }
  for (const Formula& formula : formulas) keep_islands(formula);
  for (const std::size_t i : sensitive()) keep_island(i);
  for (const VariableId v : variables) {
    const auto& reading = interconnections_[v.index()];
    kept.interconnections.insert(kept.interconnections.end(), reading.begin(), reading.end());
  }
  std::sort(kept.interconnections.begin(), kept.interconnections.end());
  kept.interconnections.erase(std::unique(kept.interconnections.begin(), kept.interconnections.end()),
                              kept.interconnections.end());
  return {plant_, kept};
}

const std::optional<Modes>& Slices::start(const std::vector<Assignment>& from) {
  if (!start_ || start_->from != from) start_ = {from, first_start(from)};
  return start_->modes;
}

std::optional<Modes> Slices::first_start(const std::vector<Assignment>& from) {
  const std::vector<std::vector<ModeId>> lists = initial_modes(plant_, from);
  Modes modes;
  for (const auto& list : lists) {
    if (list.empty()) return std::nullopt;
    modes.push_back(list.front());
  }
  // What islands exclude is settled among the components that they join.
  base::Partition partition(plant_.components.size());
  std::vector<std::size_t> excluding;
  for (std::size_t i = 0; i < excludes_.size(); ++i) {
    const Island& island = locality_.islands()[i];
    const auto& components = island.support.components;
    if (island.constraints.empty() || !excludes(i)) continue;
    excluding.push_back(i);
    for (const ComponentId c : components) partition.join(components.front().index(), c.index());
  }
  struct Together {
    std::vector<std::size_t> components, islands;
  };
  std::map<std::size_t, Together> clusters;  // by the root of their components
  constexpr std::size_t nobody = SIZE_MAX;
  for (const std::size_t i : excluding) {
    const auto& components = locality_.islands()[i].support.components;
    Together& cluster = clusters[components.empty() ? nobody : partition.root(components.front().index())];
    cluster.islands.push_back(i);
    for (const ComponentId c : components) cluster.components.push_back(c.index());
  }
  for (auto& [root, cluster] : clusters) {
    auto& components = cluster.components;
    std::sort(components.begin(), components.end());
    components.erase(std::unique(components.begin(), components.end()), components.end());
    if (!settle(components, cluster.islands, lists, modes)) return std::nullopt;
  }
  return modes;
}

bool Slices::can_hold(const Formula& formula) {
  // What else there is can hold beside it where there is a state at all.
  if (!start({})) return whole().theory().allows({}, whole().theory().encode(formula));
  const Part inside = part(cone({&formula, 1}), {&formula, 1});
  automata::Theory theory = automata::model_theory(inside.plant());
  return theory.allows({}, theory.encode(inside.into(formula)));
}

bool Slices::can_follow(const Formula& formula) {
  if (!start({})) return true;
  const Part inside = part(cone({&formula, 1}), {&formula, 1});
  const automata::Plant& plant = inside.plant();
  const Formula wanted = inside.into(formula);
  const std::vector<ComponentId> deciding = automata::Locality(plant).support_of(wanted).components;
  automata::Theory theory = automata::model_theory(plant);
  const automata::Theory::Handle handle = theory.encode(wanted);
  for (std::size_t combination = 0; combination < most_combinations; ++combination) {
    if (!theory.allows({}, handle)) return false;
    std::vector<Assignment> modes, decided;
    for (const automata::Component& component : plant.components) {
      modes.push_back({component.mode, theory.value(component.mode)});
    }
    for (const ComponentId c : deciding) decided.push_back(modes[c.index()]);
    if (theory.entails(modes, handle)) return true;
    theory.tell(automata::negation(automata::conjunction_of(decided)));
  }
  return true;
}

bool Slices::allows(const Modes& modes, const Formula& formula) {
  const Part inside = part(cone({&formula, 1}), {&formula, 1});
  automata::Theory theory = automata::model_theory(inside.plant());
  const std::vector<Assignment> store = inside.into(automata::assignments_of(plant_, modes));
  return theory.allows(store, theory.encode(inside.into(formula)));
}

/// The first modes of the components, in the order of their lists, that the islands allow.
bool Slices::settle(const std::vector<std::size_t>& components, const std::vector<std::size_t>& islands,
                    const std::vector<std::vector<ModeId>>& lists, Modes& modes) const {
  std::vector<std::vector<IslandStore>> judged(components.size() + 1);  // by how many must be known
  for (const std::size_t i : islands) {
    const auto& support = locality_.islands()[i].support.components;
    const auto last = support.empty() ? components.begin()
                                      : std::upper_bound(components.begin(), components.end(), support.back().index());
    judged[static_cast<std::size_t>(last - components.begin())].emplace_back(plant_, index_, locality_.islands()[i]);
  }
  const auto allowed = [&](std::size_t known) {
    return std::all_of(judged[known].begin(), judged[known].end(), [&](IslandStore& s) { return s.possible(modes); });
  };
  if (!allowed(0)) return false;
  std::vector<std::size_t> taken(components.size(), 0);
  for (std::size_t known = 0; known < components.size();) {
    const auto& list = lists[components[known]];
    if (taken[known] == list.size()) {
      if (known == 0) return false;
      taken[known--] = 0;
      continue;
    }
    modes[components[known]] = list[taken[known]++];
    if (allowed(known + 1)) ++known;
  }
  return true;
}

}  // namespace rmpl::verifier
