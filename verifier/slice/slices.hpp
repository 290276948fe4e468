// Slices: what of a plant can have to do with a question.
//
// Who reads whom is worked out once for a plant. All else that a question needs, theories, symmetries, what commands
// there are, is made for the few components in its cone, so that it costs what they are worth, whatever else the plant
// has.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "automata/dependencies/plant_index.hpp"
#include "automata/logic/theory.hpp"
#include "automata/step/plant_step.hpp"
#include "automata/store/support.hpp"
#include "verifier/slice/part.hpp"

namespace rmpl::verifier {

/// Components by ascending number.
using Cone = std::vector<automata::ComponentId>;

/// Keeps a reference to the plant. Not for use from two threads at once.
class Slices {
 public:
  explicit Slices(const automata::Plant& plant);

  [[nodiscard]] const automata::Plant& plant() const { return plant_; }
  /// The step function of the whole plant, made when it is first asked for.
  automata::PlantStep& whole();

  /// The cone of influence: the components that decide some of the formulas, or that a guard of one in the cone depends
  /// on, or that share an island of the constraint store with one in the cone; also where a control action could
  /// contradict its island, as a store that contradicts itself enables everything.
  ///
  /// What is outside never enables, forces or forbids anything inside. With it frozen, time passing as if it were not
  /// there, the cone does all that it can do in the whole plant, and perhaps more: what outside stops time, or must
  /// move while the cone waits, is not felt.
  Cone cone(std::span<const automata::Formula> formulas);
  /// A cone, what the formulas that it is of read, and what a control action could contradict, as a plant of its own.
  Part part(const Cone& cone, std::span<const automata::Formula> formulas);
  /// The first possible modes to start in, in the order of the components and of their modes, `from` in place of the
  /// initial distribution of those that it names. Nothing where there are none. The last answer is remembered.
  const std::optional<automata::Modes>& start(const std::vector<automata::Assignment>& from);
  /// Whether some state satisfies the formula, be it reached or not.
  bool can_hold(const automata::Formula& formula);
  /// Whether the modes of some state imply the formula. Looks at up to so many combinations of the modes that decide
  /// it, and takes it to be so beyond.
  bool can_follow(const automata::Formula& formula);
  /// Whether the store of modes that are possible allows the formula.
  bool allows(const automata::Modes& modes, const automata::Formula& formula);

 private:
  [[nodiscard]] bool excludes(std::size_t island);
  [[nodiscard]] bool indifferent(std::size_t island);
  /// Islands that a control action can contradict, perhaps without a component.
  const std::vector<std::size_t>& sensitive();
  [[nodiscard]] std::optional<automata::Modes> first_start(const std::vector<automata::Assignment>& from);
  bool settle(const std::vector<std::size_t>& components, const std::vector<std::size_t>& islands,
              const std::vector<std::vector<automata::ModeId>>& lists, automata::Modes& modes) const;

  const automata::Plant& plant_;
  automata::PlantIndex index_;
  automata::Locality locality_;
  std::vector<std::vector<std::size_t>> islands_of_;        ///< by component: those with constraints
  std::vector<std::vector<std::size_t>> interconnections_;  ///< by variable: those that read it
  std::vector<std::optional<bool>> excludes_;               ///< by island, as far as asked for
  std::optional<std::vector<std::size_t>> sensitive_;
  /// Where `start` is asked for again.
  struct Start {
    std::vector<automata::Assignment> from;
    std::optional<automata::Modes> modes;
  };
  std::optional<Start> start_;
  std::optional<automata::Theory> theory_;
  std::optional<automata::PlantStep> whole_;
};

}  // namespace rmpl::verifier
