// An arena in which the components outside are not held: what they can do at best for its components.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "runtime/reasoning/game/arena.hpp"
#include "runtime/reasoning/game/within_reach.hpp"

namespace rmpl::runtime {

/// The relaxed game of some components: no strategy of a game with more of them costs less than the best one here.
///
/// As long as no component outside has left its mode, the game is that of these components, with nothing forbidden but
/// steps that no permitted strategy takes. The first departure of one outside costs what it costs at least: a
/// component that is disturbed. From then on each of them is in each cycle in any mode within reach, as the executive
/// likes: a step of a component here that rests on them is enabled or not, as it likes, and the model excludes only
/// modes that it excludes whatever theirs are. Something outside may end a wait then, so that each wait is also an
/// action of one cycle, at no cost.
class FreeArena : public Arena {
 public:
  FreeArena(automata::PlantStep& step, const NominalGraph& graph, const GameGoal& goal, std::vector<std::size_t> parts,
            std::vector<automata::ComponentId> components, const automata::Modes& start, Excludes excludes,
            const WithinReach& reach);

  [[nodiscard]] bool is_relaxed() const override { return true; }
  /// Components outside that have to leave the modes of the start so that the member may take the exit under the action
  /// in these modes: those of a precondition that asks for the fewest. Empty where none has to.
  [[nodiscard]] std::vector<automata::ComponentId> helpers(std::size_t member, const automata::Modes& modes,
                                                           automata::TransitionId exit,
                                                           const automata::ControlAction& action) const;

  /// Whether a component is outside and may come to another mode.
  [[nodiscard]] bool may_help(automata::ComponentId component) const;

 private:
  /// A step out of a mode of a member: under which commands it is enabled whatever the others do, and under which if
  /// they like.
  struct Step {
    const NominalTransition* transition;
    std::vector<const Precondition*> certain, possible;
    bool unknown = false;  ///< it has more preconditions than are known
    bool barred = false;
  };
  void list_actions(Position& position) override;
  bool tolerates(const automata::Modes& modes, bool free) override;
  void list_free(Position& position);
  [[nodiscard]] std::vector<automata::ControlAction> actions_for(const std::vector<std::vector<Step>>& steps) const;
  [[nodiscard]] bool is_barred(automata::ComponentId component, const LocalMoves& moves) const;
  [[nodiscard]] std::vector<Step> steps_of(automata::ComponentId component, const automata::Modes& modes) const;
  [[nodiscard]] bool commands(const Precondition& precondition, const automata::ControlAction& action) const;
  std::vector<const LocalMoves*> choices(std::size_t member, automata::ModeId mode, const std::vector<Step>& steps,
                                         const automata::ControlAction& action);

  const WithinReach& reach_;
  std::vector<std::size_t> place_;  ///< by variable of a control, its place; of others none
  bool others_move_ = false;
  bool exclude_ = false;                    ///< the model may exclude modes of members
  std::vector<automata::Assignment> held_;  ///< modes of the components that neither play nor are free
};

}  // namespace rmpl::runtime
