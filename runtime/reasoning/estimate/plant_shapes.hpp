// Plants that are the same but for names: all that a step function tells of one holds for the others.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <unordered_map>
#include <vector>

#include "automata/plant.hpp"

namespace rmpl::runtime {

/// Whether two plants differ in nothing but the names of components, types and variables, and in where these were
/// written: their variables, components and modes have the same positions, values and numbers.
bool same_but_for_names(const automata::Plant& a, const automata::Plant& b);

/// One plant of each shape. References to plants stay valid.
class PlantShapes {
 public:
  /// The position of a plant that is the same but for names; of this one where there is none.
  std::size_t find_or_add(automata::Plant plant);
  [[nodiscard]] std::size_t size() const { return plants_.size(); }
  [[nodiscard]] const automata::Plant& operator[](std::size_t shape) const { return plants_[shape]; }

 private:
  std::deque<automata::Plant> plants_;
  std::unordered_map<std::uint64_t, std::vector<std::size_t>> by_hash_;  ///< looked up, never iterated
};

}  // namespace rmpl::runtime
