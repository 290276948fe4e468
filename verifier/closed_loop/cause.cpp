// What missing plans and endless waits are due to.
// SPDX-License-Identifier: MIT
#include "verifier/closed_loop/cause.hpp"

#include <algorithm>
#include <span>

namespace rmpl::verifier {
namespace {

/// The locations that assert one of the conjuncts of a goal.
std::vector<automata::LocationId> askers(const automata::Program& program, const automata::Marking& marking,
                                         std::span<const automata::Formula> conjuncts) {
  std::vector<automata::LocationId> result;
  for (const automata::LocationId id : marking) {
    const std::vector<automata::Formula> own = conjuncts_of(goal_of(program.locations[id.index()]));
    const bool asks = std::find_first_of(own.begin(), own.end(), conjuncts.begin(), conjuncts.end()) != own.end();
    if (asks && program.locations[id.index()].has_goal()) result.push_back(id);
  }
  return result;
}

}  // namespace

Cause no_plan_cause(const automata::Program& program, const automata::Marking& marking, const automata::Goals& goals,
                    const runtime::Reason& why, const std::string& reason) {
  const std::vector<automata::Formula> all = conjuncts_of(goals.formula());
  std::span<const automata::Formula> asked = all;
  if (why.conjunct && *why.conjunct < all.size()) asked = asked.subspan(*why.conjunct, 1);
  return {askers(program, marking, asked), reason};
}

Cause waiting_cause(const automata::Program& program, const automata::Marking& marking) {
  Cause result;
  for (const automata::LocationId id : marking) {
    if (!program.locations[id.index()].composite) result.locations.push_back(id);
  }
  return result;
}

std::vector<Cause> causes_of(const automata::Program& program, const Witness& witness, bool plans) {
  const Cycle& last = *witness.events.back().cycle;
  if (!plans) return {waiting_cause(program, last.marking)};
  std::vector<Cause> result;
  if (last.outcome == runtime::Reconfiguration::Outcome::no_plan)
    result.push_back(no_plan_cause(program, last.marking, last.goals, last.why, last.reason));
  for (const runtime::LeftOut& other : last.left_out)
    result.push_back(no_plan_cause(program, last.marking, other.goals, other.why, other.reason));
  for (const Refusal& other : witness.refused) {
    result.push_back({askers(program, last.marking, conjuncts_of(other.goal)), other.reason});
  }
  return result;
}

}  // namespace rmpl::verifier
