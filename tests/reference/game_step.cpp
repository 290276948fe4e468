// The nominal step, without clocks. SPDX-License-Identifier: MIT
#include "tests/reference/game_step.hpp"

#include <algorithm>

#include "automata/clock_use.hpp"
#include "automata/store/model.hpp"
#include "tests/reference/goals.hpp"

namespace rmpl::reference {

using automata::Assignment;
using automata::Modes;
using automata::Transition;

namespace {

std::vector<std::pair<std::size_t, automata::ValueId>> off_idle_values(const automata::Plant& plant,
                                                                       const automata::ControlAction& action) {
  std::vector<std::pair<std::size_t, automata::ValueId>> result;
  for (std::size_t i = 0; i < action.size(); ++i)
    if (action[i] != plant.controls[i].idle) result.emplace_back(i, action[i]);
  return result;
}

}  // namespace

GameStep::GameStep(const automata::Plant& plant)
    : plant_(plant), actions_(all_actions(plant)), theory_(automata::model_theory(plant)) {
  std::sort(actions_.begin(), actions_.end(),
            [&](const auto& a, const auto& b) { return off_idle_values(plant, a) < off_idle_values(plant, b); });
}

std::size_t GameStep::off_idle(Action action) const { return automata::commanded(plant_, actions_[action]).size(); }

bool GameStep::entails(const Modes& modes, const automata::Formula& formula) {
  return theory_.entails(automata::assignments_of(plant_, modes), theory_.encode(formula));
}

bool GameStep::can_be_taken(std::size_t component, const Transition& transition) {
  const Assignment source{plant_.components[component].mode, automata::ValueId(transition.from.index())};
  const automata::Theory::Handle guard = theory_.encode(transition.guard);
  if (!reference::can_be_taken(transition) || !theory_.allows({&source, 1}, guard)) return false;
  std::vector<std::size_t> sizes;
  for (const automata::Component& c : plant_.components) sizes.push_back(c.modes.size());
  sizes[component] = 1;
  for (const auto& tuple : tuples(sizes)) {
    Modes modes;
    for (const std::size_t mode : tuple) modes.emplace_back(mode);
    modes[component] = transition.from;
    std::vector<Assignment> store = automata::assignments_of(plant_, modes);
    if (!theory_.allows(store, guard)) continue;
    for (const automata::ControlAction& action : actions_) {
      std::vector<Assignment> with = store;
      for (const Assignment& a : automata::assignments_of(plant_, action)) with.push_back(a);
      if (theory_.consistent(with) && theory_.entails(with, guard)) return true;
    }
  }
  return false;
}

const std::optional<std::vector<Freedom>>& GameStep::freedom(const Modes& modes, Action action) {
  Freedoms& known = freedoms_[modes];
  known.resize(actions_.size());
  auto& own = known[action];
  if (!own) own = std::make_unique<const std::optional<std::vector<Freedom>>>(find_freedom(modes, action));
  return *own;
}

std::optional<std::vector<Freedom>> GameStep::find_freedom(const Modes& modes, Action action) {
  std::vector<Assignment> store = automata::assignments_of(plant_, modes);
  for (const Assignment& a : automata::assignments_of(plant_, actions_[action])) store.push_back(a);
  if (!theory_.consistent(store)) return std::nullopt;
  std::vector<Freedom> result;
  for (std::size_t c = 0; c < modes.size(); ++c) {
    const automata::Component& component = plant_.components[c];
    Freedom& freedom = result.emplace_back();
    for (const Transition& t : component.transitions) {
      if (t.from != modes[c] || component.is_fault(t) || !reference::can_be_taken(t)) continue;
      if (!theory_.entails(store, theory_.encode(t.guard))) continue;
      freedom.restarts = freedom.restarts || (t.restart && automata::needs_clock(component, modes[c]));
      if (!t.timing)
        freedom.at_once.push_back(t.to);
      else if (t.to == t.from)
        freedom.dawdles = true;
      else
        freedom.timed.push_back(&t);
    }
    std::sort(freedom.at_once.begin(), freedom.at_once.end());
    freedom.at_once.erase(std::unique(freedom.at_once.begin(), freedom.at_once.end()), freedom.at_once.end());
    if (!freedom.at_once.empty()) freedom.timed.clear();
  }
  return result;
}

const std::vector<Nogood>& GameStep::nogoods(const Modes& modes) {
  const auto [at, fresh] = nogoods_.try_emplace(modes);
  if (!fresh || theory_.consistent(automata::assignments_of(plant_, modes))) return at->second;
  // Smaller sets first: what holds one that was found is not smallest.
  std::vector<std::size_t> subsets;
  for (std::size_t set = 1; set < std::size_t{1} << modes.size(); ++set) subsets.push_back(set);
  const auto size = [](std::size_t set) { return __builtin_popcountll(set); };
  std::stable_sort(subsets.begin(), subsets.end(), [&](std::size_t a, std::size_t b) { return size(a) < size(b); });
  std::vector<std::size_t> found;
  for (const std::size_t set : subsets) {
    if (std::any_of(found.begin(), found.end(), [&](std::size_t f) { return (set & f) == f; })) continue;
    Nogood some;
    std::vector<Assignment> store;
    for (std::size_t c = 0; c < modes.size(); ++c) {
      if ((set >> c & 1) == 0) continue;
      some.emplace_back(c, modes[c]);
      store.push_back({plant_.components[c].mode, automata::ValueId(modes[c].index())});
    }
    if (theory_.consistent(store)) continue;
    found.push_back(set);
    at->second.push_back(std::move(some));
  }
  return at->second;
}

}  // namespace rmpl::reference
