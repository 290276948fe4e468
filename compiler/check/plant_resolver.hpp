// Constraints about a plant and the executive that flies it: of expectations and properties.
// SPDX-License-Identifier: MIT
#pragma once

#include "automata/plant.hpp"
#include "compiler/check/resolve.hpp"

namespace rmpl::compiler {

/// Knows which variables are modes of components. Keeps a reference to the plant.
class PlantResolver final : public Resolver {
 public:
  PlantResolver(const automata::Plant& plant, const std::vector<grammar::Span>* declared,
                grammar::Diagnostics& diagnostics)
      : Resolver({plant.variables, declared, "plant " + backquoted(plant.name), grammar::Code::not_in_plant,
                  software_of(plant)},
                 diagnostics),
        plant_(plant) {}

  [[nodiscard]] bool is_component(automata::VariableId variable) const override {
    return plant_.component_of(variable).has_value();
  }

 private:
  const automata::Plant& plant_;
};

}  // namespace rmpl::compiler
