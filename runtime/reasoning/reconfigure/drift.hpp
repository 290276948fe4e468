// What components come to by themselves (semantics 5).
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "automata/state.hpp"
#include "base/function_ref.hpp"
#include "runtime/reasoning/reconfigure/nominal_graph.hpp"
#include "runtime/reasoning/reconfigure/rewards.hpp"

namespace rmpl::runtime {

/// By component, by mode: whether it is come to. Components without an entry are left out.
using Reached = std::vector<std::vector<bool>>;

/// By all components: nothing but the modes.
Reached only(const NominalGraph& graph, const automata::Modes& modes);

/// Whether the modes come to meet each requirement, one by one.
bool supported(const NominalGraph& graph, const Precondition& precondition, const Reached& reached);

/// Whether the transition may come with all controls idle where the modes come to meet what it requires.
bool comes_by_itself(const NominalGraph& graph, const NominalTransition& transition, const Reached& reached);

/// Adds what the transitions that are `usable` lead to, which may come to depend on what was reached. Begins with the
/// `components`; what one reaches is looked at again where one that it depends on has come further.
void spread(const NominalGraph& graph, Reached& reached, const std::vector<automata::ComponentId>& components,
            base::FunctionRef<bool(automata::ComponentId, const NominalTransition&)> usable);

/// Which transitions of those that need no command count.
enum class Drift { any, untimed };

/// Adds what nominal transitions lead to with all controls idle. More than can be, never less: each component is looked
/// at by itself, with others in any of the modes that they may come to.
void drift(const NominalGraph& graph, Reached& reached, const std::vector<automata::ComponentId>& components,
           Drift how = Drift::any);
/// Whether a transition may be taken so, by what is reached.
bool drifts(const NominalGraph& graph, automata::ComponentId component, const NominalTransition& transition,
            const Reached& reached);
/// From some modes, all components.
Reached drift_from(const NominalGraph& graph, const automata::Modes& modes, Drift how = Drift::any);

/// What is sure of the rewards: the least of those of the modes come to, summed over components. With nothing commanded
/// it never becomes less.
std::int64_t lasting_reward(const WholeRewards& rewards, const Reached& reached,
                            const std::vector<automata::ComponentId>& components);

}  // namespace rmpl::runtime
