// What a command lets come by itself: forbidden steps, at once or in time, after whatever else comes first.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <unordered_set>

#include "runtime/reasoning/reconfigure/nominal_step.hpp"

namespace rmpl::runtime {

using automata::ComponentId;
using automata::ControlAction;
using automata::Modes;
using automata::TransitionId;

/// Whether a forbidden step of the component can come by itself after the mode at all, as far as its own graph says.
bool NominalStep::can_risk(ComponentId c, automata::ModeId mode, const Permitted& permitted) const {
  const auto& transitions = graph_.transitions(c);
  return std::any_of(transitions.begin(), transitions.end(), [&](const NominalTransition& t) {
    if (is_granted(c, t, permitted) || !t.possible || !graph_.leads(c, mode, t.from)) return false;
    return !t.all_preconditions || std::find(t.silent.begin(), t.silent.end(), true) != t.silent.end();
  });
}

/// Every way that a step may go with all controls idle: untimed transitions are taken, and of those that take time one
/// of the components in question, or none.
std::vector<NominalOutcome> NominalStep::by_itself(const Modes& modes, std::size_t part,
                                                   const std::vector<bool>& in_question) {
  const ControlAction idle = idle_action(plant());
  std::vector<NominalOutcome> result;
  if (!tolerates(modes, idle)) return result;
  const automata::AllEnabled enabled = step_.enabled(modes, idle);
  for (const NominalOutcome& untimed : combinations(modes, enabled, part, {})) {
    if (!untimed.moves.empty()) result.push_back(untimed);
    for (const ComponentId c : parts_.components(part)) {
      if (!in_question[c.index()] || !enabled[c.index()].untimed.empty()) continue;
      for (const TransitionId id : enabled[c.index()].timed) {
        const NominalTransition& t = nominal(c, id);
        if (t.from == t.to) continue;
        NominalOutcome& next = result.emplace_back(untimed);
        next.modes[c.index()] = t.to;
        next.moves.push_back({c, &t});
      }
    }
  }
  std::erase_if(result, [&](const NominalOutcome& outcome) { return !step_.possible(outcome.modes); });
  return result;
}

/// The forbidden steps that may come by themselves from there on, also after each other. So many states are looked at.
std::vector<TransitionOf> NominalStep::forbidden_to_come(const Modes& modes, std::size_t part,
                                                         const Permitted& permitted) {
  constexpr std::size_t most_states = 128;
  std::vector<ComponentId> at_risk;
  for (const ComponentId c : parts_.components(part)) {
    if (can_risk(c, modes[c.index()], permitted)) at_risk.push_back(c);
  }
  std::vector<TransitionOf> result;
  if (at_risk.empty()) return result;
  std::vector<bool> in_question(modes.size());
  for (const ComponentId c : graph_.upstream(at_risk)) in_question[c.index()] = true;
  std::vector<Modes> states = {modes};
  std::unordered_set<Modes, automata::ModesHash> seen = {modes};
  for (std::size_t next = 0; next < states.size() && states.size() < most_states; ++next) {
    const Modes state = states[next];
    for (NominalOutcome& outcome : by_itself(state, part, in_question)) {
      for (const NominalMove& move : outcome.moves) {
        if (!is_granted(move.component, *move.transition, permitted)) {
          result.push_back({move.component, move.transition->id});
        }
      }
      if (seen.insert(outcome.modes).second) states.push_back(std::move(outcome.modes));
    }
  }
  return result;
}

bool NominalStep::comes_anyway(const Modes& modes, ComponentId c, const NominalTransition& t) {
  if (!drift_ || drift_->first != modes) drift_.emplace(modes, drift_from(graph_, modes));
  return drifts(graph_, c, t, drift_->second);
}

bool NominalStep::risks(const Modes& before, const Modes& after, std::size_t part, const Permitted& permitted) {
  const std::vector<TransitionOf> then = forbidden_to_come(after, part, permitted);
  const auto at = std::find_if(then.begin(), then.end(), [&](const TransitionOf& step) {
    return !comes_anyway(before, step.component, nominal(step.component, step.transition));
  });
  if (at == then.end()) return false;
  refused_ = *at;
  return true;
}

bool NominalStep::lets_come_a_risk(const Modes& modes, const ControlAction& action, std::size_t part,
                                   const Permitted& permitted) {
  const auto& components = parts_.components(part);
  const bool forbids = std::any_of(components.begin(), components.end(), [&](ComponentId c) {
    const auto& transitions = permitted.granted[c.index()];
    return std::find(transitions.begin(), transitions.end(), false) != transitions.end();
  });
  if (!forbids) return false;
  const std::vector<Modes> besides = let_come(modes, action, part);
  return std::any_of(besides.begin(), besides.end(),
                     [&](const Modes& next) { return risks(modes, next, part, permitted); });
}

}  // namespace rmpl::runtime
