// What a goal asks for and has already: whether it stays while something else is done (semantics 5, *Plan*).
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "automata/state.hpp"
#include "automata/step/plant_step.hpp"
#include "base/function_ref.hpp"
#include "runtime/reasoning/reconfigure/drift.hpp"
#include "runtime/reasoning/reconfigure/goal.hpp"
#include "runtime/reasoning/reconfigure/nominal_graph.hpp"

namespace rmpl::runtime {

/// A goal asks for modes of components, and for what is left to entailment: its parts. A part is lost by itself where
/// nominal transitions that need no command, timed or not, may lead to where it is not so. Which these are is told
/// component by component, each in any of the modes that it may come to: more than can be, never less.
/// Cost: the transitions of what the goal depends on, a few times over.
class Upkeep {
 public:
  /// Keeps references.
  Upkeep(automata::PlantStep& step, const NominalGraph& graph, const Goal& goal);

  /// How soon something may come by itself: never; some day; by one transition, which is enabled; by untimed ones
  /// alone.
  enum class Soon : std::uint8_t { never, ever, next, at_once };

  /// What is known of the parts in a state.
  struct Standing {
    std::vector<bool> had;   ///< the part is so
    std::vector<Soon> loss;  ///< how soon it may be lost by itself, where it is so: the later the better
    /// By how soon (position in `soons`), by component, by mode: whether it may come to that; of those that matter.
    std::vector<Reached> drift;
  };
  Standing standing(const automata::Modes& modes);

  /// Whether each part that was had is there in the modes, and can be lost by itself only if it could before, and no
  /// sooner.
  bool keeps(const Standing& before, const automata::Modes& after);

  /// Whether those of some components that matter can come by themselves to the modes in `target` if they could before,
  /// and to no others than before, or sooner, but such as are no farther from there: what is on the way of a wait goes
  /// on as it would, or better.
  bool leaves(const std::vector<bool>& some, const Standing& before, const automata::Modes& after,
              const automata::Modes& target);

 private:
  static constexpr std::array soons = {Soon::ever, Soon::next, Soon::at_once};

  /// By part: whether it is so; how soon it may be lost by itself, where it is. `followed` is called as `drift_` tells
  /// of each of `soons`.
  std::vector<bool> had(const automata::Modes& modes);
  std::vector<Soon> loss(const automata::Modes& modes, base::FunctionRef<void()> followed);
  /// By part: whether it may be lost in the modes in `drift_`.
  std::vector<bool> losable();
  /// The modes that the components that matter may come to by themselves, in `drift_`.
  void follow(const automata::Modes& modes, Soon soon);
  bool rest_may_fail();
  [[nodiscard]] bool no_farther(automata::ComponentId component, const std::vector<bool>& could, automata::ModeId now,
                                automata::ModeId aim) const;
  /// By mode of a component: nominal transitions from there to one of its modes, more than there are where none lead
  /// there.
  [[nodiscard]] std::vector<std::size_t> steps_to(automata::ComponentId component, automata::ModeId aim) const;

  automata::PlantStep& step_;
  const NominalGraph& graph_;
  const Goal& goal_;
  std::vector<automata::ComponentId> restricted_;  ///< those of which the goal asks for modes, a part each
  std::vector<automata::ComponentId> support_;     ///< those that decide the rest, which is the last part
  std::vector<automata::ComponentId> involved_;    ///< all these, and what their transitions depend on
  Reached drift_;                                  ///< by component, by mode; of those involved
};

}  // namespace rmpl::runtime
