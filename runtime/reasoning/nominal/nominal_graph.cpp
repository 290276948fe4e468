// The nominal transitions of each component, and closures over them.
// SPDX-License-Identifier: MIT
#include "runtime/reasoning/nominal/nominal_graph.hpp"

#include <algorithm>
#include <functional>
#include <numeric>
#include <utility>

#include "runtime/reasoning/nominal/irreversible.hpp"
#include "runtime/reasoning/nominal/preconditions.hpp"

namespace rmpl::runtime {

using automata::Component;
using automata::ComponentId;
using automata::Formula;
using automata::ModeId;
using automata::TransitionId;

namespace {

constexpr auto any_transition = [](const NominalTransition&) { return true; };

/// The modes that the usable transitions lead to from those reached, these among them.
template <class Usable>
std::vector<bool> closure(const std::vector<NominalTransition>& transitions, std::vector<bool> reached,
                          const Usable& usable) {
  for (bool grown = true; grown;) {
    grown = false;
    for (const NominalTransition& t : transitions) {
      if (!reached[t.from.index()] || reached[t.to.index()] || !usable(t)) continue;
      reached[t.to.index()] = grown = true;
    }
  }
  return reached;
}

/// Per mode, the modes that the transitions lead to.
std::vector<std::vector<bool>> closures(const std::vector<NominalTransition>& transitions, std::size_t modes) {
  std::vector<std::vector<bool>> leads;
  leads.reserve(modes);
  for (std::size_t m = 0; m < modes; ++m) {
    std::vector<bool> start(modes);
    start[m] = true;
    leads.push_back(closure(transitions, std::move(start), any_transition));
  }
  return leads;
}

/// The modes that the component ever comes to, faults or not.
std::vector<bool> ever_come_to(const Component& component) {
  std::vector<bool> reached;
  for (const double share : component.initial) reached.push_back(share > 0);
  for (bool grown = true; grown;) {
    grown = false;
    for (const automata::Transition& t : component.transitions) {
      if (!reached[t.from.index()] || reached[t.to.index()]) continue;
      reached[t.to.index()] = grown = true;
    }
  }
  return reached;
}

/// A repair may take several steps: a mode that is come to, and only by way of a fault, belongs to it, and so does the
/// step that leads on from there, or back to where the component may be without any step that cannot be undone.
void mark_ends_of_repairs(const Component& component, std::vector<NominalTransition>& transitions) {
  std::vector<bool> start(component.modes.size());
  for (std::size_t m = 0; m < start.size(); ++m) start[m] = component.initial[m] > 0 && !component.modes[m].fault;
  const std::vector<bool> without_fault = closure(transitions, start, any_transition);
  const std::vector<bool> ever = ever_come_to(component);
  const std::vector<bool> revocably =
      closure(transitions, start, [](const NominalTransition& t) { return t.reversible; });
  for (NominalTransition& t : transitions) {
    if (ever[t.from.index()] && !without_fault[t.from.index()] &&
        (!without_fault[t.to.index()] || revocably[t.to.index()]))
      t.repair = true;
  }
}

/// `x != v` reads like this where the domain is small: all values but one of three or more.
bool is_inequality(const automata::Plant& plant, const Formula& atom) {
  const std::size_t size = plant.variables[atom.variable].values.size();
  return size > 2 && atom.values.size() + 1 == size;
}

void collect_names(const automata::Plant& plant, const Formula& formula, bool positive, NamedModes& named) {
  using Kind = Formula::Kind;
  switch (formula.kind) {
    case Kind::member:
      if (const auto component = plant.component_of(formula.variable);
          positive && component && !is_inequality(plant, formula)) {
        for (const automata::ValueId v : formula.values) named[component->index()][v.index()] = true;
      }
      return;
    case Kind::negation:
      return collect_names(plant, formula.operands.front(), !positive, named);
    case Kind::implication:
      collect_names(plant, formula.operands[0], !positive, named);
      return collect_names(plant, formula.operands[1], positive, named);
    case Kind::conjunction:
    case Kind::disjunction:
      for (const Formula& operand : formula.operands) collect_names(plant, operand, positive, named);
      return;
    case Kind::constant:
    case Kind::equality:
    case Kind::clock:
    case Kind::knowledge:
    case Kind::equivalence:
      return;
  }
}

}  // namespace

NamedModes named_modes(const automata::Plant& plant, const Formula& goal) {
  NamedModes named;
  for (const Component& component : plant.components) named.emplace_back(component.modes.size());
  collect_names(plant, goal, true, named);
  return named;
}

NominalGraph::NominalGraph(const automata::Plant& plant) : index_(plant) {
  Preconditions finder(plant);
  for (std::size_t c = 0; c < plant.components.size(); ++c) {
    const Component& component = plant.components[c];
    components_.emplace_back(c);
    auto& transitions = transitions_.emplace_back();
    for (std::size_t i = 0; i < component.transitions.size(); ++i) {
      const automata::Transition& t = component.transitions[i];
      const bool weightless = t.weight.kind != automata::Weight::Kind::none && !(t.weight.value > 0);
      if (component.is_fault(t) || weightless) continue;
      auto [preconditions, all] = finder.of(ComponentId(c), TransitionId(i));
      if (preconditions.empty()) continue;
      transitions.push_back({.id = TransitionId(i),
                             .from = t.from,
                             .to = t.to,
                             .timed = t.timing.has_value(),
                             .repair = component.modes[t.from.index()].fault,
                             .reversible = false,
                             .irreversible = false,
                             .licensed = component.progress,
                             .possible = finder.possible(ComponentId(c), t.to),
                             .comes_by_itself = false,
                             .preconditions = std::move(preconditions),
                             .all_preconditions = all,
                             .silent = {}});
      NominalTransition& added = transitions.back();
      const auto about_mode = [&](const Requirement& r) { return index_.component_of(r.variable).has_value(); };
      for (const Precondition& precondition : added.preconditions) {
        added.silent.push_back(needs_no_command(plant, index_, precondition));
        added.comes_by_itself =
            added.comes_by_itself ||
            (added.silent.back() && std::none_of(precondition.begin(), precondition.end(), about_mode));
      }
    }
    leads_.push_back(closures(transitions, component.modes.size()));
    for (NominalTransition& t : transitions) t.reversible = leads_[c][t.to.index()][t.from.index()];
    mark_ends_of_repairs(component, transitions);
    mark_irreversible(component, leads_[c], transitions);
    for (NominalTransition& t : transitions) t.irreversible = t.irreversible && !t.licensed;
    auto& deciding = deciding_.emplace_back(component.modes.size(), automata::Support{});
    for (const NominalTransition& t : transitions) {
      auto& support = deciding[t.from.index()];
      if (!t.all_preconditions) support.reset();
      if (support) support->join(support_of(t.preconditions));
    }
  }
  dependents_.resize(plant.components.size());
  for (std::size_t c = 0; c < transitions_.size(); ++c) {
    std::vector<bool> known(plant.components.size());
    known[c] = true;
    for (const NominalTransition& t : transitions_[c]) {
      for (const Precondition& precondition : t.preconditions) {
        for (const Requirement& requirement : precondition) {
          const auto other = component_of(requirement);
          if (!other || known[other->index()]) continue;
          known[other->index()] = true;
          dependents_[other->index()].emplace_back(c);
        }
      }
    }
  }
}

automata::Support NominalGraph::support_of(const std::vector<Precondition>& preconditions) const {
  automata::Support support;
  for (const Precondition& precondition : preconditions) {
    for (const Requirement& r : precondition) {
      if (const auto other = index_.component_of(r.variable)) support.components.push_back(*other);
      if (const auto control = index_.control_of(r.variable)) support.controls.push_back(*control);
    }
  }
  const auto tidy = [](auto& list) {
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
  };
  tidy(support.components);
  tidy(support.controls);
  return support;
}

bool NominalGraph::met(const NominalTransition& transition, const automata::Modes& modes,
                       const automata::ControlAction& action) const {
  const auto value = [&](automata::VariableId variable) {
    const auto component = index_.component_of(variable);
    return component ? automata::ValueId(modes[component->index()].index()) : action[*index_.control_of(variable)];
  };
  return std::any_of(transition.preconditions.begin(), transition.preconditions.end(), [&](const Precondition& all) {
    return std::all_of(all.begin(), all.end(), [&](const Requirement& r) {
      return std::binary_search(r.values.begin(), r.values.end(), value(r.variable));
    });
  });
}

const NominalTransition* NominalGraph::find(ComponentId component, TransitionId id) const {
  const auto& all = transitions(component);
  const auto at = std::lower_bound(all.begin(), all.end(), id,
                                   [](const NominalTransition& t, TransitionId wanted) { return t.id < wanted; });
  return at == all.end() || at->id != id ? nullptr : &*at;
}

std::vector<ComponentId> NominalGraph::upstream(std::span<const ComponentId> components) const {
  std::vector<ComponentId> result;
  std::vector<bool> known(transitions_.size());
  const auto add = [&](ComponentId c) {
    if (known[c.index()]) return;
    known[c.index()] = true;
    result.push_back(c);
  };
  for (const ComponentId c : components) add(c);
  for (std::size_t next = 0; next < result.size(); ++next) {
    for (const NominalTransition& t : transitions(result[next])) {
      for (const Precondition& precondition : t.preconditions) {
        for (const Requirement& r : precondition) {
          if (const auto other = component_of(r)) add(*other);
        }
      }
    }
  }
  return result;
}

bool NominalGraph::meets(const Requirement& requirement, const std::vector<std::vector<bool>>& reached) const {
  const auto component = component_of(requirement);
  return !component || std::any_of(requirement.values.begin(), requirement.values.end(),
                                   [&](automata::ValueId v) { return reached[component->index()][v.index()]; });
}

bool NominalGraph::leads_to_named(ComponentId component, ModeId from, const NamedModes& named) const {
  const auto& reached = leads_[component.index()][from.index()];
  const auto& names = named[component.index()];
  return std::inner_product(reached.begin(), reached.end(), names.begin(), false, std::logical_or<>(),
                            std::logical_and<>());
}

}  // namespace rmpl::runtime
