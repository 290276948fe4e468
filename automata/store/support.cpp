// Supports, by a partition of the attributes.
// SPDX-License-Identifier: MIT
#include "automata/store/support.hpp"

#include <algorithm>
#include <bit>

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

Locality::Locality(const Dependencies& dependencies, Commanded commanded)
    : index_(dependencies.index()),
      island_of_(commanded == Commanded::yes ? dependencies.regions() : dependencies.islands()),
      islands_(island_of_.count) {
  for (std::size_t v = 0; v < index_.variables(); ++v) {
    const auto island = island_of_.of[v];
    if (!island) continue;
    islands_[*island].attributes.emplace_back(v);
    if (const auto control = index_.control_of(VariableId(v))) insert(islands_[*island].support.controls, *control);
  }
  for (const Dependencies::Reading& reading : dependencies.constraints()) {
    const auto attribute = std::find_if(reading.variables.begin(), reading.variables.end(),
                                        [&](VariableId v) { return island_of_[v].has_value(); });
    // A constraint on modes alone is an island without attributes.
    if (attribute == reading.variables.end()) islands_.emplace_back();
    Island& island = attribute == reading.variables.end() ? islands_.back() : islands_[*island_of_[*attribute]];
    const auto& under = reading.constraint.under;
    if (under) insert(island.support.components, *index_.component_of(under->variable));
    for (const VariableId v : reading.variables) {
      if (const auto component = index_.component_of(v)) insert(island.support.components, *component);
      if (const auto control = index_.control_of(v)) insert(island.support.controls, *control);
    }
    island.constraints.push_back(reading.constraint);
  }
}

Support Locality::support_of(const Formula& formula) const {
  Support result;
  for (const VariableId v : variables_of(formula)) {
    if (const auto component = index_.component_of(v)) insert(result.components, *component);
    if (const auto control = index_.control_of(v)) insert(result.controls, *control);
    if (const auto island = island_of_[v]) result.join(islands_[*island].support);
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
