// The goal interpreter: which state to bring the plant to where the game is too large, and why there is none (semantics
// 5, "Goals of single components"; thesis 6.3.1).
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <variant>
#include <vector>

#include "automata/state.hpp"
#include "automata/step/plant_step.hpp"
#include "runtime/reasoning/nominal/nominal_graph.hpp"
#include "runtime/reasoning/ocsp/ocsp.hpp"
#include "runtime/reasoning/reconfigure/goal.hpp"
#include "runtime/reasoning/reconfigure/impasse.hpp"
#include "runtime/reasoning/reconfigure/reachable_modes.hpp"

namespace rmpl::runtime {

/// Chooses, over the modes that each component can be brought to, the state that is consistent and entails the goal.
/// The first by: fewest components that take irreversible steps; fewest components moved; fewest moved to modes that
/// they leave by themselves and that the goal does not name; the better rewards; then by modes, components in
/// declaration order. An OCSP solved by conflict-directed best-first search, as in Fig. 6-16. Keeps references.
class GoalInterpreter {
 public:
  GoalInterpreter(automata::PlantStep& step, const NominalGraph& graph);

  /// The goal state; what bars the way where there is none.
  std::variant<automata::Modes, Impasse> interpret(const automata::Modes& modes, const Goal& goal,
                                                   const ReachableModes& reach);

  /// Whether the store of these modes implies the goal.
  bool entailed(const automata::Modes& modes, const Goal& goal);

 private:
  using Possible = std::vector<std::vector<bool>>;  ///< per component, per mode
  [[nodiscard]] OptimalSearch::Costs costs(const automata::Modes& modes, const Goal& goal, const ReachableModes& reach,
                                           const Possible& possible) const;
  std::optional<std::vector<automata::ComponentId>> refuted(const automata::Modes& candidate, const Goal& goal,
                                                            bool local, const Possible& possible);
  [[nodiscard]] bool reads_modes(const std::vector<automata::VariableId>& variables) const;
  /// Whether the argument of `refuted_by_world` holds: neither Q, nor a mode constraint, nor the goal reads a mode.
  [[nodiscard]] bool is_local(const Goal& goal) const;
  Impasse out_of_reach(const automata::Modes& modes, const ReachableModes& reach, automata::ComponentId component,
                       std::vector<bool> asked);
  std::optional<Impasse> barred_mode(const automata::Modes& modes, const Goal& goal, const ReachableModes& reach);
  Impasse impasse(const automata::Modes& modes, const Goal& goal, const ReachableModes& reach);

  automata::PlantStep& step_;
  const NominalGraph& graph_;
  bool store_reads_modes_;
};

}  // namespace rmpl::runtime
