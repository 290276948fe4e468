// Which way an interconnection is best drawn: from what brings a value about to what reads it.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "automata/plant.hpp"

namespace rmpl::compiler {

/// The two ends of an interconnection; constraints have no direction, so this serves the layout alone.
struct Flow {
  std::vector<automata::VariableId> from;
  std::vector<automata::VariableId> to;
  auto operator<=>(const Flow&) const = default;
};

/// Per variable, whether its component reads it: in a guard, or in a mode as what something else depends on.
std::vector<bool> read_variables(const automata::Plant& plant);

/// What is read is at the end; where that does not tell, what stands alone before `<->`, or else all but the first as
/// written. Each variable once; of a constraint with several, neither end is empty.
Flow flow_of(const automata::Formula& constraint, const std::vector<bool>& read);

}  // namespace rmpl::compiler
