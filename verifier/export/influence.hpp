// What an answer of the store depends on, told more narrowly than by whole islands.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "automata/step/plant_step.hpp"
#include "automata/store/support.hpp"

namespace rmpl::verifier {

class Influence {
 public:
  /// Keeps the reference.
  explicit Influence(automata::PlantStep& step) : step_(step), plant_(step.plant()) {}

  /// What it depends on whether the store implies or allows a formula of these variables. An island as a whole may be
  /// wide, and tell little of one attribute: what only follows from others is taken away. `commanded`: the store has
  /// the command; else modes alone, which may leave no choice but one.
  automata::Support support_of(const std::set<automata::VariableId>& variables, bool commanded);
  /// What the guards of the exits from a mode depend on.
  const automata::Support& support_of(automata::ComponentId component, automata::ModeId mode);
  /// What reads modes and commands that contradict each other in some combination: what is read, of each group of
  /// constraints that have attributes in common once the others are eliminated. Where there are too many combinations
  /// to look at all of them, they may.
  const std::vector<automata::Support>& exclusions();

 private:
  [[nodiscard]] bool excludes(const automata::Support& support);

  automata::PlantStep& step_;
  const automata::Plant& plant_;
  std::optional<std::vector<automata::Support>> exclusions_;
  std::map<std::pair<automata::ComponentId, automata::ModeId>, automata::Support> supports_;  ///< the same, by mode
};

}  // namespace rmpl::verifier
