// The store of a plant without islands, memory or truth maintenance: for checks of what the fast one answered.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "automata/logic/theory.hpp"
#include "automata/plant.hpp"
#include "automata/state.hpp"

namespace rmpl::automata {

/// One theory of all constraints with a solver of its own, which is asked each time. It shares nothing with any other
/// store but the plant, to which it keeps a reference, and the encoding of formulas. Not for two threads at once.
class PlainStore {
 public:
  explicit PlainStore(const Plant& plant);

  [[nodiscard]] const Plant& plant() const { return plant_; }
  /// Whether Q and the constraints of the modes can hold.
  bool possible(const Modes& modes);
  /// Whether they can hold together with the control action.
  bool consistent(const Modes& modes, const ControlAction& action);
  /// By component and transition, whether it sets out from the modes and they imply, with the control action, its
  /// guard; an inconsistent store implies all.
  std::vector<std::vector<bool>> implied_guards(const Modes& modes, const ControlAction& action);
  /// Whether the modes imply any formula over attributes and modes. A formula that is new is encoded, once.
  bool implies(const Formula& formula, const Modes& modes);
  /// Whether they can hold together with some formula, or with observations.
  bool allows(const Formula& formula, const Modes& modes);
  bool explains(const Modes& modes, const Observation& observation);

 private:
  const Plant& plant_;
  Theory theory_;
  std::vector<std::vector<Theory::Handle>> guards_;  ///< per component, per transition
};

}  // namespace rmpl::automata
