// Which steps of a component cannot be undone (semantics 5).
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "automata/plant.hpp"
#include "runtime/reasoning/nominal/nominal_graph.hpp"

namespace rmpl::runtime {

/// Marks the transitions of one component that cannot be undone. `leads`: by mode, where these transitions lead.
///
/// A step is irreversible where nominal transitions do not lead back from its target. A step out of a broken mode is
/// irreversible where its target cannot come to any usual mode from which the component breaks so. A mode is broken
/// if it is a fault mode, or is come to only by way of one: so a reset in two steps is a repair, and a backup pyro is
/// irreversible. Where nothing leads into a fault, leaving it gives nothing up.
void mark_irreversible(const automata::Component& component, const std::vector<std::vector<bool>>& leads,
                       std::vector<NominalTransition>& transitions);

}  // namespace rmpl::runtime
