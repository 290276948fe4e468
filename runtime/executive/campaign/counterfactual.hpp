// The flight as it would have gone without a fault, under the same commands and with the same luck.
// SPDX-License-Identifier: MIT
#pragma once

#include <utility>
#include <vector>

#include "automata/step/plant_step.hpp"
#include "runtime/executive/trace/event.hpp"

namespace rmpl::runtime {

/// One step of a flight, as it was.
struct FlownStep {
  const automata::Modes& before;
  const automata::Modes& after;
  const automata::ControlAction& command;
  const automata::Observation& readings;  ///< at its end
  const std::vector<Event>& events;
  automata::Ticks from, to;
};

/// A twin of the flight that parts from it where a fault is injected. A component that is in the same mode in both does
/// in the twin what it did in the flight, where it can; every other takes its most likely transition, unless a fault
/// befell it by chance, as it may befall the twin. So they differ in what the fault brought about, and a reading that
/// the twin cannot have is a symptom of the fault.
class Counterfactual {
 public:
  /// In the step that follows `state` the `component` is forced; the twin's is not. Keeps a reference to `step`.
  Counterfactual(automata::PlantStep& step, automata::SystemState state, automata::ComponentId component)
      : step_(step), state_(std::move(state)), component_(component) {}

  /// Follows one step. Whether its readings contradict the twin; or the twin can go nowhere, which counts as much.
  bool contradicted_by(const FlownStep& flown);
  /// Where the twin is.
  [[nodiscard]] const automata::SystemState& state() const { return state_; }

 private:
  automata::PlantStep& step_;
  automata::SystemState state_;
  automata::ComponentId component_;
  bool parted_ = false;
};

}  // namespace rmpl::runtime
