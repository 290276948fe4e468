// Preconditions: what must hold of other components' modes and of the controls for a guard to be implied.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "automata/dependencies/plant_index.hpp"
#include "automata/plant.hpp"

namespace rmpl::runtime {

/// A mode variable or a control variable must have one of these values (sorted, at least one).
struct Requirement {
  automata::VariableId variable;
  std::vector<automata::ValueId> values;
  auto operator<=>(const Requirement&) const = default;
};

/// Requirements, in order of variable, that together with the component's own mode make the store imply a guard,
/// whichever of the permitted values are taken. None of them can be left out.
using Precondition = std::vector<Requirement>;

/// The preconditions of a guard, and whether they are all that it has.
struct FoundPreconditions {
  std::vector<Precondition> preconditions;
  bool all = true;
};

/// Whether a precondition can be met with every control at its idle value.
bool needs_no_command(const automata::Plant& plant, const automata::PlantIndex& index,
                      const Precondition& precondition);
/// How many controls it needs off their idle values.
std::size_t commanded_controls(const automata::Plant& plant, const automata::PlantIndex& index,
                               const Precondition& precondition);

/// That all requirements are met.
automata::Formula formula_of(const Precondition& precondition);
/// Whether whatever fits `narrow` fits `wide` too.
bool subsumes(const Precondition& wide, const Precondition& narrow);
/// What fits both; nothing where they exclude each other.
std::optional<Precondition> both(const Precondition& left, const Precondition& right);

}  // namespace rmpl::runtime
