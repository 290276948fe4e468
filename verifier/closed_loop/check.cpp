// Checking a program: a query for each property, searches, the evidence.
// SPDX-License-Identifier: MIT
#include "verifier/closed_loop/check.hpp"

#include <algorithm>
#include <functional>
#include <numeric>
#include <set>

#include "base/check.hpp"
#include "verifier/closed_loop/cause.hpp"
#include "verifier/closed_loop/lasso.hpp"
#include "verifier/closed_loop/timetable.hpp"
#include "verifier/plant/cut_sets.hpp"
#include "verifier/property/initial_modes.hpp"
#include "verifier/witness/claim.hpp"
#include "verifier/witness/hindrance.hpp"
#include "verifier/witness/loop_replay.hpp"
#include "verifier/witness/steps_at.hpp"
#include "verifier/witness/undone.hpp"

namespace rmpl::verifier {

using automata::Formula;
using automata::Modes;
using automata::Ticks;
using Aim = Query::Aim;
using Kind = ProgramProperty::Kind;

namespace {

std::vector<ProgramProperty> of_programs(const std::vector<Property>& properties) {
  std::vector<ProgramProperty> result;
  for (const Property& property : properties) {
    const auto* asked = std::get_if<ProgramProperty>(&property);
    if (asked == nullptr) throw base::InternalError(name_of(property) + " is asked of a plant alone");
    result.push_back(*asked);
  }
  return result;
}

std::vector<Ticks> times_of(const automata::Program& program, const std::vector<ProgramProperty>& properties) {
  std::vector<Ticks> times = ClockCells(program).constants();
  for (const ProgramProperty& property : properties) {
    const auto add = [&](std::optional<Ticks> time) {
      if (time && !time->is_infinite()) times.push_back(*time);
    };
    if (property.kind == Kind::eventually || property.kind == Kind::response) add(property.within);
    add(property.window.not_before);
    add(property.window.by);
  }
  return times;
}

class ProgramCheck {
 public:
  ProgramCheck(const automata::Program& program, automata::PlantStep& step, const std::vector<Property>& properties,
               const CheckOptions& options, unsigned faults, const Limits& limits)
      : program_(program),
        step_(step),
        properties_(of_programs(properties)),
        options_(options),
        meter_(limits),
        graph_(runtime::reconfiguration_graph(step.plant())),
        reconfigurer_(runtime::make_reconfigurer(step, graph_)),
        loop_(program, step, *reconfigurer_,
              TimeModel::of(options.period, step.plant(), times_of(program, properties_)), faults, meter_) {}

  std::vector<Answer> run() {
    std::vector<Answer> answers(properties_.size());
    std::size_t p = 0;
    try {
      start();
      for (; p < properties_.size(); ++p) {
        Answer& answer = answers[p];
        cut_off_ = {};
        decide(p, answers);
        answer.verdict = answer.witness ? Verdict::violated : Verdict::holds;
        answer.progress = meter_.progress();
        answer.cut_sets = std::move(cut_sets_);
        if (answer.witness && !options_.cut_sets) find_others(properties_[p], answer);
        if (answer.witness) continue;
        answer.vacuous = is_vacuous(properties_[p]);
        answer.cut_off = cut_off_;
        // What would follow is not known, as no time comes in which it would.
        if (cut_off_.still) answer.verdict = Verdict::undecided;
      }
    } catch (const LimitReached& reached) {
      for (; p < properties_.size(); ++p) {
        answers[p].limit = reached.limit;
        answers[p].progress = meter_.progress();
      }
    }
    for (Answer& answer : answers) answer.startless = startless_;
    return answers;
  }

  FaultTable table() {
    FaultTable result;
    std::vector<FaultStep> faults;
    for (std::size_t c = 0; c < step_.plant().components.size(); ++c) {
      const automata::Component& component = step_.plant().components[c];
      for (const automata::Transition& t : component.transitions) {
        if (!component.is_fault(t) || t.from == t.to || !(t.weight.value > 0)) continue;
        const FaultStep fault{automata::ComponentId(c), t.from, t.to};
        if (std::find(faults.begin(), faults.end(), fault) == faults.end()) faults.push_back(fault);
      }
    }
    std::sort(faults.begin(), faults.end());
    result.rows.push_back({std::nullopt});
    for (const FaultStep& fault : faults) result.rows.push_back({fault});
    try {
      start();
      for (FaultOutcome& row : result.rows) {
        fill(row);
        const FaultOutcome& without = result.rows.front();
        if (!row.fault) continue;
        row.anyway = {without.lost.has_value(), without.waits.has_value(), without.goes_on.has_value(),
                      without.stops.has_value()};
      }
    } catch (const LimitReached& reached) {
      result.limit = reached.limit;
    }
    result.progress = meter_.progress();
    return result;
  }

 private:
  void start() {
    start_ = loop_.initial(options_.from);
    startless_ = start_.empty();
    if (startless_ && !options_.from.empty()) refuse_start();
  }

  void decide(std::size_t p, std::vector<Answer>& answers) {
    Answer& answer = answers[p];
    // What waits for ever does not end either.
    for (std::size_t q = 0; q < p && properties_[p].kind == Kind::termination; ++q) {
      if (properties_[q].kind != Kind::endless_wait || !answers[q].witness) continue;
      answer.witness = answers[q].witness;
      answer.same_as = q;
      return;
    }
    answer.witness = violation(properties_[p], {});
  }

  /// Further missing plans and endless waits, each with another cause than those before it, until there are no more.
  void find_others(const ProgramProperty& property, Answer& answer) {
    const bool plans = property.kind == Kind::no_plan;
    if (!plans && property.kind != Kind::endless_wait) return;
    Query query{plans ? Aim::no_plan : Aim::endless_wait};
    std::set<Cause> known;
    const auto learn = [&](const Witness& witness) {
      for (Cause& cause : causes_of(program_, witness, plans)) known.insert(std::move(cause));
    };
    learn(*answer.witness);
    query.fresh = [&](const LoopState& state, const Turn& turn) {
      return !known.contains(
          plans ? no_plan_cause(program_, state.marking, turn.goal, turn.answer.why, turn.answer.reason)
                : waiting_cause(program_, state.marking));
    };
    while (auto witness = search(query, &property)) {
      learn(*witness);
      answer.others.push_back(std::move(*witness));
      answer.progress = meter_.progress();
    }
  }

  /// Whether no state at all satisfies what is never to hold, or no run asks for a response.
  bool is_vacuous(const ProgramProperty& property) {
    if (property.kind == Kind::response) {
      return !search({.aim = Aim::holds, .test = holds(property.formula, options_.entailed)});
    }
    return property.kind == Kind::never && !step_.theory().allows({}, step_.theory().encode(property.formula));
  }

  void fill(FaultOutcome& row) {
    const FaultFilter only{true, row.fault};
    if (row.fault) row.happens = search({.aim = Aim::happens, .filter = only});
    if (row.happens || !row.fault) {
      row.success = search({.aim = Aim::ends_with, .test = success(), .filter = only});
      for (const ProgramProperty& property : properties_) {
        const bool mission = property.kind == Kind::never || property.kind == Kind::eventually ||
                             property.kind == Kind::response || property.kind == Kind::finally;
        if (mission && !row.lost) row.lost = violation(property, only);
      }
      row.no_plan = violation({Kind::no_plan}, only);
      row.waits = violation({Kind::endless_wait}, only);
      row.goes_on = lasso(only, {Kind::termination});
      row.stops = violation({Kind::stuck}, only);
    }
    row.decided = true;
  }

  /// Whether every `finally` holds.
  std::function<bool(const Modes&)> success() {
    std::vector<std::function<bool(const Modes&)>> all;
    for (const ProgramProperty& property : properties_) {
      if (property.kind == Kind::finally) all.push_back(holds(property.formula, !options_.entailed));
    }
    return [all](const Modes& modes) {
      return std::all_of(all.begin(), all.end(), [&](const auto& test) { return test(modes); });
    };
  }

  std::optional<Witness> violation(const ProgramProperty& property, const FaultFilter& only) {
    const bool entailed = options_.entailed;
    switch (property.kind) {
      case Kind::goal_conflict:
        return at_a_moment({.aim = Aim::goal_conflict, .filter = only}, property);
      case Kind::no_plan:
        return at_a_moment({.aim = Aim::no_plan, .filter = only}, property);
      case Kind::endless_wait:
        return at_a_moment({.aim = Aim::endless_wait, .filter = only}, property);
      case Kind::termination: {
        auto found = search({.aim = Aim::endless_wait, .filter = only}, &property);
        if (!found) found = lasso(only, property);
        return found ? std::move(found) : search({.aim = Aim::still, .filter = only}, &property);
      }
      case Kind::stuck:
        return search({.aim = Aim::stop, .filter = only}, &property);
      case Kind::undone:
        return at_a_moment({.aim = Aim::undone, .filter = only}, property);
      case Kind::never:
        return at_a_moment({.aim = Aim::holds, .test = holds(property.formula, entailed), .filter = only}, property);
      case Kind::eventually:
        if (property.within.is_infinite()) return std::nullopt;
        return search({.aim = Aim::late,
                       .test = holds(property.formula, !entailed),
                       .deadline = loop_.time().more_than(property.within),
                       .filter = only},
                      &property);
      case Kind::response:
        if (property.within.is_infinite()) return std::nullopt;
        return search({.aim = Aim::missed,
                       .test = holds(property.then, !entailed),
                       .asks = holds(property.formula, entailed),
                       .deadline = loop_.time().more_than(property.within),
                       .filter = only},
                      &property);
      case Kind::finally: {
        const auto right = holds(property.formula, !entailed);
        const auto wrong = [right](const Modes& modes) { return !right(modes); };
        return at_a_moment({.aim = Aim::ends_with, .test = wrong, .filter = only}, property);
      }
    }
    return std::nullopt;
  }

  /// What is there at one time, within the window. Each round asks for less time than the best so far takes, where that
  /// is wanted, until there is none.
  std::optional<Witness> at_a_moment(Query query, const ProgramProperty& property) {
    const TimeModel& time = loop_.time();
    Interval window;
    if (property.window.not_before) window.lower = time.at_least(*property.window.not_before);
    if (property.window.by) window.upper = time.at_most(*property.window.by);
    if (property.window.not_before || property.window.by) query.window = window;
    std::optional<Witness> best = search(query, &property);
    while (property.fastest && best && best->events.back().time > Ticks{0}) {
      window.upper = time.at_most(best->events.back().time) - 1;
      query.window = window;
      std::optional<Witness> faster = search(query, &property);
      if (!faster) break;
      best = std::move(faster);
    }
    return best;
  }

  /// Whether the formula holds at a state: the store implies it, or (not `certain`) allows it.
  std::function<bool(const Modes&)> holds(const Formula& formula, bool certain) {
    const automata::Theory::Handle handle = step_.theory().encode(formula);
    return [this, handle, certain](const Modes& modes) {
      const std::vector<automata::Assignment> store = automata::assignments_of(step_.plant(), modes);
      return certain ? step_.theory().entails(store, handle) : step_.theory().allows(store, handle);
    };
  }

  /// `shown` is what the witness is to show, where it is a property.
  std::optional<Witness> search(const Query& query, const ProgramProperty* shown = nullptr) {
    ProgramSystem system(loop_, start_, query);
    if (options_.cut_sets && shown != nullptr) return search_cut_sets(system, query, shown);
    const auto path = find_path(system, SearchOrder::fewest_steps, 1, meter_);
    cut_off_.stuck = cut_off_.stuck || system.cut_off().stuck;
    cut_off_.still = cut_off_.still || system.cut_off().still;
    if (!path) return std::nullopt;
    return witness_of(*path, system.accepted(), system, query, shown);
  }

  std::optional<Witness> search_cut_sets(ProgramSystem& system, const Query& query, const ProgramProperty* shown) {
    FaultSets sets;
    system.tell_faults_apart(sets);
    cut_sets_.clear();
    for (const CutPath& cut : minimal_cut_sets(system, sets, meter_)) {
      cut_sets_.push_back({cut.set.faults, witness_of(cut.path, cut.end, system, query, shown)});
    }
    cut_off_.stuck = cut_off_.stuck || system.cut_off().stuck;
    cut_off_.still = cut_off_.still || system.cut_off().still;
    return cut_sets_.empty() ? std::nullopt : std::optional(cut_sets_.front().witness);
  }

  /// Of a path to an accepted state.
  Witness witness_of(const std::vector<PathState>& path, const SymbolicState& end, ProgramSystem& system,
                     const Query& query, const ProgramProperty* shown) {
    if (ProgramSystem::is_end(path.back().discrete)) return stopped(path, end, system, query, shown);
    Witness witness = earliest_witness(path, loop_, query);
    note_owed(witness, shown);
    if (query.aim == Aim::undone) witness.undone = undone_at_end(judge().rules(), witness);
    if (query.aim == Aim::endless_wait) witness.hindrances = hindrances(step_, program_, witness);
    add_refusals(witness);
    return replayed(std::move(witness), query.aim == Aim::endless_wait, shown);
  }

  /// Since when a response is owed.
  void note_owed(Witness& witness, const ProgramProperty* shown) {
    if (shown == nullptr || shown->kind != Kind::response) return;
    const Response response{shown->formula, shown->then, shown->within};
    witness.owed_since = owed_since(judge().rules(), response, options_.entailed, witness);
  }

  /// Which other goals of a cycle without a plan have none by themselves.
  void add_refusals(Witness& witness) {
    const Event& last = witness.events.back();
    if (last.cycle->outcome != runtime::Reconfiguration::Outcome::no_plan) return;
    const auto& goal = last.cycle->goal;
    for (std::size_t g = 0; g < goal.size(); ++g) {
      if (g == last.cycle->why.conjunct || goal.size() == 1) continue;
      auto answer = reconfigurer_->next(last.modes, automata::conjunction_of({&goal[g], 1}));
      if (answer.outcome != runtime::Reconfiguration::Outcome::no_plan) continue;
      witness.refused.push_back({goal[g], answer.why, std::move(answer.reason)});
    }
  }

  /// A run that is cut off, or that goes round while time stands still.
  Witness stopped(std::vector<PathState> path, const SymbolicState& accepted, ProgramSystem& system, const Query& query,
                  const ProgramProperty* shown) {
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
    return replayed(std::move(witness), false, shown);
  }

  /// Names what contradicts each other in what a step would lead to.
  void explain(Witness& witness) {
    const std::vector<Event>& events = witness.events;
    automata::SystemState state{events.front().modes, std::vector<Ticks>(events.front().modes.size(), Ticks{0})};
    for (std::size_t e = 1; e + 1 < events.size(); ++e) {
      state = automata::advance(state, events[e].modes, events[e].time);
    }
    StepsAt steps(judge().rules(), state, events.back().time + options_.period.value_or(Ticks{0}), options_.period);
    steps.any(events.back().action, [](const Modes&) { return true; });
    witness.stop->refused = steps.refused();
    if (!steps.refused().empty()) witness.stop->conflict = conflict_of(step_.plant(), steps.refused());
  }

  std::optional<Witness> lasso(const FaultFilter& only, const ProgramProperty& shown) {
    const Query query{.filter = only, .progress = true};
    ProgramSystem system(loop_, start_, query);
    const auto found = find_lasso(system, loop_, only.fault.has_value(), meter_);
    if (!found) return std::nullopt;
    Witness witness = earliest_witness(found->path, loop_, query);
    witness.repeats_from = found->repeats_from + 1;
    return replayed(std::move(witness), false, &shown);
  }

  /// The witness, after it was run anew by rules and a reconfigurer that have no part in the search.
  Witness replayed(Witness witness, bool endless, const ProgramProperty* shown) {
    const ReplayRules rules{options_.period, Commands::one, loop_.faults(), options_.from, endless};
    auto failure = judge().replay(witness, rules);
    if (!failure && shown != nullptr) failure = failure_to_show(judge().rules(), *shown, options_.entailed, witness);
    if (failure) throw base::InternalError("a witness fails: " + *failure);
    return witness;
  }

  /// Made where there is something to replay.
  LoopJudge& judge() {
    if (!judge_) judge_.emplace(program_, step_.plant(), graph_);
    return *judge_;
  }

  const automata::Program& program_;
  automata::PlantStep& step_;
  std::vector<ProgramProperty> properties_;
  const CheckOptions& options_;
  Meter meter_;
  std::shared_ptr<const runtime::NominalGraph> graph_;
  std::unique_ptr<runtime::Reconfigurer> reconfigurer_;
  Loop loop_;
  std::optional<LoopJudge> judge_;  ///< has no part in the search: it replays what that finds
  std::vector<LoopState> start_;
  std::vector<CutSet> cut_sets_;  ///< of the answer at hand, where they are asked for
  bool startless_ = false;        ///< known to be
  CutOff cut_off_;                ///< seen by the searches for the answer at hand
};

/// Round by round one fault more, until every property is violated or as many as may be were tried.
std::vector<Answer> with_fewest_faults(const automata::Program& program, automata::PlantStep& step,
                                       const std::vector<Property>& properties, const CheckOptions& options,
                                       const Limits& limits) {
  std::vector<Answer> answers(properties.size());
  std::vector<std::size_t> open(properties.size());
  std::iota(open.begin(), open.end(), std::size_t{0});
  Progress spent;
  for (unsigned faults = 0; faults <= options.faults.value() && !open.empty(); ++faults) {
    std::vector<Property> asked;
    for (const std::size_t p : open) asked.push_back(properties[p]);
    const Limits left = remaining(limits, spent);
    std::vector<Answer> found = ProgramCheck(program, step, asked, options, faults, left).run();
    spent.seconds += found.back().progress.seconds;
    spent.states += found.back().progress.states;
    std::vector<std::size_t> still_open;
    for (std::size_t i = 0; i < found.size(); ++i) {
      Answer& answer = answers[open[i]] = std::move(found[i]);
      answer.progress.seconds = spent.seconds;
      answer.progress.states = spent.states;
      if (answer.same_as) answer.same_as = open[*answer.same_as];
      if (answer.witness) {
        answer.fewest_faults = faults;
      } else if (!answer.limit) {
        still_open.push_back(open[i]);
      }
    }
    open = std::move(still_open);
  }
  return answers;
}

}  // namespace

std::vector<Answer> check(const automata::Program& program, automata::PlantStep& step,
                          const std::vector<Property>& properties, const CheckOptions& options, const Limits& limits) {
  if (options.fewest_faults) return with_fewest_faults(program, step, properties, options, limits);
  return ProgramCheck(program, step, properties, options, options.faults.value(), limits).run();
}

FaultTable check_each_fault(const automata::Program& program, automata::PlantStep& step,
                            const std::vector<Property>& properties, const CheckOptions& options,
                            const Limits& limits) {
  return ProgramCheck(program, step, properties, options, 1, limits).table();
}

}  // namespace rmpl::verifier
