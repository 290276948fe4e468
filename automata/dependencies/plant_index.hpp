// What a variable of a plant is: the mode of a component, a control, or an attribute of another kind.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "automata/plant.hpp"

namespace rmpl::automata {

/// The inverse of the declarations, for look-ups that are made often. Keeps nothing of the plant.
class PlantIndex {
 public:
  explicit PlantIndex(const Plant& plant);

  /// The component whose mode variable this is.
  [[nodiscard]] std::optional<ComponentId> component_of(VariableId variable) const {
    return component_of_[variable.index()];
  }
  /// The position in `Plant::controls`.
  [[nodiscard]] std::optional<std::size_t> control_of(VariableId variable) const {
    return control_of_[variable.index()];
  }
  [[nodiscard]] std::size_t variables() const { return component_of_.size(); }

 private:
  std::vector<std::optional<ComponentId>> component_of_;  ///< by variable
  std::vector<std::optional<std::size_t>> control_of_;    ///< by variable
};

}  // namespace rmpl::automata
