// A model program behind its facade: states of the plant that tell a marking.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "automata/phca.hpp"
#include "automata/plant.hpp"
#include "automata/state.hpp"
#include "automata/step/marking_store.hpp"
#include "automata/step/program_rules.hpp"

namespace rmpl::automata {

/// The facade of a model program, and behind its components one for each primitive location, in their order, with the
/// modes `no` and `yes`, of which the second means what the location tells. So `Modes` are what the store of a marking
/// entails, then the marking; those who know the facade alone read the first part of them.
class MarkedPlant {
 public:
  explicit MarkedPlant(const ModelProgram& program);

  [[nodiscard]] const Plant& plant() const { return plant_; }
  /// `values`: what the store of the marking entails, by variable. Composites tell nothing.
  [[nodiscard]] Modes modes(const Marking& marking, std::span<const Assignment> values) const;
  /// The primitive locations.
  [[nodiscard]] Marking marking(const Modes& modes) const;

 private:
  Plant plant_;
  std::size_t shown_;                           ///< components of the facade
  std::vector<std::optional<std::size_t>> at_;  ///< per location: its component
  std::vector<LocationId> primitive_;           ///< per component behind the facade
};

/// Every control has a value in an action.
Command command_of(const ControlAction& action);

}  // namespace rmpl::automata
