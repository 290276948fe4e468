// The steps that are possible in a state, told by the rules alone.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "automata/step/plain_step.hpp"
#include "base/function_ref.hpp"

namespace rmpl::verifier {

/// The steps without a fault that are possible in a state at a time. Keeps a reference.
class StepsAt {
 public:
  /// `period`: sampled time, the step ends at `now`.
  /// `held`: in dense time, the action under which time passed up to now; none where another step has been taken at
  /// this instant. Keeps a reference.
  StepsAt(automata::PlainStep& rules, const automata::SystemState& state, automata::Ticks now,
          std::optional<automata::Ticks> period, const automata::ControlAction* held = nullptr)
      : rules_(rules), state_(state), now_(now), period_(period), held_(held) {}

  /// Visits what each step leads to until `visit` returns true; then that is the answer. In dense time a step changes a
  /// mode, or starts a clock anew that reads more than 0, what is due moves in it, and what exists at one instant only
  /// does not count (semantics 7, "an instant saves no run"). What contradicts the constraints is no step: of such
  /// modes, those with the fewest changes are kept.
  bool any(const automata::ControlAction& action, base::FunctionRef<bool(const automata::Modes&)> visit);
  /// Modes that no step leads to as they are impossible; empty where there are none.
  [[nodiscard]] const automata::Modes& refused() const { return refused_; }
  /// Whether some component has no step but into a fault.
  [[nodiscard]] bool fault_is_certain(const automata::ControlAction& action);
  /// In dense time: whether time may pass.
  bool time_passes(const automata::ControlAction& action);

 private:
  [[nodiscard]] std::vector<std::vector<automata::ModeId>> options(const automata::ControlAction& action);
  /// Whether the end of a cycle is what stops time: no component had to leave its mode whatever its clock read.
  [[nodiscard]] bool at_bound();
  [[nodiscard]] bool starts_anew(const automata::ControlAction& action);

  automata::PlainStep& rules_;
  const automata::SystemState& state_;
  automata::Ticks now_;
  std::optional<automata::Ticks> period_;
  const automata::ControlAction* held_;
  automata::Modes refused_;
  std::size_t changes_ = 0;
};

}  // namespace rmpl::verifier
