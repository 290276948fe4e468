// Independent groups: the plant cut along a quotient of its dependencies.
// SPDX-License-Identifier: MIT
#include "runtime/reasoning/estimate/groups.hpp"

#include <algorithm>
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
  /// `numbers`: by variable of the whole, none has a number yet; it is left so.
  Extract(const Plant& from, std::vector<std::optional<VariableId>>& numbers) : from_(from), numbers_(numbers) {
    plant_.name = from.name;
  }
  ~Extract() {
    for (const VariableId v : met_) numbers_[v.index()].reset();
  }
  Extract(const Extract&) = delete;
  Extract& operator=(const Extract&) = delete;

  VariableId variable(VariableId id) {
    auto& number = numbers_[id.index()];
    if (!number) {
      number = plant_.variables.add(from_.variables[id]);
      met_.push_back(id);
    }
    return *number;
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
    plant_.components.push_back(std::move(copy));
  }
  void interconnection(const automata::Interconnection& q) {
    plant_.interconnections.emplace_back(formula(q.constraint), q.origin);
  }
  void control(const automata::Control& control) {
    plant_.controls.push_back({variable(control.variable), control.idle});
  }
  void observable(VariableId observed) { plant_.observables.push_back(variable(observed)); }
  [[nodiscard]] Plant take() { return std::move(plant_); }

 private:
  const Plant& from_;
  std::vector<std::optional<VariableId>>& numbers_;
  Plant plant_;
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
  const auto group_of = [&](VariableId v) { return inhabited[*classes[v]].value_or(0); };
  homes_.resize(plant.variables.size());
  for (std::size_t v = 0; v < plant.variables.size(); ++v) {
    if (!classes.of[v]) continue;
    Group& group = groups_[group_of(VariableId(v))];
    homes_[v] = Home{group_of(VariableId(v)), VariableId(group.variables.size())};
    group.variables.emplace_back(v);
  }
  std::vector<std::vector<std::size_t>> interconnections(groups_.size());
  for (std::size_t q = 0; q < plant.interconnections.size(); ++q) {
    const auto read = variables_of(plant.interconnections[q].constraint);
    interconnections[read.empty() ? 0 : group_of(read.front())].push_back(q);
  }
  std::vector<std::vector<VariableId>> observables(groups_.size());
  for (const VariableId observed : plant.observables) observables[group_of(observed)].push_back(observed);

  const automata::PlantIndex& index = dependencies.index();
  std::vector<std::optional<VariableId>> numbers(plant.variables.size());
  for (std::size_t g = 0; g < groups_.size(); ++g) {
    Group& group = groups_[g];
    Extract extract(plant, numbers);
    for (const VariableId v : group.variables) extract.variable(v);
    for (const ComponentId c : group.components) extract.component(plant[c]);
    for (const std::size_t q : interconnections[g]) extract.interconnection(plant.interconnections[q]);
    for (const VariableId observed : observables[g]) extract.observable(observed);
    for (const VariableId own : extract.variables()) {
      if (const auto control = index.control_of(own)) group.controls.push_back(*control);
    }
    std::sort(group.controls.begin(), group.controls.end());
    for (const std::size_t i : group.controls) {
      extract.control(plant.controls[i]);
      if (dependencies.read_by_store(plant.controls[i].variable)) group.constrains_controls = true;
    }
    group.shape = shapes_.find_or_add(extract.take());
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
