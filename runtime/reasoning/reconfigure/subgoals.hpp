// The next command towards a goal whose game is too large: a goal for one component after the other (semantics 5,
// "Goals of single components").
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <set>
#include <tuple>
#include <vector>

#include "automata/state.hpp"
#include "automata/step/plant_step.hpp"
#include "runtime/reasoning/game/strategist.hpp"
#include "runtime/reasoning/nominal/nominal_graph.hpp"
#include "runtime/reasoning/reconfigure/causal_order.hpp"
#include "runtime/reasoning/reconfigure/goal.hpp"
#include "runtime/reasoning/reconfigure/goal_interpreter.hpp"
#include "runtime/reasoning/reconfigure/recent_goals.hpp"
#include "runtime/reasoning/reconfigure/reconfigurer.hpp"

namespace rmpl::runtime {

/// The goal interpreter chooses a goal state. Its components come to their modes one after the other, what is
/// downstream first; what the next step of one needs of others is their goal before that (Williams and Nayak 1997; Wang
/// and Williams 2015). Each step is the strategy of a game of its own, of that component and all that it disturbs, the
/// others held: it does no more harm than any strategy. Such an answer is not proved best. Keeps references.
///
/// Cost of an answer: the search for the goal state, and a small game for the steps that are tried.
class Subgoals {
 public:
  Subgoals(automata::PlantStep& step, const NominalGraph& graph, std::shared_ptr<PlantGames> common = nullptr);

  /// From possible modes.
  Reconfiguration next(const automata::Modes& modes, const Goal& goal);

 private:
  /// A component, and the modes of which it is to come to one, ascending.
  struct Wanted {
    automata::ComponentId component;
    std::vector<automata::ValueId> modes;
  };
  /// What is tried no more: a transition, by way of one of its preconditions.
  using Barred = std::set<std::tuple<automata::ComponentId, automata::TransitionId, std::size_t>>;
  /// The first step of a way, with the precondition by which it is to be taken.
  struct Step {
    const NominalTransition* transition;
    std::size_t precondition;
    std::optional<Wanted> before;  ///< what it needs first
  };

  std::optional<Reconfiguration> achieve(const automata::Modes& modes, const Goal& goal, const Wanted& wanted);
  std::optional<Step> first_step(const automata::Modes& modes, const Goal& goal, const Wanted& wanted,
                                 const Barred& barred, const std::vector<bool>& under_way) const;
  /// Of the modes of others that a precondition requires: how many are not there, and the one most downstream.
  struct Lack {
    std::size_t count = 0;
    std::optional<Wanted> first = std::nullopt;
  };
  [[nodiscard]] Lack lacking(const automata::Modes& modes, const Precondition& precondition,
                             automata::ComponentId component) const;
  std::optional<Reconfiguration> take(const automata::Modes& modes, const Wanted& wanted, const NominalTransition& t);
  bool still_come(const std::vector<TransitionOf>& awaited, const automata::Modes& modes);
  Reconfiguration not_found(const automata::Modes& modes, const Goal& goal, automata::ComponentId component,
                            automata::ModeId mode);
  [[nodiscard]] std::optional<std::uint32_t> open_part(const automata::Modes& modes, const Goal& goal,
                                                       automata::ComponentId served);

  automata::PlantStep& step_;
  const NominalGraph& graph_;
  std::shared_ptr<PlantGames> common_;
  CausalOrder order_;
  GoalInterpreter interpreter_;
  RecentGoals<std::unique_ptr<Strategist>> steps_;  ///< asked again cycle by cycle, and in other goals
};

}  // namespace rmpl::runtime
