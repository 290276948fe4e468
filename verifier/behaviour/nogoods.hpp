// Nogoods: modes that cannot be together, learnt from states that turn out to be impossible.
//
// Among many joint steps most fail for the same few reasons (two components that both write one variable). Each reason,
// made minimal, is remembered, and cuts off every later combination that holds it before it is built.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "automata/step/plant_step.hpp"

namespace rmpl::verifier {

/// Modes of which some are not decided yet.
struct PartialModes {
  automata::Modes modes;
  std::vector<bool> decided;  ///< by component
};

/// The nogoods of a plant met so far. Keeps a reference to the step function.
class Nogoods {
 public:
  explicit Nogoods(automata::PlantStep& step);

  /// Whether the modes are possible (PlantStep::possible).
  [[nodiscard]] bool possible(const automata::Modes& modes);
  /// Whether the decided modes cannot be together, the mode of `component` being to blame. Sufficient only.
  [[nodiscard]] bool refutes(const PartialModes& partial, automata::ComponentId component) const;

 private:
  using Nogood = std::vector<std::pair<automata::ComponentId, automata::ModeId>>;

  automata::PlantStep& step_;
  std::size_t learnt_ = 0;
  std::vector<std::vector<std::vector<Nogood>>> known_;  ///< by component, by its mode: what cannot be beside that
};

}  // namespace rmpl::verifier
