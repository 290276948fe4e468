// Readings that nothing explains: a smallest set of them is set aside, so that some state explains the rest.
//
// Readings that no state explains together are a conflict, and a smallest set that meets every conflict is a diagnosis
// of the readings (Reiter 1987). Conflicts are looked for as they are needed: the first smallest set that meets those
// that are known is tried, and where what is left still contradicts the model, it holds another one (implicit hitting
// sets; Moreno-Centeno and Karp 2013).
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "automata/logic/theory.hpp"
#include "automata/plant.hpp"
#include "automata/state.hpp"
#include "automata/step/transition_rules.hpp"
#include "base/function_ref.hpp"

namespace rmpl::runtime {

/// How an update of a belief went.
struct Conditioned {
  automata::Observation set_aside;  ///< in the order of the observation
  bool follows = true;              ///< false: no state is possible after the step, and the belief stays as it was
};

/// Of some readings, in their order: those that no state explains together. Nothing where a state explains all.
using Refute = base::FunctionRef<std::optional<automata::Observation>(const automata::Observation&)>;

/// The readings to be set aside, in their order: fewest, of several choices the one first in order. Nothing where
/// `refute` refutes even no readings at all. Asks `refute` once for each conflict and once for each try; the choice
/// takes exponential time in the number of readings that are set aside.
std::optional<automata::Observation> readings_to_set_aside(const automata::Observation& seen, Refute refute);

/// Those that remain.
automata::Observation without(const automata::Observation& seen, const automata::Observation& set_aside);

/// A conflict among readings that are refuted, none of which can be spared; `explained` tells of some whether a state
/// explains them. One question a reading.
automata::Observation minimal_conflict(automata::Observation refuted,
                                       base::FunctionRef<bool(const automata::Observation&)> explained);

/// What the steps out of some states of a plant explain. One theory is asked, of the modes that each component may be
/// in after the step, whichever state it set out from.
class StepTargets {
 public:
  /// Keeps a reference.
  explicit StepTargets(const automata::Plant& plant);

  /// Begins anew, without a state.
  void begin();
  /// Takes in the moves out of a state, by component.
  void add(const std::vector<std::vector<automata::Move>>& moves);
  /// As `Refute`.
  std::optional<automata::Observation> refute(const automata::Observation& readings);

 private:
  /// By bit: whether the mode is possible, of all modes of all components in order.
  using Reach = std::vector<std::uint64_t>;

  automata::Theory::Handle some_reach();

  const automata::Plant& plant_;
  std::vector<std::size_t> first_;  ///< by component: the bit of its first mode
  std::vector<Reach> reaches_;      ///< none within another, as far as that was looked at
  std::optional<automata::Theory> theory_;
  std::size_t uses_ = 0;  ///< of the theory; it grows with each
  std::optional<automata::Theory::Handle> reach_;
};

}  // namespace rmpl::runtime
