// Parts: the parts of a plant that share no constraint, so that what is done to one never touches another.
// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "automata/plant.hpp"

namespace rmpl::runtime {

/// The connected parts of the constraint graph: two variables are joined where an interconnection, a mode constraint or
/// a guard reads both, and a component's mode variable is joined with all that its constraints and guards read.
/// Commands, modes and consistency of one part do not depend on any other: each is planned on its own.
class Parts {
 public:
  /// With `joined`, the parts of these components count as one.
  explicit Parts(const automata::Plant& plant, std::span<const automata::ComponentId> joined = {});

  [[nodiscard]] std::size_t count() const { return components_.size(); }
  [[nodiscard]] std::size_t of(automata::ComponentId component) const { return of_component_[component.index()]; }
  /// In declaration order; a part without components is only a few unused attributes.
  [[nodiscard]] const std::vector<automata::ComponentId>& components(std::size_t part) const {
    return components_[part];
  }
  /// All variables of a part, modes, attributes and controls, in declaration order.
  [[nodiscard]] const std::vector<automata::VariableId>& variables(std::size_t part) const { return variables_[part]; }
  /// Positions in `Plant::controls`, ascending.
  [[nodiscard]] const std::vector<std::size_t>& controls(std::size_t part) const { return controls_[part]; }

 private:
  std::vector<std::size_t> of_component_;
  std::vector<std::vector<automata::ComponentId>> components_;
  std::vector<std::vector<automata::VariableId>> variables_;
  std::vector<std::vector<std::size_t>> controls_;
};

}  // namespace rmpl::runtime
