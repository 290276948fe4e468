// Checking a program: a quest for each property, searches, the evidence.
// SPDX-License-Identifier: MIT
#include "verifier/closed_loop/check.hpp"

#include <algorithm>
#include <functional>
#include <set>

#include "base/check.hpp"
#include "verifier/closed_loop/lasso.hpp"
#include "verifier/closed_loop/timetable.hpp"
#include "verifier/property/initial_modes.hpp"
#include "verifier/witness/claim.hpp"
#include "verifier/witness/loop_replay.hpp"
#include "verifier/witness/steps_at.hpp"

namespace rmpl::verifier {

using automata::Formula;
using automata::Modes;
using automata::Ticks;
using Aim = Quest::Aim;
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
    if (property.kind == Kind::eventually && !property.within.is_infinite()) times.push_back(property.within);
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
        answer.witness = violation(properties_[p], {});
        answer.verdict = answer.witness ? Verdict::violated : Verdict::holds;
        answer.progress = meter_.progress();
        if (answer.witness) continue;
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

  void fill(FaultOutcome& row) {
    const FaultFilter only{true, row.fault};
    if (row.fault) row.happens = search({Aim::happens, nullptr, 0, only, false});
    if (row.happens || !row.fault) {
      row.success = search({Aim::ends_with, success(), 0, only, false});
      for (const ProgramProperty& property : properties_) {
        const bool mission =
            property.kind == Kind::never || property.kind == Kind::eventually || property.kind == Kind::finally;
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
        return search({Aim::goal_conflict, nullptr, 0, only, false}, &property);
      case Kind::no_plan:
        return search({Aim::no_plan, nullptr, 0, only, false}, &property);
      case Kind::endless_wait:
        return search({Aim::endless_wait, nullptr, 0, only, false}, &property);
      case Kind::termination: {
        auto found = search({Aim::endless_wait, nullptr, 0, only, false}, &property);
        if (!found) found = lasso(only, property);
        return found ? std::move(found) : search({Aim::still, nullptr, 0, only, false}, &property);
      }
      case Kind::stuck:
        return search({Aim::stop, nullptr, 0, only, false}, &property);
      case Kind::never:
        return search({Aim::holds, holds(property.formula, entailed), 0, only, false}, &property);
      case Kind::eventually:
        if (property.within.is_infinite()) return std::nullopt;
        return search(
            {Aim::late, holds(property.formula, !entailed), loop_.time().more_than(property.within), only, false},
            &property);
      case Kind::finally: {
        const auto right = holds(property.formula, !entailed);
        return search({Aim::ends_with, [right](const Modes& modes) { return !right(modes); }, 0, only, false},
                      &property);
      }
    }
    return std::nullopt;
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
  std::optional<Witness> search(const Quest& quest, const ProgramProperty* shown = nullptr) {
    ProgramSystem system(loop_, start_, quest);
    const auto path = find_path(system, SearchOrder::fewest_steps, 1, meter_);
    cut_off_.stuck = cut_off_.stuck || system.cut_off().stuck;
    cut_off_.still = cut_off_.still || system.cut_off().still;
    if (!path) return std::nullopt;
    if (ProgramSystem::is_end(path->back().discrete)) return stopped(*path, system, quest, shown);
    return replayed(earliest_witness(*path, loop_, quest), quest.aim == Aim::endless_wait, shown);
  }

  /// A run that is cut off, or that goes round while time stands still.
  Witness stopped(std::vector<PathState> path, ProgramSystem& system, const Quest& quest,
                  const ProgramProperty* shown) {
    path.pop_back();
    const std::size_t last = path.size() - 1;
    const Standstill found = system.standstill(system.accepted());
    const PathEnd end = system.end_of(system.accepted(), last);
    for (const Instant& step : found.round) path.push_back(ProgramSystem::state_after(step));
    Witness witness = earliest_witness(path, loop_, quest, end);
    witness.stop.emplace();
    witness.stop->still = !found.round.empty();
    if (witness.stop->still) {
      witness.repeats_from = last + found.repeats_from + 1;
    } else {
      explain(witness);
    }
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
    const Quest quest{Aim::nothing, nullptr, 0, only, true};
    ProgramSystem system(loop_, start_, quest);
    const auto found = find_lasso(system, loop_, only.fault.has_value(), meter_);
    if (!found) return std::nullopt;
    Witness witness = earliest_witness(found->path, loop_, quest);
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
  bool startless_ = false;  ///< known to be
  CutOff cut_off_;          ///< seen by the searches for the answer at hand
};

}  // namespace

std::vector<Answer> check(const automata::Program& program, automata::PlantStep& step,
                          const std::vector<Property>& properties, const CheckOptions& options, const Limits& limits) {
  return ProgramCheck(program, step, properties, options, options.faults.value(), limits).run();
}

FaultTable check_each_fault(const automata::Program& program, automata::PlantStep& step,
                            const std::vector<Property>& properties, const CheckOptions& options,
                            const Limits& limits) {
  return ProgramCheck(program, step, properties, options, 1, limits).table();
}

}  // namespace rmpl::verifier
