// A component of a plant as a picture, in the manner of thesis Fig. 6-4.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

#include "automata/plant.hpp"

namespace rmpl::compiler {

/// The timed constraint automaton of a component in DOT: modes with their constraints and rewards, fault modes dashed
/// and apart; arrows with guards, bounds, densities and weights; from a filled dot to the initial modes. Transitions
/// that lead alike from every mode, or from every nominal one, are a single arrow from a note that says so. Attributes
/// are named as in the component's type: without the instance. `name` and `kind` stand at the top.
/// Each mode is a node `m1`, by its number from 1; each transition stands in the `id` of one edge, `t1_2_5`.
std::string component_diagram(const automata::Plant& plant, const automata::Component& component, std::string_view name,
                              std::string_view kind);

}  // namespace rmpl::compiler
