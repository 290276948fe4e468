// The reconfigurer's advice beside what the rules allow.
// SPDX-License-Identifier: MIT
#pragma once

#include <rapidcheck.h>

#include <set>
#include <vector>

#include "runtime/reasoning/reconfigure/reconfigurer.hpp"
#include "tests/property/generate.hpp"
#include "tests/reference/executive.hpp"

namespace rmpl::property {

inline reference::Advice told(runtime::Reconfigurer& reconfigurer, const automata::Modes& modes,
                              const reference::Executive::Goal& goal) {
  const runtime::Reconfiguration answer = reconfigurer.next(modes, automata::conjunction_of(goal));
  const bool command = answer.outcome == runtime::Reconfiguration::Outcome::command;
  return {answer.outcome == runtime::Reconfiguration::Outcome::no_plan, answer.action,
          command && answer.why.purpose == runtime::Reason::Purpose::reward};
}

/// Advice that the twin comes to by itself; where it leaves a choice, the reconfigurer's, which must be one of it.
inline reference::Advice advised(reference::Executive& executive, runtime::Reconfigurer& reconfigurer,
                                 const automata::Plant& plant, const automata::Modes& modes,
                                 const reference::Executive::Goal& goal) {
  const std::set<reference::Advice>& allowed = executive.allowed(modes, goal);
  const reference::Advice chosen = told(reconfigurer, modes, goal);
  RC_LOG() << automata::to_text(automata::conjunction_of(goal), plant.variables) << " from " << rc::toString(modes)
           << (chosen.no_plan ? ": no plan" : ": ") << rc::toString(chosen.action)
           << (chosen.for_reward ? " for reward" : "") << std::endl;
  RC_ASSERT(allowed.contains(chosen));
  return chosen;
}

}  // namespace rmpl::property
