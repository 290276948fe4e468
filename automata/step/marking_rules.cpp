// One step of a PHCA: what is certain, and what independent draws may add to it.
// SPDX-License-Identifier: MIT
#include "automata/step/marking_rules.hpp"

#include <algorithm>
#include <iterator>
#include <set>
#include <utility>

#include "automata/step/marking_movement.hpp"
#include "base/check.hpp"

namespace rmpl::automata {

Marking united(const MarkingMoves& moves, std::span<const MarkingOutcome* const> outcomes) {
  Marking marking = moves.certain;
  for (const MarkingOutcome* outcome : outcomes) {
    marking.insert(marking.end(), outcome->marked.begin(), outcome->marked.end());
  }
  std::sort(marking.begin(), marking.end());
  return marking;
}

MarkingRules::MarkingRules(const ModelProgram& program)
    : program_(program),
      holders_(program.locations.size()),
      started_(program.locations.size()),
      maintenance_(program.locations.size()),
      functions_(program.locations.size()),
      arcs_(program.locations.size()) {
  const auto& locations = program.locations;
  for (std::size_t l = 0; l < locations.size(); ++l) {
    const ModelLocation& location = locations[l];
    if (location.parent) {
      CHECK(location.parent->index() < l && "a child comes after its parent");
      holders_[l].push_back(*location.parent);
      const Marking& outer = holders_[location.parent->index()];
      holders_[l].insert(holders_[l].end(), outer.begin(), outer.end());
    }
    if (location.composite) {
      if (!location.maintenance.is_trivial()) maintenance_[l] = condition(location.maintenance);
      arcs_[l] = ruled(location.arcs, l);
      continue;
    }
    CHECK(!location.functions.empty() && "a primitive location has a transition function");
    for (const TransitionFunction& function : location.functions) {
      functions_[l].push_back({function.probability, is_improbable(function, location.functions), function.started,
                               ruled(function.arcs, l)});
    }
  }
  for (std::size_t l = locations.size(); l-- > 0;) {
    if (!locations[l].composite) started_[l] = {LocationId(l)};
    std::sort(started_[l].begin(), started_[l].end());
    if (!locations[l].start || !locations[l].parent) continue;
    Marking& outer = started_[locations[l].parent->index()];
    outer.insert(outer.end(), started_[l].begin(), started_[l].end());
  }
}

std::vector<MarkingRules::RuledArc> MarkingRules::ruled(const std::vector<GuardedArc>& arcs, std::size_t source) {
  std::vector<RuledArc> result;
  for (const GuardedArc& arc : arcs) {
    RuledArc& own = result.emplace_back(RuledArc{{}, LocationId(source), arc.target});
    for (const Condition& guard : arc.guard) {
      if (!guard.is_trivial()) own.guard.push_back(condition(guard));
    }
  }
  return result;
}

std::size_t MarkingRules::condition(const Condition& condition) {
  const auto known = std::find(conditions_.begin(), conditions_.end(), condition) - conditions_.begin();
  if (known == std::ssize(conditions_)) conditions_.push_back(condition);
  return static_cast<std::size_t>(known);
}

Marking MarkingRules::whole(const Marking& primitive) const {
  Marking result = primitive;
  for (const LocationId l : primitive) {
    for (const LocationId holder : holders_[l.index()]) result.push_back(holder);
  }
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

MarkingMoves MarkingRules::initial() const {
  const auto never = [](std::size_t) { return false; };
  MarkingMovement movement(*this, never);
  movement.start();
  return movement.moves();
}

MarkingMoves MarkingRules::moves(const Marking& primitive, const Holds& holds) const {
  MarkingMovement movement(*this, holds);
  for (const LocationId l : primitive) movement.leave(l);
  return movement.moves();
}

}  // namespace rmpl::automata
