// What components come to over their nominal transitions, looked at one by one: too much at most, never too little.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "automata/state.hpp"
#include "base/function_ref.hpp"
#include "runtime/reasoning/nominal/nominal_graph.hpp"

namespace rmpl::runtime {

/// By component, by mode: whether it is come to.
using Reached = std::vector<std::vector<bool>>;

/// Nothing but the modes.
Reached only(const NominalGraph& graph, const automata::Modes& modes);

/// Whether what is reached meets each requirement of some precondition, one by one.
bool supported(const NominalGraph& graph, const NominalTransition& transition, const Reached& reached);

/// Whether the transition may come with all controls idle from what is reached.
bool comes_by_itself(const NominalGraph& graph, automata::ComponentId component, const NominalTransition& transition,
                     const Reached& reached);

/// Adds what the usable transitions lead to, which may come to depend on what was reached. What depends on a component
/// that has come further is looked at again.
void spread(const NominalGraph& graph, Reached& reached,
            base::FunctionRef<bool(automata::ComponentId, const NominalTransition&)> usable);

/// Adds what may come with all controls idle.
void spread_at_rest(const NominalGraph& graph, Reached& reached);

}  // namespace rmpl::runtime
