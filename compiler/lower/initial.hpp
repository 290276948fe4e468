// Initial distributions: of a component type, or of one instance.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "automata/plant.hpp"
#include "grammar/ast/plant.hpp"
#include "grammar/source/diagnostic.hpp"

namespace rmpl::compiler {

/// Per mode of the component, the probability of starting in it; they sum to 1. A mode without a number is certain.
/// Nothing where something is wrong; then it has been reported.
std::optional<std::vector<double>> initial_distribution(const grammar::Initial& initial,
                                                        const automata::Component& component,
                                                        grammar::Diagnostics& diagnostics);

}  // namespace rmpl::compiler
