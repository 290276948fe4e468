// A model program as a simulated plant: markings and readings drawn from it.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "automata/step/marking_step.hpp"
#include "runtime/executive/plant/random_source.hpp"

namespace rmpl::runtime {

/// Same seed, same run. A marking is drawn among those that are consistent, by their probabilities; a reading that the
/// store leaves open is any of the values that are consistent with it and with the readings before.
class SimulatedModel {
 public:
  /// Keeps a reference to the program. Throws base::InputError where no start is consistent, base::LimitError where the
  /// starts are too many to be drawn from.
  SimulatedModel(const automata::ModelProgram& program, std::uint64_t seed);

  /// One step under the command. Throws base::InputError where the command contradicts what is told, or nothing
  /// consistent can follow, base::LimitError as above.
  void step(const automata::Command& command);
  /// All marked locations; lasts until the next step.
  const automata::Marking& marking() { return step_.whole(marking_); }
  /// What the marking entails, by variable, likewise.
  const std::vector<automata::Assignment>& values() { return step_.values(marking_); }
  /// All observables, sorted by variable.
  automata::Observation read();

 private:
  bool draw(const automata::MarkingMoves& moves, const automata::MarkingStep::Ways& ways);

  automata::MarkingStep step_;
  RandomSource moves_, readings_;  ///< apart, so that a sensor more does not change what happens
  automata::MarkingStep::Number marking_ = 0;
};

}  // namespace rmpl::runtime
