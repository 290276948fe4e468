// What is left of an island once attributes that only follow from others are eliminated.
// SPDX-License-Identifier: MIT
#include "verifier/export/influence.hpp"

#include <algorithm>
#include <vector>

#include "automata/controls.hpp"
#include "automata/store/elimination.hpp"
#include "base/product.hpp"

namespace rmpl::verifier {

using automata::ComponentId;
using automata::ModeId;
using automata::Support;
using automata::VariableId;

namespace {

constexpr std::size_t most_combinations = 4096;  ///< of modes and commands that are looked at

}  // namespace

Support Influence::support_of(const std::set<VariableId>& variables, bool commanded) {
  Support support;
  std::set<VariableId> known;  // attributes that it depends on, whose values follow
  std::set<std::size_t> islands;
  const auto add = [&](VariableId variable) {
    if (const auto component = plant_.component_of(variable)) {
      support.join({{*component}, {}});
    } else if (const auto control = automata::control_of(plant_, variable)) {
      support.join({{}, {*control}});
      if (!commanded) known.insert(variable);
    } else {
      known.insert(variable);
    }
  };
  for (const VariableId variable : variables) {
    add(variable);
    if (const auto island = step_.locality().island_of(variable)) islands.insert(*island);
  }
  for (const std::size_t number : islands) {
    const automata::Island& island = step_.locality().islands()[number];
    std::vector<VariableId> others;
    for (const VariableId attribute : island.attributes) {
      if (!known.contains(attribute) && !automata::control_of(plant_, attribute)) others.push_back(attribute);
    }
    const automata::Elimination elimination(plant_.variables, island.constraints, others);
    std::set<std::size_t> left = elimination.left();
    for (bool grows = true; grows;) {
      grows = std::erase_if(left, [&](std::size_t position) {
                const automata::Constraint& constraint = island.constraints[position];
                const std::vector<VariableId> read = automata::variables_of(constraint.formula);
                const auto matters = [&](VariableId variable) { return known.contains(variable); };
                if (std::none_of(read.begin(), read.end(), matters)) return false;
                if (constraint.under) add(constraint.under->variable);
                std::for_each(read.begin(), read.end(), add);
                return true;
              }) > 0;
    }
  }
  return support;
}

bool Influence::excludes(const Support& support) {
  std::vector<VariableId> variables;
  for (const ComponentId c : support.components) variables.push_back(plant_[c].mode);
  for (const std::size_t control : support.controls) variables.push_back(plant_.controls[control].variable);
  std::size_t combinations = 1;
  std::vector<std::vector<automata::ValueId>> lists;
  for (const VariableId variable : variables) {
    auto& values = lists.emplace_back();
    for (std::size_t v = 0; v < plant_.variables[variable].values.size(); ++v) values.emplace_back(v);
    combinations = std::min(combinations * values.size(), most_combinations + 1);
  }
  if (combinations > most_combinations) return true;
  bool contradicts = false;
  base::for_each_combination(lists, [&](const std::vector<automata::ValueId>& values) {
    if (contradicts) return;
    std::vector<automata::Assignment> store;
    for (std::size_t i = 0; i < values.size(); ++i) store.push_back({variables[i], values[i]});
    contradicts = !step_.theory().consistent(store);
  });
  return contradicts;
}

const std::vector<Support>& Influence::exclusions() {
  if (exclusions_) return *exclusions_;
  exclusions_.emplace();
  for (const automata::Island& island : step_.locality().islands()) {
    std::vector<VariableId> attributes;
    for (const VariableId attribute : island.attributes) {
      if (!automata::control_of(plant_, attribute)) attributes.push_back(attribute);
    }
    const automata::Elimination elimination(plant_.variables, island.constraints, attributes);
    // Groups of what is left, by the attributes that they read.
    std::vector<std::pair<std::set<VariableId>, Support>> groups;
    for (const std::size_t position : elimination.left()) {
      const automata::Constraint& constraint = island.constraints[position];
      std::vector<VariableId> read = automata::variables_of(constraint.formula);
      if (constraint.under) read.push_back(constraint.under->variable);
      std::pair<std::set<VariableId>, Support> group;
      for (const VariableId variable : read) {
        if (const auto component = plant_.component_of(variable)) {
          group.second.join({{*component}, {}});
        } else if (const auto control = automata::control_of(plant_, variable)) {
          group.second.join({{}, {*control}});
        } else {
          group.first.insert(variable);
        }
      }
      std::erase_if(groups, [&](const auto& other) {
        const auto shared = [&](VariableId variable) { return group.first.contains(variable); };
        if (std::none_of(other.first.begin(), other.first.end(), shared)) return false;
        group.first.insert(other.first.begin(), other.first.end());
        group.second.join(other.second);
        return true;
      });
      groups.push_back(std::move(group));
    }
    for (const auto& [read, support] : groups) {
      if (excludes(support)) exclusions_->push_back(support);
    }
  }
  return *exclusions_;
}

const Support& Influence::support_of(ComponentId component, ModeId mode) {
  const auto [known, fresh] = supports_.try_emplace({component, mode});
  if (!fresh) return known->second;
  std::set<VariableId> variables;
  for (const automata::Transition& transition : plant_[component].transitions) {
    if (transition.from != mode) continue;
    const std::vector<VariableId> read = automata::variables_of(transition.guard);
    variables.insert(read.begin(), read.end());
  }
  return known->second = support_of(variables, true);
}

}  // namespace rmpl::verifier
