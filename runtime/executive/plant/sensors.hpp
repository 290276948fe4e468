// What the sensors of a simulated plant read in a state.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "automata/state.hpp"
#include "automata/step/plant_step.hpp"
#include "runtime/executive/plant/luck.hpp"

namespace rmpl::runtime {

/// Draws readings of all observables, in declaration order: the value that the store of the modes entails, else each
/// value that is consistent with the store and the readings drawn before is as likely as the others. Which values are
/// possible is remembered in a tree of the readings drawn so far, so a state that lasts asks the solver once.
class Sensors {
 public:
  Sensors(automata::PlantStep& step, NumberSource numbers);

  /// `modes` are possible. Sorted by variable; the reference lasts until the next call.
  const automata::Observation& read(const automata::Modes& modes);

 private:
  /// What may be read next after certain readings.
  struct Prefix {
    std::vector<automata::ValueId> candidates;  ///< ascending
    std::vector<std::uint32_t> next;            ///< per candidate, the longer prefix; 0 where not looked at yet
  };

  [[nodiscard]] std::uint32_t look(std::size_t depth);
  void forget_all();

  automata::PlantStep& step_;
  NumberSource numbers_;
  std::vector<automata::VariableId> observables_;  ///< ascending
  std::vector<Prefix> prefixes_;                   ///< position 0 is no prefix
  std::unordered_map<automata::Modes, std::uint32_t, automata::ModesHash> roots_;
  std::vector<automata::Assignment> assumptions_;  ///< the modes, then the readings drawn so far
  automata::Observation readings_;
};

}  // namespace rmpl::runtime
