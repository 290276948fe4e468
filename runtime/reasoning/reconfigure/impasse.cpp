// What is answered where there is no plan.
// SPDX-License-Identifier: MIT
#include "runtime/reasoning/reconfigure/impasse.hpp"

#include <utility>

#include "runtime/reasoning/nominal/idling.hpp"

namespace rmpl::runtime {

Reconfiguration no_plan(automata::PlantStep& step, const automata::Modes& modes, Impasse impasse) {
  Reconfiguration answer;
  answer.outcome = Reconfiguration::Outcome::no_plan;
  answer.action = resting_action(step, modes);
  answer.component = impasse.component;
  answer.reason = std::move(impasse.reason);
  answer.why = impasse.why;
  return answer;
}

}  // namespace rmpl::runtime
