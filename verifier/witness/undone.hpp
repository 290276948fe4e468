// What a program has achieved by its goals, and what a command takes away that no goal asks for (semantics 7).
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "automata/step/plain_step.hpp"
#include "automata/step/plant_step.hpp"
#include "runtime/reasoning/reconfigure/reason.hpp"
#include "verifier/witness/witness.hpp"

namespace rmpl::verifier {

/// The components in a mode that a goal assigned in some cycle in whose end they were in it, and that they have not
/// left since; ascending.
using Achieved = std::vector<automata::ComponentId>;

/// After a cycle that asserts `goal` and leads from one to the other modes.
Achieved achieved_after(const automata::Plant& plant, const Achieved& before,
                        const std::vector<automata::Assignment>& goal, const automata::Modes& from,
                        const automata::Modes& to);

/// A cycle: what it asserts, what is commanded and why, and where it leads.
struct CycleTaken {
  const std::vector<automata::Assignment>& goal;
  runtime::Reason::Purpose purpose;
  const automata::ControlAction& action;
  const automata::Modes& from;
  const automata::Modes& to;
};

/// Those of `achieved` that the cycle takes away: its command is for reward alone, the goal asks for no other mode of
/// the component, which goes to a mode that is no fault and that no transition would lead to with all controls idle.
Achieved taken_away(automata::PlantStep& step, const Achieved& achieved, const CycleTaken& cycle);
/// The same, by the rules that remember nothing.
Achieved taken_away(automata::PlainStep& rules, const Achieved& achieved, const CycleTaken& cycle);

/// What the last cycle of a run that is known to its end takes away: the first such component.
std::optional<Undone> undone_at_end(automata::PlainStep& rules, const Witness& witness);

}  // namespace rmpl::verifier
