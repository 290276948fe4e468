// Comparison of plants, part by part.
// SPDX-License-Identifier: MIT
#include "runtime/reasoning/estimate/plant_shapes.hpp"

#include <algorithm>
#include <bit>
#include <utility>

#include "base/hash.hpp"

namespace rmpl::runtime {
namespace {

using automata::Component;
using automata::Mode;
using automata::Plant;
using automata::Transition;

bool same(const Mode& a, const Mode& b) {
  return a.fault == b.fault && a.reward == b.reward && a.constraint == b.constraint;
}

bool same(const Transition& a, const Transition& b) {
  return a.from == b.from && a.to == b.to && a.branch == b.branch && a.restart == b.restart &&
         a.consequence == b.consequence && a.weight == b.weight && a.timing == b.timing && a.guard == b.guard;
}

bool same(const Component& a, const Component& b);

template <class Part>
bool same(const std::vector<Part>& a, const std::vector<Part>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const Part& x, const Part& y) { return same(x, y); });
}

bool same(const Component& a, const Component& b) {
  return a.mode == b.mode && a.progress == b.progress && a.initial == b.initial && same(a.modes, b.modes) &&
         same(a.transitions, b.transitions);
}

/// Equal where plants are the same but for names.
std::uint64_t hash_of(const Plant& plant) {
  std::uint64_t hash = base::mix(base::hash_seed, plant.interconnections.size());
  for (const automata::Variable& variable : plant.variables) hash = base::mix(hash, variable.values.size());
  for (const Component& component : plant.components) {
    hash = base::mix(hash, component.mode.value);
    for (const double initial : component.initial) hash = base::mix(hash, std::bit_cast<std::uint64_t>(initial + 0.0));
    for (const Transition& t : component.transitions) {
      hash = base::mix(hash, std::uint64_t{t.from.value} << 32 | t.to.value);
      hash = base::mix(hash, std::bit_cast<std::uint64_t>(t.weight.value + 0.0));
    }
  }
  return hash;
}

}  // namespace

bool same_but_for_names(const Plant& a, const Plant& b) {
  return std::equal(a.variables.begin(), a.variables.end(), b.variables.begin(), b.variables.end(),
                    [](const auto& x, const auto& y) { return x.values == y.values; }) &&
         a.controls == b.controls && a.observables == b.observables && same(a.components, b.components) &&
         std::equal(a.interconnections.begin(), a.interconnections.end(), b.interconnections.begin(),
                    b.interconnections.end(),
                    [](const auto& x, const auto& y) { return x.constraint == y.constraint; });
}

std::size_t PlantShapes::find_or_add(Plant plant) {
  std::vector<std::size_t>& alike = by_hash_[hash_of(plant)];
  const auto known = std::find_if(alike.begin(), alike.end(),
                                  [&](std::size_t shape) { return same_but_for_names(plants_[shape], plant); });
  if (known != alike.end()) return *known;
  alike.push_back(plants_.size());
  plants_.push_back(std::move(plant));
  return alike.back();
}

}  // namespace rmpl::runtime
