// What the game is played for: a goal, what it reads, and which irreversible steps it licenses (semantics 5).
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "automata/logic/formula.hpp"
#include "automata/logic/theory.hpp"
#include "automata/state.hpp"
#include "automata/step/plant_step.hpp"
#include "runtime/reasoning/nominal/nominal_graph.hpp"
#include "runtime/reasoning/nominal/useful.hpp"

namespace rmpl::runtime {

/// A goal over modes and attributes, taken apart into its conjuncts, its *parts*. Keeps references.
class GameGoal {
 public:
  GameGoal(const automata::Formula& goal, automata::PlantStep& step, const NominalGraph& graph);

  [[nodiscard]] const automata::Formula& formula() const { return formula_; }
  [[nodiscard]] std::size_t parts() const { return parts_.size(); }
  /// Of the parts: whether the store of these modes, which are possible, implies it.
  [[nodiscard]] std::vector<bool> held(const automata::Modes& modes, const std::vector<std::size_t>& parts) const;
  /// Components whose modes decide a part: those that it names, and those that have to do with its attributes.
  [[nodiscard]] const std::vector<automata::ComponentId>& read_by(std::size_t part) const { return parts_[part].reads; }
  /// What a part wants of the components that it reads: a mode that it names, one by one; where it names none of a
  /// component, any of its modes.
  [[nodiscard]] std::vector<WantedModes> wanted(std::size_t part) const;
  /// Whether the goal speaks of the component: of its mode or of an attribute of it.
  [[nodiscard]] bool reads(automata::ComponentId component) const { return reads_[component.index()]; }
  /// Whether the goal names, under an even number of negations, a mode of the component to which the step leads.
  [[nodiscard]] bool licenses(automata::ComponentId component, automata::TransitionId transition) const {
    return licensed_[component.index()][transition.index()];
  }

 private:
  struct Part {
    automata::Formula formula;
    bool about_modes;  ///< no attribute occurs: the modes alone decide
    automata::Theory::Handle handle;
    std::vector<automata::ComponentId> reads;
  };

  automata::PlantStep& step_;
  automata::Formula formula_;
  std::vector<Part> parts_;
  std::vector<bool> reads_;                  ///< by component
  std::vector<std::vector<bool>> licensed_;  ///< by component, by transition
};

}  // namespace rmpl::runtime
