// A switch for each mode.
// SPDX-License-Identifier: MIT
#include "compiler/lint/plant/exclusions.hpp"

namespace rmpl::compiler {

void add_exclusions(automata::Variables& variables, const automata::Plant& plant) {
  for (const automata::Component& component : plant.components) {
    for (const automata::Mode& mode : component.modes) {
      variables.add({component.name + " is not in " + mode.name, {"no", "yes"}});
    }
  }
}

}  // namespace rmpl::compiler
