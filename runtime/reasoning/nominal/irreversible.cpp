// Which steps cannot be undone: closures over the transitions of one component.
// SPDX-License-Identifier: MIT
#include "runtime/reasoning/nominal/irreversible.hpp"

#include <algorithm>
#include <utility>

namespace rmpl::runtime {

using automata::Component;

namespace {

/// Steps from mode to mode.
using Steps = std::vector<std::pair<std::size_t, std::size_t>>;

/// The modes that the steps lead to from those of `reached`, these among them.
std::vector<bool> closure(const Steps& steps, std::vector<bool> reached) {
  for (bool grown = true; grown;) {
    grown = false;
    for (const auto& [from, to] : steps) {
      if (!reached[from] || reached[to]) continue;
      reached[to] = grown = true;
    }
  }
  return reached;
}

std::vector<bool> only(std::size_t size, std::size_t member) {
  std::vector<bool> set(size);
  set[member] = true;
  return set;
}

/// By mode: it is come to from the start without any fault.
std::vector<bool> usual_modes(const Component& component, const Steps& nominal) {
  std::vector<bool> whole(component.modes.size());
  for (std::size_t m = 0; m < whole.size(); ++m) whole[m] = component.initial[m] > 0 && !component.modes[m].fault;
  return closure(nominal, whole);
}

/// By mode: it is a fault mode, or is come to from the start, and only by way of a fault.
std::vector<bool> broken_modes(const Component& component, const std::vector<bool>& usual, const Steps& all) {
  std::vector<bool> start(component.modes.size());
  for (std::size_t m = 0; m < start.size(); ++m) start[m] = component.initial[m] > 0;
  const auto ever = closure(all, start);
  std::vector<bool> broken(component.modes.size());
  for (std::size_t m = 0; m < broken.size(); ++m) broken[m] = component.modes[m].fault || (ever[m] && !usual[m]);
  return broken;
}

/// The usual modes in which a way into the broken mode begins.
std::vector<bool> broken_from(const std::vector<bool>& usual, const std::vector<bool>& broken, const Steps& all,
                              std::size_t mode) {
  std::vector<bool> behind = only(broken.size(), mode), origins(broken.size());
  for (bool grown = true; grown;) {
    grown = false;
    for (const auto& [from, to] : all) {
      if (!behind[to]) continue;
      if (usual[from]) {
        origins[from] = true;
      } else if (broken[from] && !behind[from]) {
        behind[from] = grown = true;
      }
    }
  }
  return origins;
}

bool empty(const std::vector<bool>& set) { return std::find(set.begin(), set.end(), true) == set.end(); }

bool meet(const std::vector<bool>& a, const std::vector<bool>& b) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (a[i] && b[i]) return true;
  }
  return false;
}

}  // namespace

void mark_irreversible(const Component& component, const std::vector<std::vector<bool>>& leads,
                       std::vector<NominalTransition>& transitions) {
  Steps nominal;
  for (const NominalTransition& t : transitions) {
    if (t.possible && t.from != t.to) nominal.emplace_back(t.from.index(), t.to.index());
  }
  Steps all = nominal;
  for (const automata::Transition& t : component.transitions) {
    if (component.is_fault(t)) all.emplace_back(t.from.index(), t.to.index());
  }
  const std::vector<bool> usual = usual_modes(component, nominal);
  const std::vector<bool> broken = broken_modes(component, usual, all);
  for (NominalTransition& t : transitions) {
    const std::vector<bool>& then = leads[t.to.index()];
    if (!broken[t.from.index()]) {
      t.irreversible = !then[t.from.index()];
    } else {
      const auto origins = broken_from(usual, broken, all, t.from.index());
      t.irreversible = t.from != t.to && !empty(origins) && !meet(then, origins);
    }
  }
}

}  // namespace rmpl::runtime
