// The least time that the components need to a target: what comes too late for it is not looked at.
//
// Each component by itself, whatever the others do: a shortest way (E. Dijkstra, 1959) through its modes to one in
// which the store allows the target, each transition taking its lower bound. A relaxation, so what it cuts off is out
// of reach in any case; the same is done for schedules with lower bounds on what is left of each job.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "automata/step/plant_step.hpp"
#include "verifier/zone/time_model.hpp"
#include "verifier/zone/zone.hpp"

namespace rmpl::verifier {

/// What each mode of each component leaves to do until a target that is to be reached by some time.
class TimeLeft {
 public:
  /// `target` is over the plant of the step function; without `faults` there is no fault on the way. `by` is finite.
  TimeLeft(automata::PlantStep& step, const TimeModel& time, const automata::Formula& target, bool faults, Units by);

  /// Keeps the readings from which the target may still be in time. The zone's first clock tells the time since the
  /// start, those that follow are the ones of the `live` components, ascending. Whether any are left. O(n^2) for each
  /// component that needs time.
  [[nodiscard]] bool cut(Zone& zone, const automata::Modes& modes,
                         const std::vector<automata::ComponentId>& live) const;

 private:
  /// In one mode; `unbounded` where no way leads from it to the target.
  struct Left {
    Units since_entry = unbounded;  ///< from when the mode was entered
    Units after_exit = unbounded;   ///< from when it is left
  };
  struct Way {
    automata::ComponentId component;
    std::vector<Left> left;  ///< by mode
  };
  std::vector<Way> ways_;  ///< of the components that need time
  Units by_;
};

}  // namespace rmpl::verifier
