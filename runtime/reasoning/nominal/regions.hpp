// Regions: the attributes that constraints join once modes and controls are fixed.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "automata/plant.hpp"
#include "automata/state.hpp"

namespace rmpl::runtime {

/// A partition of a plant's attributes: those of one region cannot make a formula over another one true or false in a
/// consistent state. Modes and controls, the decisions, are in no region.
class Regions {
 public:
  struct Region {
    std::vector<automata::VariableId> attributes;
    std::vector<automata::VariableId> decisions;  ///< modes and controls that its constraints read, ascending
  };

  /// Of the plant's first `variables` variables; no constraint reads the others.
  Regions(const automata::Plant& plant, std::size_t variables);

  /// Null for a decision.
  [[nodiscard]] const Region* of(automata::VariableId variable) const {
    const auto region = region_of_[variable.index()];
    return region ? &regions_[*region] : nullptr;
  }
  /// Attributes that stand in one constraint with it.
  [[nodiscard]] const std::vector<automata::VariableId>& neighbours(automata::VariableId variable) const {
    return neighbours_[variable.index()];
  }
  /// Modes whose constraint reads it.
  [[nodiscard]] const std::vector<automata::Assignment>& readers(automata::VariableId variable) const {
    return readers_[variable.index()];
  }

 private:
  std::vector<Region> regions_;
  std::vector<std::optional<std::size_t>> region_of_;          ///< by variable
  std::vector<std::vector<automata::VariableId>> neighbours_;  ///< by variable
  std::vector<std::vector<automata::Assignment>> readers_;     ///< by variable
};

}  // namespace rmpl::runtime
