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
  /// What has to be entailed of some variables.
  using Wanted = std::vector<automata::Assignment>;

  /// The start is drawn among those that entail `wanted`. Keeps a reference to the program. Throws base::InputError
  /// where there is none, base::LimitError where the starts are too many to be drawn from.
  SimulatedModel(const automata::ModelProgram& program, std::uint64_t seed, const Wanted& wanted = {});

  /// One step under the command, drawn among those to markings that entail `wanted`; false, and no step, where no draw
  /// leads to one, or so few that none of 65,536 did. Throws base::InputError where the command contradicts what is
  /// told, or nothing consistent can follow, base::LimitError as above.
  bool step(const automata::Command& command, const Wanted& wanted = {});
  /// All marked locations; lasts until the next step.
  const automata::Marking& marking() { return step_.whole(marking_); }
  /// What the marking entails, by variable, likewise.
  const std::vector<automata::Assignment>& values() { return step_.values(marking_); }
  /// All observables, sorted by variable.
  automata::Observation read();

 private:
  bool draw(const automata::MarkingMoves& moves, const automata::MarkingStep::Ways& ways, const Wanted& wanted);

  automata::MarkingStep step_;
  RandomSource moves_, readings_;  ///< apart, so that a sensor more does not change what happens
  automata::MarkingStep::Number marking_ = 0;
};

}  // namespace rmpl::runtime
