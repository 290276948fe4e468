// Components as JSON, and back.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "automata/json/node.hpp"
#include "automata/plant.hpp"

namespace rmpl::automata {

Json component_to_json(const Component& component, const Variables& variables);
/// Its mode variable, of the same name, and its attributes are among `variables`.
Component component_from_json(const Node& node, const Variables& variables);

/// The probabilities of starting in each mode of a component.
std::vector<double> initial_from_json(const Node& node, const Component& component);

}  // namespace rmpl::automata
