// Supports, by a partition of the attributes.
// SPDX-License-Identifier: MIT
#include "automata/store/support.hpp"

#include <algorithm>
#include <bit>

#include "base/partition.hpp"

namespace rmpl::automata {
namespace {

template <class T>
void merge(std::vector<T>& into, const std::vector<T>& from) {
  std::vector<T> both;
  std::set_union(into.begin(), into.end(), from.begin(), from.end(), std::back_inserter(both));
  into = std::move(both);
}

template <class T>
void insert(std::vector<T>& into, const T& element) {
  const auto at = std::lower_bound(into.begin(), into.end(), element);
  if (at == into.end() || *at != element) into.insert(at, element);
}

}  // namespace

void Support::join(const Support& other) {
  merge(components, other.components);
  merge(controls, other.controls);
}

bool Support::reads(ComponentId component) const {
  return std::binary_search(components.begin(), components.end(), component);
}

bool Support::reads_control(std::size_t control) const {
  return std::binary_search(controls.begin(), controls.end(), control);
}

Locality::Locality(const Plant& plant)
    : island_of_(plant.variables.size()), component_of_(plant.variables.size()), control_of_(plant.variables.size()) {
  for (std::size_t c = 0; c < plant.components.size(); ++c) {
    component_of_[plant.components[c].mode.index()] = ComponentId(c);
  }
  for (std::size_t i = 0; i < plant.controls.size(); ++i) control_of_[plant.controls[i].variable.index()] = i;

  std::vector<Constraint> constraints = constraints_of(plant);
  base::Partition partition(plant.variables.size());
  for (const Constraint& constraint : constraints) {
    std::optional<std::size_t> hub;
    for (const VariableId v : variables_of(constraint.formula)) {
      if (component_of_[v.index()]) continue;
      if (hub) partition.join(*hub, v.index());
      hub = v.index();
    }
  }
  for (std::size_t v = 0; v < plant.variables.size(); ++v) {
    if (component_of_[v]) continue;
    const std::size_t root = partition.root(v);
    if (root == v) {
      island_of_[v] = islands_.size();
      islands_.emplace_back();
    }
    island_of_[v] = island_of_[root];
    Island& island = islands_[*island_of_[v]];
    island.attributes.emplace_back(v);
    if (control_of_[v]) insert(island.support.controls, *control_of_[v]);
  }
  for (Constraint& constraint : constraints) {
    const std::vector<VariableId> variables = variables_of(constraint.formula);
    const auto attribute = std::find_if(variables.begin(), variables.end(),
                                        [&](VariableId v) { return !component_of_[v.index()].has_value(); });
    // A constraint on modes alone is an island without attributes.
    if (attribute == variables.end()) islands_.emplace_back();
    Island& island = attribute == variables.end() ? islands_.back() : islands_[*island_of_[attribute->index()]];
    if (constraint.under) insert(island.support.components, *component_of_[constraint.under->variable.index()]);
    for (const VariableId v : variables) {
      if (component_of_[v.index()]) insert(island.support.components, *component_of_[v.index()]);
    }
    island.constraints.push_back(std::move(constraint));
  }
}

Support Locality::support_of(const Formula& formula) const {
  Support result;
  for (const VariableId v : variables_of(formula)) {
    if (component_of_[v.index()]) insert(result.components, *component_of_[v.index()]);
    if (island_of_[v.index()]) result.join(islands_[*island_of_[v.index()]].support);
  }
  return result;
}

Projection::Projection(const Plant& plant, const Support& support) {
  for (const ComponentId c : support.components) place(c.index(), plant[c].modes.size(), modes_);
  for (const std::size_t i : support.controls) {
    place(i, plant.variables[plant.controls[i].variable].values.size(), controls_);
  }
}

void Projection::place(std::size_t position, std::size_t values, std::vector<Field>& fields) {
  const std::size_t width = static_cast<std::size_t>(std::bit_width(values - 1));
  if (width == 0) return;
  if (width > 64 - bits_ % 64) bits_ += 64 - bits_ % 64;
  fields.push_back({static_cast<std::uint32_t>(position), static_cast<std::uint32_t>(bits_)});
  bits_ += width;
}

void Projection::read(const Modes& modes, const ControlAction& action, Key& key) const {
  key.assign((bits_ + 63) / 64, 0);
  for (const Field& f : modes_) key[f.shift / 64] |= std::uint64_t{modes[f.position].value} << (f.shift % 64);
  for (const Field& f : controls_) key[f.shift / 64] |= std::uint64_t{action[f.position].value} << (f.shift % 64);
}

}  // namespace rmpl::automata
