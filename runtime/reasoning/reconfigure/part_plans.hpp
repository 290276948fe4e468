// Plans for the parts of a plant that do not touch each other.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "runtime/reasoning/reconfigure/impasse.hpp"
#include "runtime/reasoning/reconfigure/parts.hpp"
#include "runtime/reasoning/reconfigure/planner.hpp"

namespace rmpl::runtime {

/// The next step of one part; whether it achieves what may not last, or what is gone in the next step; and whether the
/// part has to be waited for.
struct Offer {
  IslandPlan plan;
  std::size_t part;
  bool brief, passing, waits;
};

/// Keeps references to both.
class PartPlans {
 public:
  PartPlans(Planner& planner, const Parts& parts) : planner_(planner), parts_(parts) {}

  /// Each part by itself, in the order of goals; the part of the objective is of no account. An impasse, and its part.
  std::optional<std::pair<Impasse, std::size_t>> plan(const automata::Modes& modes, Objective objective,
                                                      std::vector<Offer>& offers);
  /// What the ways lead through.
  Planner::Followed followed(const automata::Modes& modes, const Objective& objective) {
    return planner_.followed(modes, objective);
  }
  /// Where the plans end.
  [[nodiscard]] automata::Modes end_of(const automata::Modes& modes, const std::vector<Offer>& offers) const;
  /// Of at least one: the first command that need not be put off until another part has been waited for; else the first
  /// wait; else the first command, of what is gone in the next step last.
  static const PlannedStep& best(const std::vector<Offer>& offers);

 private:
  Planner& planner_;
  const Parts& parts_;
};

}  // namespace rmpl::runtime
