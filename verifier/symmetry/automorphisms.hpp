// Automorphisms of a plant: renamings of components and of their modes under which it stays the same.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "automata/plant.hpp"

namespace rmpl::verifier {

/// What is done to one component: it becomes `to`, and its mode m becomes mode `modes[m]` of that.
struct Renaming {
  std::uint32_t component;
  std::uint32_t to;
  std::vector<std::uint32_t> modes;
  auto operator<=>(const Renaming&) const = default;
};

/// A permutation of the pairs of component and mode, told by what it does not leave as it is; sorted by component.
using Permutation = std::vector<Renaming>;

/// `first`, then `second`.
Permutation composed(const Permutation& first, const Permutation& second);
Permutation inverse(const Permutation& permutation);

/// Generators of the group of all permutations that, together with some renaming of attributes and their values, leave
/// alone: the transitions with their guards, bounds and weights; the mode constraints and interconnections; which modes
/// are faults; what can be the initial modes, with `from` in place of those of its components; what idle controls are;
/// and each of the `formulas`. Found as automorphisms of a coloured graph that has a vertex for everything named here
/// (T. Junttila, P. Kaski: Engineering an Efficient Canonical Labeling Tool for Large and Sparse Graphs, 2007).
///
/// None for plants so large that the graph would pass a million vertices.
std::vector<Permutation> automorphisms(const automata::Plant& plant, const std::vector<automata::Formula>& formulas,
                                       const std::vector<automata::Assignment>& from);

}  // namespace rmpl::verifier
