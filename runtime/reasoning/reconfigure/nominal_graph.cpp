// The nominal transitions of each component, and closures over them.
// SPDX-License-Identifier: MIT
#include "runtime/reasoning/reconfigure/nominal_graph.hpp"

#include <algorithm>
#include <functional>
#include <numeric>

#include "runtime/reasoning/reconfigure/support_finder.hpp"

namespace rmpl::runtime {

using automata::Component;
using automata::ComponentId;
using automata::Formula;
using automata::ModeId;
using automata::TransitionId;

namespace {

template <class Usable>
std::vector<bool> closure(const std::vector<NominalTransition>& transitions, std::size_t modes, ModeId from,
                          const Usable& usable) {
  std::vector<bool> reached(modes);
  reached[from.index()] = true;
  for (bool grown = true; grown;) {
    grown = false;
    for (const NominalTransition& t : transitions) {
      if (!reached[t.from.index()] || reached[t.to.index()] || !usable(t)) continue;
      reached[t.to.index()] = grown = true;
    }
  }
  return reached;
}

void collect_names(const automata::Plant& plant, const Formula& formula, NamedModes& named) {
  if (formula.kind == Formula::Kind::negation) return;
  if (formula.kind == Formula::Kind::member && formula.values.size() == 1) {
    if (const auto component = plant.component_of(formula.variable)) {
      named[component->index()][formula.values.front().index()] = true;
    }
  }
  for (const Formula& operand : formula.operands) collect_names(plant, operand, named);
}

}  // namespace

NamedModes named_modes(const automata::Plant& plant, const Formula& goal) {
  NamedModes named;
  for (const Component& component : plant.components) named.emplace_back(component.modes.size());
  collect_names(plant, goal, named);
  return named;
}

NominalGraph::NominalGraph(const automata::Plant& plant, const Islands& islands) {
  SupportFinder finder(plant, islands);
  component_of_.resize(plant.variables.size());
  for (std::size_t c = 0; c < plant.components.size(); ++c) {
    component_of_[plant.components[c].mode.index()] = ComponentId(c);
  }
  for (std::size_t c = 0; c < plant.components.size(); ++c) {
    const Component& component = plant.components[c];
    auto& transitions = transitions_.emplace_back();
    for (std::size_t i = 0; i < component.transitions.size(); ++i) {
      const automata::Transition& t = component.transitions[i];
      const bool weightless = t.weight.kind != automata::Weight::Kind::none && !(t.weight.value > 0);
      if (component.is_fault(t) || weightless) continue;
      auto supports = finder.supports(ComponentId(c), TransitionId(i));
      if (supports.empty()) continue;
      transitions.push_back({.id = TransitionId(i),
                             .from = t.from,
                             .to = t.to,
                             .timed = t.timing.has_value(),
                             .bounded = t.timing && !t.timing->upper.is_infinite(),
                             .repair = component.modes[t.from.index()].fault,
                             .reversible = false,
                             .possible = finder.possible(ComponentId(c), t.to),
                             .supports = std::move(supports)});
    }
    for (NominalTransition& t : transitions) {
      const auto back =
          closure(transitions, component.modes.size(), t.to, [](const NominalTransition&) { return true; });
      t.reversible = back[t.from.index()];
    }
  }
  dependents_.resize(plant.components.size());
  for (std::size_t c = 0; c < transitions_.size(); ++c) {
    std::vector<bool> known(plant.components.size());
    known[c] = true;
    for (const NominalTransition& t : transitions_[c]) {
      for (const Support& support : t.supports) {
        for (const Requirement& requirement : support) {
          const auto other = component_of_[requirement.variable.index()];
          if (!other || known[other->index()]) continue;
          known[other->index()] = true;
          dependents_[other->index()].emplace_back(c);
        }
      }
    }
  }
}

const NominalTransition* NominalGraph::find(ComponentId component, TransitionId id) const {
  const auto& all = transitions(component);
  const auto at = std::lower_bound(all.begin(), all.end(), id,
                                   [](const NominalTransition& t, TransitionId wanted) { return t.id < wanted; });
  return at == all.end() || at->id != id ? nullptr : &*at;
}

std::vector<ComponentId> NominalGraph::restless(const automata::Plant& plant) const {
  std::vector<ComponentId> result;
  for (std::size_t c = 0; c < transitions_.size(); ++c) {
    const auto moves_of_itself = [&](const NominalTransition& t) {
      return !t.timed && t.from != t.to &&
             std::any_of(t.supports.begin(), t.supports.end(),
                         [&](const Support& support) { return needs_no_command(plant, support); });
    };
    if (std::any_of(transitions_[c].begin(), transitions_[c].end(), moves_of_itself)) result.emplace_back(c);
  }
  return result;
}

bool NominalGraph::meets(const Requirement& requirement, const std::vector<std::vector<bool>>& reached) const {
  const auto component = component_of_[requirement.variable.index()];
  return !component || std::any_of(requirement.values.begin(), requirement.values.end(),
                                   [&](automata::ValueId v) { return reached[component->index()][v.index()]; });
}

std::vector<std::vector<bool>> NominalGraph::reachable(const automata::Modes& modes, const NamedModes& named) const {
  std::vector<std::vector<bool>> reached;
  for (std::size_t c = 0; c < modes.size(); ++c) {
    reached.emplace_back(named[c].size())[modes[c].index()] = true;
  }
  const auto supported = [&](const Support& support) {
    return std::all_of(support.begin(), support.end(), [&](const Requirement& r) { return meets(r, reached); });
  };
  // What a component reaches is looked at again where one that it depends on has come further.
  std::vector<std::size_t> queue(modes.size());
  std::iota(queue.begin(), queue.end(), std::size_t{0});
  std::vector<bool> queued(modes.size(), true);
  for (std::size_t next = 0; next < queue.size(); ++next) {
    const std::size_t c = queue[next];
    queued[c] = false;
    bool further = false;
    for (bool grown = true; grown;) {
      grown = false;
      for (const NominalTransition& t : transitions_[c]) {
        if (!reached[c][t.from.index()] || reached[c][t.to.index()] || !permitted(t, named[c])) continue;
        if (std::any_of(t.supports.begin(), t.supports.end(), supported)) {
          reached[c][t.to.index()] = grown = further = true;
        }
      }
    }
    for (const ComponentId dependent : dependents_[c]) {
      if (!further || queued[dependent.index()]) continue;
      queued[dependent.index()] = true;
      queue.push_back(dependent.index());
    }
  }
  return reached;
}

std::optional<NominalGraph::Obstacle> NominalGraph::obstacle(ComponentId component, const std::vector<bool>& wanted,
                                                             const std::vector<std::vector<bool>>& reached,
                                                             const NamedModes& named) const {
  const std::vector<bool>& names = named[component.index()];
  const std::vector<bool>& own = reached[component.index()];
  std::optional<Obstacle> first;
  for (const NominalTransition& t : transitions(component)) {
    if (!own[t.from.index()] || own[t.to.index()] || !permitted(t, names)) continue;
    const auto further = closure(transitions(component), names.size(), t.to,
                                 [&](const NominalTransition& next) { return permitted(next, names); });
    const bool leads = std::inner_product(further.begin(), further.end(), wanted.begin(), false, std::logical_or<>(),
                                          std::logical_and<>());
    if (!leads || (first && !wanted[t.to.index()])) continue;
    const Support& support = t.supports.front();
    const auto unmet =
        std::find_if(support.begin(), support.end(), [&](const Requirement& r) { return !meets(r, reached); });
    if (unmet == support.end()) continue;
    first = Obstacle{&t, &*unmet};
    if (wanted[t.to.index()]) break;
  }
  return first;
}

}  // namespace rmpl::runtime
