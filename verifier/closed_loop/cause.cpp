// What missing plans and endless waits are due to.
// SPDX-License-Identifier: MIT
#include "verifier/closed_loop/cause.hpp"

#include <algorithm>
#include <span>

namespace rmpl::verifier {
namespace {

/// The locations that assert one of the goals.
std::vector<automata::LocationId> askers(const automata::Program& program, const automata::Marking& marking,
                                         std::span<const automata::Assignment> goals) {
  std::vector<automata::LocationId> result;
  for (const automata::LocationId id : marking) {
    const auto& own = program.locations[id.index()].goal;
    if (std::find_first_of(own.begin(), own.end(), goals.begin(), goals.end()) != own.end()) result.push_back(id);
  }
  return result;
}

}  // namespace

Cause no_plan_cause(const automata::Program& program, const automata::Marking& marking,
                    const std::vector<automata::Assignment>& goal, const runtime::Reason& why,
                    const std::string& reason) {
  std::span<const automata::Assignment> asked = goal;
  if (why.conjunct && *why.conjunct < goal.size()) asked = asked.subspan(*why.conjunct, 1);
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
  std::vector<Cause> result = {no_plan_cause(program, last.marking, last.goal, last.why, last.reason)};
  for (const Refusal& other : witness.refused) {
    result.push_back({askers(program, last.marking, {&other.goal, 1}), other.reason});
  }
  return result;
}

}  // namespace rmpl::verifier
