// Who reads whom in a plant, and the quotients of it.
// SPDX-License-Identifier: MIT
#include "automata/dependencies/dependencies.hpp"

#include <utility>

#include "base/partition.hpp"

namespace rmpl::automata {
namespace {

template <class Known>
Classes classes_of(base::Partition& partition, std::size_t variables, const Known& known) {
  Classes result;
  result.of.resize(variables);
  std::vector<std::optional<std::size_t>> of_root(variables);
  for (std::size_t v = 0; v < variables; ++v) {
    if (known(VariableId(v))) continue;
    auto& number = of_root[partition.root(v)];
    if (!number) number = result.count++;
    result.of[v] = number;
  }
  return result;
}

/// Joins all of them that are not known.
template <class Known>
void link(base::Partition& partition, const std::vector<VariableId>& variables, std::optional<VariableId> with,
          const Known& known) {
  for (const VariableId v : variables) {
    if (known(v)) continue;
    if (with) partition.join(v.index(), with->index());
    if (!with) with = v;
  }
}

}  // namespace

Dependencies::Dependencies(const Plant& plant, std::vector<Constraint> constraints)
    : plant_(plant), index_(plant), read_by_store_(plant.variables.size()), observed_(plant.variables.size()) {
  for (Constraint& constraint : constraints) {
    std::vector<VariableId> variables = variables_of(constraint.formula);
    for (const VariableId v : variables) read_by_store_[v.index()] = true;
    constraints_.push_back({std::move(constraint), std::move(variables)});
  }
  for (const VariableId v : plant.observables) observed_[v.index()] = true;
}

bool Dependencies::only_commanded(VariableId variable) const {
  return index_.control_of(variable) && !read_by_store(variable) && !observed_[variable.index()];
}

template <class Known>
Classes Dependencies::linked_by_conjuncts(const Known& known) const {
  base::Partition partition(index_.variables());
  for (const Reading& reading : constraints_) link(partition, reading.variables, std::nullopt, known);
  return classes_of(partition, index_.variables(), known);
}

template <class Known>
Classes Dependencies::linked_by_components(const Known& known) const {
  base::Partition partition(index_.variables());
  for (const Interconnection& q : plant_.interconnections) {
    link(partition, variables_of(q.constraint), std::nullopt, known);
  }
  for (const Component& component : plant_.components) {
    for (const Mode& mode : component.modes) link(partition, variables_of(mode.constraint), component.mode, known);
    for (const Transition& t : component.transitions) link(partition, variables_of(t.guard), component.mode, known);
  }
  return classes_of(partition, index_.variables(), known);
}

Classes Dependencies::islands() const {
  return linked_by_conjuncts([this](VariableId v) { return index_.component_of(v).has_value(); });
}

Classes Dependencies::regions() const {
  return linked_by_conjuncts([this](VariableId v) { return index_.component_of(v) || index_.control_of(v); });
}

Classes Dependencies::parts() const {
  return linked_by_components([](VariableId) { return false; });
}

Classes Dependencies::groups() const {
  return linked_by_components([this](VariableId v) { return only_commanded(v); });
}

}  // namespace rmpl::automata
