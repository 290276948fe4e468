// The plant abstracted to what each component by itself can be in: which modes are ever entered, which guards ever
// hold.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "compiler/lint/plant/questions.hpp"

namespace rmpl::compiler {

/// The least abstraction that holds all that happens: a component starts in an initial mode that some initial state
/// has, and takes any transition whose guard can follow, into a mode that is possible, while each of the others is in
/// any mode that it may have reached, or enters one at the same time. Time and what goes before what are left out, so
/// more may be reached than is; what is not reached is not.
struct Reach {
  bool has_initial_state = true;  ///< else all modes with an initial probability count as initial
  ModeSets possible;              ///< whether some state has the mode at all, reached or not
  ModeSets initial;               ///< whether some initial state has it
  ModeSets reached;
  /// Of a transition from a mode that is reached: whether its guard can follow, with the last that was found. Of others
  /// it means nothing.
  std::vector<std::vector<Implied>> guards;  ///< by component, by transition
};

/// Finds it. Afterwards the questions are about the modes that are reached.
Reach reach_of(PlantQuestions& questions);

}  // namespace rmpl::compiler
