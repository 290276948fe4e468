// From a path that a search has found to a witness that has been replayed.
// SPDX-License-Identifier: MIT
#include "verifier/closed_loop/evidence.hpp"

#include "base/check.hpp"

#include "verifier/closed_loop/timetable.hpp"
#include "verifier/witness/hindrance.hpp"
#include "verifier/witness/steps_at.hpp"
#include "verifier/witness/undone.hpp"

namespace rmpl::verifier {

using automata::Modes;
using automata::Ticks;
using Kind = ProgramProperty::Kind;

Evidence::Evidence(Loop& loop, automata::PlantStep& step, runtime::Reconfigurer& reconfigurer,
                   std::shared_ptr<const runtime::NominalGraph> graph, const CheckOptions& options)
    : loop_(loop), step_(step), reconfigurer_(reconfigurer), graph_(std::move(graph)), options_(options) {}

Witness Evidence::of(const std::vector<PathState>& path, const SymbolicState& end, ProgramSystem& system,
                     const Query& query, const ProgramProperty* shown) {
  if (ProgramSystem::is_end(path.back().discrete)) return stopped(path, end, system, query, shown);
  Witness witness = earliest_witness(path, loop_, query);
  const bool endless = query.aim == Query::Aim::endless_wait || query.deadline == unbounded;
  witness.waits_for_ever = endless;
  note_owed(witness, shown);
  if (query.aim == Query::Aim::undone) witness.undone = undone_at_end(judge().rules(), witness);
  if (endless) witness.hindrances = hindrances(step_, loop_.program(), witness);
  add_refusals(witness);
  return replayed(std::move(witness), shown);
}

Witness Evidence::of(const Lasso& lasso, const Query& query, const ProgramProperty& shown) {
  Witness witness = earliest_witness(lasso.path, loop_, query);
  witness.repeats_from = lasso.repeats_from + 1;
  note_owed(witness, &shown);
  return replayed(std::move(witness), &shown);
}

/// Since when a response is owed.
void Evidence::note_owed(Witness& witness, const ProgramProperty* shown) {
  if (shown == nullptr || shown->kind != Kind::response) return;
  const Response response{shown->formula, shown->then, shown->within};
  witness.owed_since = owed_since(judge().rules(), response, claim_terms(), witness);
}

/// Which other goals of a cycle without a plan have none by themselves.
void Evidence::add_refusals(Witness& witness) {
  const Event& last = witness.events.back();
  for (const runtime::LeftOut& left_out : last.cycle->left_out) {
    witness.refused.push_back({left_out.goals.formula(), left_out.why, left_out.reason});
  }
  if (last.cycle->outcome != runtime::Reconfiguration::Outcome::no_plan) return;
  const std::vector<automata::Formula> goal = conjuncts_of(last.cycle->goals.formula());
  for (std::size_t g = 0; g < goal.size(); ++g) {
    if (g == last.cycle->why.conjunct || goal.size() == 1) continue;
    auto answer = reconfigurer_.next(last.modes, goal[g]);
    if (answer.outcome != runtime::Reconfiguration::Outcome::no_plan) continue;
    witness.refused.push_back({goal[g], answer.why, std::move(answer.reason)});
  }
}

/// A run that is cut off, or that goes round while time stands still.
Witness Evidence::stopped(std::vector<PathState> path, const SymbolicState& accepted, ProgramSystem& system,
                          const Query& query, const ProgramProperty* shown) {
  path.pop_back();
  const std::size_t last = path.size() - 1;
  const Standstill found = system.standstill(accepted);
  const PathEnd end = system.end_of(accepted, last);
  for (const Instant& step : found.round) path.push_back(ProgramSystem::state_after(step));
  Witness witness = earliest_witness(path, loop_, query, end);
  witness.stop.emplace();
  witness.stop->still = !found.round.empty();
  if (witness.stop->still) {
    witness.repeats_from = last + found.repeats_from + 1;
  } else {
    explain(witness);
  }
  note_owed(witness, shown);
  return replayed(std::move(witness), shown);
}

/// Names what contradicts each other in what a step would lead to.
void Evidence::explain(Witness& witness) {
  const std::vector<Event>& events = witness.events;
  automata::PlainStep& rules = judge().rules();
  automata::SystemState state{events.front().modes, std::vector<Ticks>(events.front().modes.size(), Ticks{0})};
  for (std::size_t e = 1; e + 1 < events.size(); ++e) {
    const automata::Ticks begin = events[e].cycle->begin;
    if (begin > events[e - 1].time) state = rules.advance(state, events[e].action, state.modes, begin);
    state = rules.advance(state, events[e].action, events[e].modes, events[e].time);
  }
  const automata::ControlAction& held = events.back().action;
  StepsAt steps(rules, state, events.back().time + options_.period.value_or(Ticks{0}), options_.period, &held);
  steps.any(held, [](const Modes&) { return true; });
  witness.stop->refused = steps.refused();
  if (!steps.refused().empty()) witness.stop->conflict = conflict_of(step_.plant(), steps.refused());
}

/// The witness, after it was run anew by rules and a reconfigurer that have no part in the search.
Witness Evidence::replayed(Witness witness, const ProgramProperty* shown) {
  const ReplayRules rules{options_.period, Commands::one, loop_.faults(), options_.from};
  auto failure = judge().replay(witness, rules);
  if (!failure && shown != nullptr) failure = failure_to_show(judge().rules(), *shown, claim_terms(), witness);
  if (failure) throw base::InternalError("a witness fails: " + *failure);
  return witness;
}

LoopJudge& Evidence::judge() {
  if (!judge_) judge_.emplace(loop_.program(), step_.plant(), graph_, options_.period.value_or(automata::Ticks{0}));
  return *judge_;
}

}  // namespace rmpl::verifier
