// Independent groups: the plant cut along a quotient of its dependencies.
// SPDX-License-Identifier: MIT
#include "runtime/reasoning/estimate/groups.hpp"

#include <algorithm>
#include <unordered_map>
#include <utility>

#include "automata/dependencies/dependencies.hpp"

namespace rmpl::runtime {

using automata::Component;
using automata::ComponentId;
using automata::Formula;
using automata::Plant;
using automata::VariableId;

namespace {

/// Copies parts of a plant into another, whose variables get new numbers as they are met.
class Extract {
 public:
  Extract(const Plant& from, Plant& to) : from_(from), to_(to) {}

  VariableId variable(VariableId id) {
    const auto [known, fresh] = numbers_.try_emplace(id, VariableId(to_.variables.size()));
    if (fresh) {
      to_.variables.add(from_.variables[id]);
      met_.push_back(id);
    }
    return known->second;
  }
  Formula formula(const Formula& formula) {
    return renamed(
        formula, [this](VariableId id) { return variable(id); }, [](VariableId, automata::ValueId v) { return v; });
  }
  /// Of the whole plant, as they were met.
  [[nodiscard]] const std::vector<VariableId>& variables() const { return met_; }
  void component(const Component& original) {
    Component copy = original;
    copy.mode = variable(original.mode);
    for (auto& mode : copy.modes) mode.constraint = formula(mode.constraint);
    for (auto& transition : copy.transitions) transition.guard = formula(transition.guard);
    to_.components.push_back(std::move(copy));
  }

 private:
  const Plant& from_;
  Plant& to_;
  std::unordered_map<VariableId, VariableId> numbers_;
  std::vector<VariableId> met_;
};

}  // namespace

Groups::Groups(const Plant& plant) {
  const automata::Dependencies dependencies(plant);
  const automata::Classes classes = dependencies.groups();
  std::vector<std::optional<std::size_t>> inhabited(classes.count);  // the group of a class with a component in it
  for (std::size_t c = 0; c < plant.components.size(); ++c) {
    auto& group = inhabited[*classes[plant.components[c].mode]];
    if (!group) {
      group = groups_.size();
      groups_.emplace_back();
    }
    groups_[*group].components.emplace_back(c);
  }
  if (groups_.size() < 2) return;

  // What touches no component goes with the first one.
  const auto group_of = [&](std::size_t number) { return inhabited[number].value_or(0); };

  std::vector<Extract> extracts;
  extracts.reserve(groups_.size());
  for (Group& group : groups_) {
    group.plant.name = plant.name;
    extracts.emplace_back(plant, group.plant);
  }
  homes_.resize(plant.variables.size());
  for (std::size_t v = 0; v < plant.variables.size(); ++v) {
    if (!classes.of[v]) continue;
    const std::size_t g = group_of(*classes.of[v]);
    homes_[v] = Home{g, extracts[g].variable(VariableId(v))};
    groups_[g].variables.emplace_back(v);
  }
  for (std::size_t g = 0; g < groups_.size(); ++g) {
    for (const ComponentId c : groups_[g].components) extracts[g].component(plant[c]);
  }
  for (const automata::Interconnection& q : plant.interconnections) {
    const auto read = variables_of(q.constraint);
    const std::size_t g = read.empty() ? 0 : group_of(*classes[read.front()]);
    groups_[g].plant.interconnections.emplace_back(extracts[g].formula(q.constraint), q.origin);
  }
  for (const VariableId observed : plant.observables) {
    const Home& home = *homes_[observed.index()];
    groups_[home.group].plant.observables.push_back(home.variable);
  }
  std::vector<std::optional<std::size_t>> control_of(plant.variables.size());
  for (std::size_t i = 0; i < plant.controls.size(); ++i) control_of[plant.controls[i].variable.index()] = i;
  for (std::size_t g = 0; g < groups_.size(); ++g) {
    for (const VariableId own : extracts[g].variables()) {
      if (const auto& control = control_of[own.index()]) groups_[g].controls.push_back(*control);
    }
    std::sort(groups_[g].controls.begin(), groups_[g].controls.end());
    for (const std::size_t i : groups_[g].controls) {
      const automata::Control& control = plant.controls[i];
      groups_[g].plant.controls.push_back({extracts[g].variable(control.variable), control.idle});
      if (dependencies.read_by_store(control.variable)) groups_[g].constrains_controls = true;
    }
  }
}

std::vector<automata::Observation> Groups::divide(const automata::Observation& observation) const {
  std::vector<automata::Observation> parts(groups_.size());
  for (const automata::Assignment& reading : observation) {
    const auto& home = homes_[reading.variable.index()];
    if (home) parts[home->group].push_back({home->variable, reading.value});
  }
  for (automata::Observation& part : parts) std::sort(part.begin(), part.end());
  return parts;
}

}  // namespace rmpl::runtime
