// The goal interpreter: which state to bring the plant to (semantics 5; thesis 6.3.1).
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "automata/state.hpp"
#include "automata/step/plant_step.hpp"
#include "runtime/reasoning/ocsp/ocsp.hpp"
#include "runtime/reasoning/reconfigure/goal.hpp"
#include "runtime/reasoning/reconfigure/nominal_graph.hpp"

namespace rmpl::runtime {

/// Why there is no goal state, or no way to it.
struct Impasse {
  std::optional<automata::ComponentId> component;  ///< to blame, where there is one
  std::string reason;
};

/// Chooses, over the modes that each component reaches (`NominalGraph::reachable`), the state that is consistent,
/// entails the goal, and has the greatest summed reward; of several the first in declaration order of components, then
/// modes. An OCSP solved by conflict-directed best-first search, as in Fig. 6-16.
class GoalInterpreter {
 public:
  GoalInterpreter(automata::PlantStep& step, const NominalGraph& graph) : step_(step), graph_(graph) {}

  using Reachable = std::vector<std::vector<bool>>;  ///< per component, per mode
  /// What the last interpretation of a goal chose, and among which modes: the choice depends on nothing else, and along
  /// a plan the reachable modes stay as they are.
  struct Choice {
    Reachable possible;
    automata::Modes state;
  };

  /// `last`: of the same goal, if there was one; takes the new choice.
  std::variant<automata::Modes, Impasse> interpret(const automata::Modes& modes, const Goal& goal,
                                                   std::optional<Choice>& last);
  /// How many candidates the last interpretation checked; none where the choice was known.
  [[nodiscard]] std::size_t checked() const { return checked_; }

 private:
  std::optional<Conflict> refuted(std::span<const std::uint32_t> values);
  Impasse out_of_reach(const automata::Modes& modes, const Goal& goal, const Reachable& reachable,
                       automata::ComponentId component, std::vector<bool> asked);
  Impasse impasse(const automata::Modes& modes, const Goal& goal, const Reachable& reachable);

  automata::PlantStep& step_;
  const NominalGraph& graph_;
  std::size_t checked_ = 0;
};

}  // namespace rmpl::runtime
