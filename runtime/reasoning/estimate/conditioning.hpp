// Takes a filter through its updates: readings that nothing explains are set aside, and the others count.
// SPDX-License-Identifier: MIT
#pragma once

#include "runtime/reasoning/estimate/filter.hpp"
#include "runtime/reasoning/estimate/set_aside.hpp"

namespace rmpl::runtime {

class Conditioning {
 public:
  /// Of a filter over this step's plant. Keeps a reference.
  explicit Conditioning(automata::PlantStep& step) : step_(step), targets_(step.plant()) {}

  /// The belief at time 0, given what is seen there.
  Conditioned start(Filter& filter, const automata::Observation& observation);
  /// One step of the filter, the last one having ended at `before`. What is set aside is a smallest set of readings
  /// without which some state that is tracked explains the rest, of several the first in order; all readings, where no
  /// state is possible, or where the search for one ended early.
  Conditioned update(Filter& filter, const StepInput& input, automata::Ticks before);

 private:
  automata::PlantStep& step_;
  StepTargets targets_;
};

}  // namespace rmpl::runtime
