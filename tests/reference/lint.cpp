// Lint of plants by enumeration.
// SPDX-License-Identifier: MIT
#include "tests/reference/lint.hpp"

#include <algorithm>

namespace rmpl::reference {

using automata::ControlAction;
using automata::ModeId;
using automata::Modes;
using automata::Plant;
using automata::Transition;
using automata::ValueId;

namespace {

/// A transition that no weight rules out.
bool has_weight(const Transition& t) { return t.weight.kind == automata::Weight::Kind::none || t.weight.value > 0; }

}  // namespace

PlantLint::PlantLint(const Plant& plant) : plant_(plant), models_(plant) {
  std::vector<std::size_t> modes, values;
  for (const automata::Component& component : plant.components) modes.push_back(component.modes.size());
  for (const automata::Control& control : plant.controls) {
    values.push_back(plant.variables[control.variable].values.size());
  }
  for (const auto& tuple : tuples(modes)) {
    Modes& all = modes_.emplace_back();
    for (const std::size_t m : tuple) all.emplace_back(m);
  }
  for (const auto& tuple : tuples(values)) {
    ControlAction& all = actions_.emplace_back();
    for (const std::size_t v : tuple) all.emplace_back(v);
  }
  find_starts();
  while (grow()) {
  }
}

void PlantLint::find_starts() {
  ModeSet with_probability;
  for (std::size_t c = 0; c < plant_.components.size(); ++c) {
    for (std::size_t m = 0; m < plant_.components[c].modes.size(); ++m) {
      if (plant_.components[c].initial[m] > 0) with_probability.emplace(c, m);
    }
  }
  for (const Modes& modes : modes_) {
    if (!possible(modes)) continue;
    const bool start = within(modes, with_probability, modes.size());
    for (std::size_t c = 0; c < modes.size(); ++c) {
      possible_.emplace(c, modes[c].index());
      if (start) initial_.emplace(c, modes[c].index());
    }
  }
  reached_ = initial_.empty() ? with_probability : initial_;
}

/// Everything that one more step adds, of one component or of several together. Whether anything was new.
bool PlantLint::grow() {
  const std::size_t before = reached_.size() + enabled_.size();
  for_each_situation([&](const Modes& modes, const ControlAction& action) {
    for (std::size_t c = 0; c < modes.size(); ++c) {
      const auto& transitions = plant_.components[c].transitions;
      for (std::size_t t = 0; t < transitions.size(); ++t) {
        if (transitions[t].from == modes[c] && has_weight(transitions[t]) && implied(c, t, modes, action)) {
          enabled_.emplace(c, t);
        }
      }
    }
  });
  ModeSet next = reached_;
  for (const auto& [c, t] : enabled_) next.emplace(c, plant_.components[c].transitions[t].to.index());
  for (const Modes& modes : modes_) {
    if (!within(modes, next, modes.size()) || !possible(modes)) continue;
    for (std::size_t c = 0; c < modes.size(); ++c) reached_.emplace(c, modes[c].index());
  }
  return reached_.size() + enabled_.size() > before;
}

bool PlantLint::possible(const Modes& modes) const { return models_.consistent(assumptions_of(plant_, modes)); }

bool PlantLint::consistent(const Modes& modes, const ControlAction& action) const {
  return models_.consistent(assumptions_of(plant_, modes, action));
}

bool PlantLint::within(const Modes& modes, const ModeSet& set, std::size_t but) const {
  for (std::size_t c = 0; c < modes.size(); ++c) {
    if (c != but && !set.contains({c, modes[c].index()})) return false;
  }
  return true;
}

bool PlantLint::implied(std::size_t component, std::size_t transition, const Modes& modes,
                        const ControlAction& action) const {
  return models_.entails(assumptions_of(plant_, modes, action),
                         plant_.components[component].transitions[transition].guard);
}

template <class Visit>
void PlantLint::for_each_situation(const Visit& visit) const {
  for (const Modes& modes : modes_) {
    if (!within(modes, reached_, modes.size())) continue;
    for (const ControlAction& action : actions_) {
      if (consistent(modes, action)) visit(modes, action);
    }
  }
}

std::vector<std::pair<Modes, ControlAction>> PlantLint::situations() const {
  std::vector<std::pair<Modes, ControlAction>> result;
  for_each_situation([&](const Modes& modes, const ControlAction& action) { result.emplace_back(modes, action); });
  return result;
}

bool PlantLint::together(std::size_t component, std::size_t a, std::size_t b) const {
  bool result = false;
  for_each_situation([&](const Modes& modes, const ControlAction& action) {
    result = result || (modes[component] == plant_.components[component].transitions[a].from &&
                        implied(component, a, modes, action) && implied(component, b, modes, action));
  });
  return result;
}

bool PlantLint::always_with(std::size_t component, std::size_t transition,
                            const std::vector<std::size_t>& others) const {
  bool result = true;
  for_each_situation([&](const Modes& modes, const ControlAction& action) {
    if (modes[component] != plant_.components[component].transitions[transition].from) return;
    if (!implied(component, transition, modes, action)) return;
    result = result && std::all_of(others.begin(), others.end(),
                                   [&](std::size_t other) { return implied(component, other, modes, action); });
  });
  return result;
}

bool PlantLint::allows(automata::Assignment command) const {
  bool result = false;
  for_each_situation([&](const Modes&, const ControlAction& action) {
    for (std::size_t i = 0; i < action.size(); ++i) {
      result = result || (plant_.controls[i].variable == command.variable && action[i] == command.value);
    }
  });
  return result;
}

/// All that can be observed at once; what is observed of the control `without` does not count.
std::set<std::vector<ValueId>> PlantLint::observations(const Modes& modes, const ControlAction& action,
                                                       std::size_t without) const {
  std::set<std::vector<ValueId>> result;
  for (const World* world : models_.matching(assumptions_of(plant_, modes, action))) {
    std::vector<ValueId> seen;
    for (const automata::VariableId v : plant_.observables) {
      if (without >= action.size() || v != plant_.controls[without].variable) seen.push_back((*world)[v.index()]);
    }
    result.insert(std::move(seen));
  }
  return result;
}

template <class Same>
bool PlantLint::same_in_both(std::size_t component, std::size_t a, std::size_t b, const Same& same) const {
  for (const Modes& modes : modes_) {
    if (modes[component].index() != a || !within(modes, reached_, component)) continue;
    Modes other = modes;
    other[component] = ModeId(b);
    for (const ControlAction& action : actions_) {
      if (consistent(modes, action) && consistent(other, action) && !same(modes, other, action)) return false;
    }
  }
  return true;
}

bool PlantLint::look_alike(std::size_t component, std::size_t a, std::size_t b) const {
  return same_in_both(component, a, b, [&](const Modes& modes, const Modes& other, const ControlAction& action) {
    return observations(modes, action, action.size()) == observations(other, action, action.size());
  });
}

bool PlantLint::go_with_the_same(std::size_t component, std::size_t a, std::size_t b) const {
  return !same_in_both(component, a, b, [](const Modes&, const Modes&, const ControlAction&) { return false; });
}

/// Of the transitions of the other components from the modes that they are in.
std::vector<bool> PlantLint::implied_by_others(std::size_t component, const Modes& modes,
                                               const ControlAction& action) const {
  std::vector<bool> result;
  for (std::size_t c = 0; c < modes.size(); ++c) {
    if (c == component) continue;
    const auto& transitions = plant_.components[c].transitions;
    for (std::size_t t = 0; t < transitions.size(); ++t) {
      if (transitions[t].from == modes[c] && has_weight(transitions[t])) result.push_back(implied(c, t, modes, action));
    }
  }
  return result;
}

bool PlantLint::mean_alike(std::size_t component, std::size_t a, std::size_t b) const {
  return same_in_both(component, a, b, [&](const Modes& modes, const Modes& other, const ControlAction& action) {
    return implied_by_others(component, modes, action) == implied_by_others(component, other, action);
  });
}

bool PlantLint::is_idle(std::size_t control, ValueId value) const {
  for (const Modes& modes : modes_) {
    for (ControlAction action : actions_) {
      if (action[control] != value) continue;
      ControlAction idle = action;
      idle[control] = plant_.controls[control].idle;
      if (observations(modes, action, control) != observations(modes, idle, control)) return false;
      if (implied_by_others(modes.size(), modes, action) != implied_by_others(modes.size(), modes, idle)) return false;
    }
  }
  return true;
}

bool PlantLint::is_independent(std::size_t component) const {
  bool result = true;
  const auto& transitions = plant_.components[component].transitions;
  for_each_situation([&](const Modes& modes, const ControlAction& action) {
    for (const ControlAction& other : actions_) {
      if (!consistent(modes, other)) continue;
      for (std::size_t t = 0; t < transitions.size(); ++t) {
        if (plant_.components[component].is_fault(transitions[t]) || transitions[t].from != modes[component]) continue;
        result = result && implied(component, t, modes, action) == implied(component, t, modes, other);
      }
    }
  });
  return result;
}

}  // namespace rmpl::reference
