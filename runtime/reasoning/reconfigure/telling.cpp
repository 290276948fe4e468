// What a reconfigurer answers with a planned step.
// SPDX-License-Identifier: MIT
#include "runtime/reasoning/reconfigure/telling.hpp"

#include <algorithm>

namespace rmpl::runtime {

using automata::ComponentId;
using automata::Formula;
using automata::Modes;

Reconfiguration Telling::step(const Modes& modes, const PlannedStep& step, const Modes& target, const Goal& goal,
                              Reason::Purpose purpose) {
  Reconfiguration result;
  result.outcome = step.action == idle_ ? Reconfiguration::Outcome::wait : Reconfiguration::Outcome::command;
  result.action = step.action;
  result.expected = step.outcome.modes;
  result.component = step.component;
  result.irreversible = !step.idle && std::any_of(step.outcome.moves.begin(), step.outcome.moves.end(),
                                                  [](const NominalMove& m) { return !m.transition->reversible; });
  result.why.purpose = purpose;
  if (purpose == Reason::Purpose::goal) result.why.conjunct = open_conjunct(modes, goal, step.serves);
  result.why.component = step.serves;
  result.why.aim = target[step.serves.index()];
  for (const NominalMove& move : step.outcome.moves) {
    if (move.component == step.component) result.why.step = TransitionOf{move.component, move.transition->id};
  }
  return result;
}

std::optional<std::uint32_t> Telling::open_conjunct(const Modes& modes, const Goal& goal,
                                                    std::optional<ComponentId> served) {
  const auto now = assignments_of(step_.plant(), modes);
  const std::vector<Formula> conjuncts = conjuncts_of(goal.formula());
  std::optional<std::uint32_t> first;
  for (std::uint32_t i = 0; i < conjuncts.size(); ++i) {
    const auto variables = variables_of(conjuncts[i]);
    const bool about = served && std::binary_search(variables.begin(), variables.end(), step_.plant()[*served].mode);
    if ((first && !about) || step_.theory().entails(now, step_.theory().encode(conjuncts[i]))) continue;
    if (about) return i;
    first = i;
  }
  return first;
}

}  // namespace rmpl::runtime
