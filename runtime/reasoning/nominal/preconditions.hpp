// The preconditions of a plant's transitions, each guard looked at with what has to do with it alone.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "automata/dependencies/plant_index.hpp"
#include "automata/plant.hpp"
#include "automata/store/relevance.hpp"
#include "base/bounded_cache.hpp"
#include "runtime/reasoning/nominal/precondition.hpp"

namespace rmpl::runtime {

/// What of the store decides a guard is, most often, a few components (relevance.hpp): they are asked as a plant of
/// their own. Plants grow by repeating themselves, so most of those plants were met before, but for the places of their
/// variables: what was found for one holds for all that read the same. Cost: about the plant's size, and that of the
/// questions that differ.
class Preconditions {
 public:
  /// Keeps a reference to the plant.
  explicit Preconditions(const automata::Plant& plant);

  /// Of a transition's guard in its source mode (`PreconditionFinder::preconditions`).
  FoundPreconditions of(automata::ComponentId component, automata::TransitionId transition);
  /// Whether some state of the plant has this mode.
  bool possible(automata::ComponentId component, automata::ModeId mode);

 private:
  using Key = std::vector<std::uint64_t>;
  // As they stand in the part that is asked about.
  [[nodiscard]] automata::VariableId local(automata::VariableId variable) const;
  [[nodiscard]] automata::Assignment local(const automata::Assignment& assignment) const;
  [[nodiscard]] automata::Formula local(const automata::Formula& formula) const;
  Key question_about(const automata::Relevance::Part& part, automata::Assignment mode);
  [[nodiscard]] Key key(const automata::Relevance::Part& part) const;
  [[nodiscard]] automata::Plant plant_of(const automata::Relevance::Part& part) const;

  const automata::Plant& plant_;
  automata::PlantIndex index_;
  automata::Relevance relevance_;
  bool has_states_;
  std::vector<std::uint32_t> number_;  ///< by variable: its place in the part that is asked about
  /// Beyond about so many different questions they are forgotten.
  static constexpr std::size_t memory_limit = 1u << 12;
  base::BoundedCache<Key, FoundPreconditions> found_{memory_limit};
  base::BoundedCache<Key, bool> possible_{memory_limit};
};

}  // namespace rmpl::runtime
