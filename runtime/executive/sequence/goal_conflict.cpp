// The words for a goal conflict.
// SPDX-License-Identifier: MIT
#include "runtime/executive/sequence/goal_conflict.hpp"

#include <string>

#include "automata/assignment_text.hpp"

namespace rmpl::runtime {
namespace {

std::string asserts(const automata::Program& program, automata::LocationId id, automata::Assignment goal,
                    const automata::Variables& variables) {
  return "location " + std::to_string(id.index() + 1) + " asserts " + to_text(variables, goal) +
         in_brackets(program.locations[id.index()].origin);
}

}  // namespace

Event describe(const automata::GoalConflict& conflict, const automata::Program& program,
               const automata::Variables& variables) {
  return {Event::Kind::goal_conflict,
          asserts(program, conflict.first, conflict.contradicted, variables) + ", but " +
              asserts(program, conflict.second, conflict.asserted, variables),
          std::nullopt, std::pair{conflict.first, conflict.second}};
}

}  // namespace rmpl::runtime
