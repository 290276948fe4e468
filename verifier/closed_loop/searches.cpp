// Violations of properties of a program.
// SPDX-License-Identifier: MIT
#include "verifier/closed_loop/searches.hpp"

#include "base/bounded_cache.hpp"
#include "base/check.hpp"
#include "verifier/check/soonest.hpp"
#include "verifier/cut_set/cut_sets.hpp"
#include "verifier/property/initial_modes.hpp"

namespace rmpl::verifier {

using automata::Formula;
using automata::Modes;
using automata::Ticks;
using Kind = ProgramProperty::Kind;

namespace {

/// Modes whose answers about one formula are remembered.
constexpr std::size_t answers_remembered = 1u << 16;

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

std::vector<Formula> formulas_of(const std::vector<ProgramProperty>& properties) {
  std::vector<Formula> formulas;
  for (const ProgramProperty& property : properties) {
    formulas.push_back(property.formula);
    formulas.push_back(property.then);
  }
  return formulas;
}

}  // namespace

std::vector<ProgramProperty> of_programs(const std::vector<Property>& properties) {
  std::vector<ProgramProperty> result;
  for (const Property& property : properties) {
    const auto* asked = std::get_if<ProgramProperty>(&property);
    if (asked == nullptr) throw base::InternalError(name_of(property) + " is asked of a plant alone");
    result.push_back(*asked);
  }
  return result;
}

Searches::Searches(const automata::Program& program, automata::PlantStep& step,
                   const std::vector<ProgramProperty>& properties, const CheckOptions& options, const Limits& limits)
    : step_(step),
      options_(options),
      meter_(limits),
      graph_(runtime::reconfiguration_graph(step.plant())),
      reconfigurer_(runtime::make_reconfigurer(step, graph_, options.period.value_or(automata::Ticks{0}))),
      loop_(program, step, *reconfigurer_, TimeModel::of(options.period, step.plant(), times_of(program, properties)),
            0, meter_, formulas_of(properties)),
      evidence_(loop_, step, *reconfigurer_, graph_, options) {}

void Searches::allow_faults(unsigned faults) {
  loop_.allow_faults(faults);
  memories_.clear();
  room_ = StepMemory::Room();
}

const std::vector<LoopState>& Searches::start() {
  if (start_) return *start_;
  start_ = loop_.initial(options_.from);
  if (start_->empty() && !options_.from.empty()) refuse_start();
  return *start_;
}

bool Searches::startless() { return start().empty(); }

void Searches::forget_seen() {
  cut_off_ = {};
  cut_sets_.clear();
}

void Searches::see(const ProgramSystem& system) { cut_off_ |= system.cut_off(); }

std::optional<Witness> Searches::violation(const ProgramProperty& property, const FaultFilter& only) {
  const bool entailed = options_.entailed;
  switch (property.kind) {
    case Kind::goal_conflict:
      return at_a_moment({.aim = Query::Aim::goal_conflict, .filter = only}, property);
    case Kind::no_plan:
      return at_a_moment({.aim = Query::Aim::no_plan, .filter = only}, property);
    case Kind::endless_wait:
      return at_a_moment({.aim = Query::Aim::endless_wait, .filter = only}, property);
    case Kind::termination: {
      auto found = search({.aim = Query::Aim::endless_wait, .filter = only}, &property);
      if (!found) found = lasso({.filter = only}, property);
      return found ? std::move(found) : search({.aim = Query::Aim::still, .filter = only}, &property);
    }
    case Kind::stuck:
      return search({.aim = Query::Aim::stop, .filter = only}, &property);
    case Kind::undone:
      return at_a_moment({.aim = Query::Aim::undone, .filter = only}, property);
    case Kind::never: {
      const auto bad = holds(property.formula, entailed);
      return at_a_moment({.aim = Query::Aim::holds, .test = bad, .filter = only}, property);
    }
    case Kind::eventually: {
      const auto right = holds(property.formula, !entailed);
      return what_does_not_come({.aim = Query::Aim::late, .test = right, .filter = only}, property);
    }
    case Kind::response: {
      const auto asks = holds(property.formula, entailed);
      const auto answers = holds(property.then, !entailed);
      return what_does_not_come({.aim = Query::Aim::missed, .test = answers, .asks = asks, .filter = only}, property);
    }
    case Kind::finally: {
      const auto right = holds(property.formula, !entailed);
      const auto wrong = [right](const LoopState& state) { return !right(state); };
      return at_a_moment({.aim = Query::Aim::ends_with, .test = wrong, .filter = only}, property);
    }
  }
  return std::nullopt;
}

/// What does not come in time, or where any time will do, on a run that goes on without it.
std::optional<Witness> Searches::what_does_not_come(Query query, const ProgramProperty& property) {
  const bool some_day = property.within.is_infinite();
  query.deadline = some_day ? unbounded : loop_.time().more_than(property.within);
  auto found = search(query, &property);
  return found || !some_day ? std::move(found) : lasso(std::move(query), property);
}

/// What is there at one time, within the window; the soonest, where that is wanted.
std::optional<Witness> Searches::at_a_moment(Query query, const ProgramProperty& property) {
  const TimeModel& time = loop_.time();
  const Interval window = interval_of(property.window, time);
  if (!property.window.is_all()) query.window = window;
  std::optional<Witness> best = search(query, &property);
  if (!property.fastest || options_.cut_sets) return best;
  hasten(best, window, time, [&](const Interval& sooner) {
    query.window = sooner;
    return search(query, &property);
  });
  return best;
}

std::function<bool(const LoopState&)> Searches::holds(const Formula& formula, bool certain) {
  if (has_knowledge(formula)) {
    return [this, formula, certain](const LoopState& state) { return loop_.holds(formula, state, certain); };
  }
  using Answers = base::BoundedCache<Modes, bool, automata::ModesHash>;
  const automata::Theory::Handle handle = step_.theory().encode(formula);
  const auto answers = std::make_shared<Answers>(answers_remembered);
  return [this, handle, certain, answers](const LoopState& state) {
    return answers->find_or(state.modes, [&] {
      const std::vector<automata::Assignment> store = automata::assignments_of(step_.plant(), state.modes);
      return certain ? step_.theory().entails(store, handle) : step_.theory().allows(store, handle);
    });
  };
}

/// Searches have a memory in common that watch the same clocks: all of them but those with a stopwatch, which have one
/// with the other rows of a table for the same property, unless its window moves. The first of them remembers nothing:
/// it may be the only one.
void Searches::remember(ProgramSystem& system, const Query& query, const ProgramProperty* shown) {
  if (query.aim == Query::Aim::undone || options_.cut_sets) return;
  const bool stopwatch = query.aim == Query::Aim::late || query.aim == Query::Aim::missed || query.window.has_value();
  if (stopwatch && (shown == nullptr || shown->fastest)) return;
  const bool progress = query.progress && loop_.time().is_dense();
  const auto [at, first] = memories_.try_emplace({stopwatch ? shown : nullptr, query.filter.only, progress}, room_);
  if (!first) system.remember_in(at->second);
}

std::optional<Witness> Searches::search(const Query& query, const ProgramProperty* shown) {
  ProgramSystem system(loop_, start(), query);
  if (options_.cut_sets && shown != nullptr) return search_cut_sets(system, query, shown);
  remember(system, query, shown);
  const auto path = find_path(system, SearchOrder::fewest_steps, meter_);
  see(system);
  if (!path) return std::nullopt;
  return evidence_.of(*path, system.accepted(), system, query, shown);
}

std::optional<Witness> Searches::search_cut_sets(ProgramSystem& system, const Query& query,
                                                 const ProgramProperty* shown) {
  FaultSets sets;
  system.tell_faults_apart(sets);
  std::map<std::vector<Fault>, Witness> witnesses;
  cut_sets_.clear();
  const CutPaths found = minimal_cut_sets(system, sets, meter_, [&](const CutPath& cut) {
    witnesses.emplace(cut.set.faults, evidence_.of(cut.path, cut.end, system, query, shown));
    return true;
  });
  for (const FaultSet& cut : found.sets) cut_sets_.push_back({cut.faults, std::move(witnesses.at(cut.faults))});
  see(system);
  if (found.limit) throw LimitReached{*found.limit};
  return cut_sets_.empty() ? std::nullopt : std::optional(cut_sets_.front().witness);
}

namespace {

/// Runs of a closed loop, of which those count on which what is to come has been asked for and has not come, and on
/// which the fault has happened that they are looked at after.
class LoopRuns : public Runs {
 public:
  LoopRuns(ProgramSystem& system, Loop& loop, const Query& query) : system_(system), loop_(loop), query_(query) {}

  TransitionSystem& system() override { return system_; }
  [[nodiscard]] bool counts(const SymbolicState& state) const override {
    const bool asked = query_.aim == Query::Aim::nothing || system_.is_due(state.discrete);
    return asked && (!query_.filter.fault || ProgramSystem::happened(state.discrete));
  }
  Modes modes(std::uint64_t discrete) override { return loop_[ProgramSystem::loop_state(discrete)].modes; }
  Passage passage(const SymbolicState& from, const SymbolicState& to, const Label&) override {
    const LoopStateId id = ProgramSystem::loop_state(from.discrete);
    if (!turn_ || id_ != id) turn_ = loop_.turn(id);
    id_ = id;
    const bool time = !loop_.time().is_dense() || ProgramSystem::progressed(to.discrete);
    return {&turn_->exits, nullptr, time, turn_->anew};
  }

 private:
  ProgramSystem& system_;
  Loop& loop_;
  const Query& query_;
  LoopStateId id_{std::size_t{0}};
  std::shared_ptr<const Turn> turn_;  ///< that of `id_`
};

}  // namespace

std::optional<Witness> Searches::lasso(Query query, const ProgramProperty& shown) {
  query.progress = true;
  ProgramSystem system(loop_, start(), query);
  remember(system, query, &shown);
  LoopRuns runs(system, loop_, query);
  const auto found = find_lasso(runs, meter_);
  see(system);
  if (!found) return std::nullopt;
  return evidence_.of(*found, query, shown);
}

}  // namespace rmpl::verifier
