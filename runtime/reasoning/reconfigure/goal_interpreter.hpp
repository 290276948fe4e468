// The goal interpreter: which state to bring the plant to (semantics 5; thesis 6.3.1).
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>
#include <variant>
#include <vector>

#include "automata/state.hpp"
#include "automata/step/plant_step.hpp"
#include "runtime/reasoning/ocsp/ocsp.hpp"
#include "runtime/reasoning/reconfigure/goal.hpp"
#include "runtime/reasoning/reconfigure/impasse.hpp"
#include "runtime/reasoning/reconfigure/nominal_graph.hpp"
#include "runtime/reasoning/reconfigure/prospects.hpp"
#include "runtime/reasoning/reconfigure/rewards.hpp"

namespace rmpl::runtime {

/// Chooses, over the modes that each component can be aimed at, the state that is consistent, entails the goal and has
/// a plan. The first by: fewest irreversible steps; fewest components moved that are not commandable; fewest moved to
/// modes that they leave by themselves and that the goal does not name; greatest summed reward; fewest components
/// moved; then by modes, components in declaration order. An OCSP solved by conflict-directed best-first search, as in
/// Fig. 6-16: that there is no plan is one more conflict.
class GoalInterpreter {
 public:
  GoalInterpreter(automata::PlantStep& step, const NominalGraph& graph);

  /// Nothing where a candidate has a plan; else those of its modes that cannot be come to together.
  using HasPlan = std::function<std::optional<std::vector<automata::ComponentId>>(const automata::Modes& candidate)>;
  /// The goal state; an impasse where none is left. Candidates that `has_plan` refuses are told to it one by one.
  std::variant<automata::Modes, Impasse> interpret(const automata::Modes& modes, const Goal& goal,
                                                   const Prospects& prospects, const HasPlan& has_plan);

  /// A smallest set of the changes that, made alone, is consistent and entails the goal; of several the first in
  /// declaration order. In that order.
  std::vector<automata::ComponentId> needed(const automata::Modes& modes, const automata::Modes& target,
                                            const Goal& goal);

  /// Whether the store of these modes implies the goal.
  bool entailed(const automata::Modes& modes, const Goal& goal);

  [[nodiscard]] const WholeRewards& rewards() const { return rewards_; }
  /// How many candidates the last interpretation checked.
  [[nodiscard]] std::size_t checked() const { return checked_; }

 private:
  using Possible = std::vector<std::vector<bool>>;  ///< per component, per mode
  OptimalSearch::Costs costs(const automata::Modes& modes, const Goal& goal, const Prospects& prospects,
                             const Possible& possible) const;
  std::optional<std::vector<automata::ComponentId>> refuted(const automata::Modes& candidate, const Goal& goal,
                                                            bool local, const Possible& possible);
  [[nodiscard]] bool reads_modes(const std::vector<automata::VariableId>& variables) const;
  /// Whether the argument of `refuted_by_world` holds: neither Q, nor a mode constraint, nor the goal reads a mode.
  [[nodiscard]] bool is_local(const Goal& goal) const;
  Impasse out_of_reach(const automata::Modes& modes, const Prospects& prospects, automata::ComponentId component,
                       std::vector<bool> asked);
  std::optional<Impasse> barred_mode(const automata::Modes& modes, const Goal& goal, const Prospects& prospects);
  Impasse impasse(const automata::Modes& modes, const Goal& goal, const Prospects& prospects);

  automata::PlantStep& step_;
  const NominalGraph& graph_;
  WholeRewards rewards_;
  bool store_reads_modes_;
  std::size_t checked_ = 0;
  /// What the store excludes, whatever the goal, the estimate and the plans.
  std::vector<Conflict> excluded_;
  /// Beyond so many of them no more are kept.
  static constexpr std::size_t excluded_limit = 512;
};

}  // namespace rmpl::runtime
