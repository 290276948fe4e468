// The closed loop as a symbolic transition system.
// SPDX-License-Identifier: MIT
#include "verifier/closed_loop/program_system.hpp"

#include <algorithm>
#include <memory>
#include <numeric>

#include "base/check.hpp"

namespace rmpl::verifier {

using automata::ComponentId;

ProgramSystem::ProgramSystem(Loop& loop, const std::vector<LoopState>& start, const Query& query)
    : loop_(loop), start_(start), query_(query) {}

void ProgramSystem::initial(const Visit& visit) {
  for (const LoopState& state : start_) {
    const std::size_t clocks = extra() + state.groups.size() + loop_.live(state.modes).size();
    std::vector<Cell> chosen;
    choose_cells(state, chosen, Zone(clocks), {std::nullopt, 0, 0, {no_move, no_wait, false}}, visit);
  }
}

void ProgramSystem::successors(const SymbolicState& state, const Visit& visit) {
  const LoopStateId id = loop_state(state.discrete);
  if (is_end(state.discrete)) return;
  if (loop_[id].marking.empty() && !is_due(state.discrete)) return;
  const std::shared_ptr<const Turn> turn = loop_.turn(id, loop_.faults() - fault_count(state.faults));
  StepMemory::Entry* const known = memory_ != nullptr ? memory_->find(state) : nullptr;
  if (known != nullptr && known->moves.empty()) known->moves.resize(turn->outcomes.size());
  for (std::uint32_t move = 0; move < turn->outcomes.size(); ++move) {
    if (!is_allowed(state, turn->outcomes[move])) continue;
    through(
        known != nullptr ? &known->moves[move] : nullptr, [&](const Visit& to) { step(state, *turn, move, to); },
        visit);
  }
  through(
      known != nullptr ? &known->end : nullptr, [&](const Visit& to) { enter_end(state, to); }, visit);
  loop_.explored(id);
}

/// Visits what a move leads to, as remembered or as `work_out` tells it.
void ProgramSystem::through(StepMemory::Move* known, base::FunctionRef<void(const Visit&)> work_out,
                            const Visit& visit) {
  if (known == nullptr) return work_out(visit);
  if (!known->known) {
    known->steps.clear();
    work_out([&](SymbolicState&& next, const Label& label) {
      known->steps.push_back({std::move(next), label});
      memory_->count(known->steps.back());
    });
    known->known = true;
  }
  for (const StepMemory::Step& next : known->steps) visit(SymbolicState(next.state), next.label);
}

/// Whether the faults of the move are within the budget, and ones that may happen.
bool ProgramSystem::is_allowed(const SymbolicState& state, const Outcome& outcome) const {
  if (fault_count(state.faults) + outcome.faults > loop_.faults()) return false;
  const auto& filter = query_.filter;
  return !filter.only || outcome.faults == 0 || !is_filtered(loop_[loop_state(state.discrete)], outcome);
}

unsigned ProgramSystem::faults_after(const SymbolicState& state, const Outcome& outcome) const {
  if (sets_ == nullptr) return state.faults + outcome.faults;
  const automata::Modes& from = loop_[loop_state(state.discrete)].modes;
  return sets_->after(state.faults, loop_.plant(), from, outcome.state.modes, outcome.faults);
}

unsigned ProgramSystem::fault_count(unsigned faults) const {
  return sets_ == nullptr ? faults : (*sets_)[faults].count;
}

TransitionSystem::FaultMeasures ProgramSystem::fault_measures(unsigned faults) const {
  return sets_ == nullptr ? TransitionSystem::fault_measures(faults) : sets_->measures(faults);
}

bool ProgramSystem::no_more_faults(unsigned a, unsigned b) const {
  return fault_count(a) <= fault_count(b) && (sets_ == nullptr || subset((*sets_)[a], (*sets_)[b]));
}

bool ProgramSystem::is_filtered(const LoopState& from, const Outcome& outcome) const {
  const auto& fault = query_.filter.fault;
  if (!fault || outcome.faults > 1) return true;
  const std::size_t c = fault->component.index();
  return from.modes[c] != fault->from || outcome.state.modes[c] != fault->to;
}

void ProgramSystem::note_achieved(const SymbolicState& state, const Turn& turn, const Outcome& outcome,
                                  Arrival& arrival) {
  const automata::Modes& from = loop_[loop_state(state.discrete)].modes;
  const std::uint64_t before = state.discrete >> achieved_shift;
  const CycleTaken cycle{turn.goals.goal, turn.answer.why.purpose, turn.action, from, outcome.state.modes};
  if (!loop_.taken_away(*achieved_[before], cycle).empty()) arrival.phase |= undone_bit;
  const std::uint64_t after =
      number(achieved_after(loop_.plant(), *achieved_[before], turn.goals.goal, from, outcome.state.modes));
  arrival.phase |= after << achieved_shift;
  if (after == before) return;
  arrival.from.reset();
  arrival.label.silent = false;
}

std::uint64_t ProgramSystem::number(const Achieved& achieved) {
  const auto [at, fresh] = achieved_numbers_.try_emplace(achieved, achieved_.size());
  if (fresh) achieved_.push_back(&at->first);
  CHECK(at->second < std::uint64_t{1} << (64 - achieved_shift));
  return at->second;
}

void ProgramSystem::step(const SymbolicState& state, const Turn& turn, std::uint32_t move, const Visit& visit) {
  const LoopStateId id = loop_state(state.discrete);
  const LoopState& from = loop_[id];
  const Outcome& outcome = turn.outcomes[move];
  const bool same = outcome.same && turn.anew.empty();
  Arrival arrival{same ? std::optional(id) : std::nullopt,
                  faults_after(state, outcome),
                  state.discrete & (happened_bit | owed_bit),
                  {move, no_wait, same}};
  if (query_.filter.only && outcome.faults > 0) arrival.phase |= happened_bit;
  if (query_.aim == Query::Aim::undone) note_achieved(state, turn, outcome, arrival);
  // A program clock starts with the cycle, the clock of a component with its end.
  const std::size_t old = state.zone.clocks();
  std::vector<std::size_t> sources;
  for (std::size_t clock = 1; clock <= old; ++clock) sources.push_back(clock);
  sources.push_back(0);
  Zone zone = state.zone.select(sources);
  if (!loop_.time().is_dense()) zone.tick();
  for (const ClockBound& bound : outcome.bounds) {
    const std::size_t clock = clock_of(bound.component, from);
    if (!zone.constrain(clock, bound.clock)) return;
  }
  sources.clear();
  for (std::size_t clock = 1; clock <= extra(); ++clock) sources.push_back(clock);
  for (const std::size_t source : outcome.sources) sources.push_back(source == 0 ? old + 1 : extra() + source);
  for (const ComponentId component : loop_.live(outcome.state.modes)) {
    const bool kept = from.modes[component.index()] == outcome.state.modes[component.index()] &&
                      !std::binary_search(turn.anew.begin(), turn.anew.end(), component);
    sources.push_back(kept ? clock_of(component, from) : 0);
  }
  const auto go_on = [&](const Zone& at_end) {
    std::vector<Cell> chosen;
    choose_cells(outcome.state, chosen, at_end.select(sources), arrival, visit);
  };
  if (!progress_clock()) return go_on(zone);
  const std::size_t clock = extra();
  Zone still = zone;
  if (still.constrain(clock, {0, 0})) go_on(still);
  if (!zone.constrain(clock, {loop_.time().grain(), unbounded})) return;
  arrival.phase |= progressed_bit;
  sources[clock - 1] = 0;
  go_on(zone);
}

void ProgramSystem::choose_cells(const LoopState& state, std::vector<Cell>& chosen, const Zone& zone,
                                 const Arrival& arrival, const Visit& visit) {
  const ClockCells& cells = loop_.cells();
  const std::size_t g = chosen.size();
  if (g < state.groups.size()) {
    for (Cell cell = loop_.cell(state.groups[g]);; cell = cells.around(state.groups[g].clocks, cell.last + 1)) {
      const Interval readings = cells.units(cell, loop_.time());
      const bool ordered =
          std::all_of(chosen.begin(), chosen.end(), [&](const Cell& earlier) { return cells.in_order(earlier, cell); });
      Zone within = zone;
      if (ordered && !readings.empty() && readings.lower != unbounded && within.constrain(extra() + g + 1, readings)) {
        chosen.push_back(cell);
        choose_cells(state, chosen, within, arrival, visit);
        chosen.pop_back();
      }
      if (cells.is_last(cell)) return;
    }
  }
  // A clock in its last cell need not be kept.
  LoopState entered{state.marking, state.modes, state.passed, {}, state.no_plan, state.position};
  std::vector<std::size_t> sources;
  for (std::size_t clock = 1; clock <= extra(); ++clock) sources.push_back(clock);
  for (std::size_t i = 0; i < state.groups.size(); ++i) {
    const auto& clocks = state.groups[i].clocks;
    if (cells.is_last(chosen[i])) {
      entered.passed.insert(entered.passed.end(), clocks.begin(), clocks.end());
    } else {
      entered.groups.push_back({clocks, chosen[i].first});
      sources.push_back(extra() + i + 1);
    }
  }
  std::sort(entered.passed.begin(), entered.passed.end());
  for (std::size_t clock = extra() + state.groups.size() + 1; clock <= zone.clocks(); ++clock) sources.push_back(clock);
  const LoopStateId id = loop_.number(entered);
  if (arrival.from != id) enter(id, zone.select(sources), arrival, visit);
}

void ProgramSystem::enter(LoopStateId id, const Zone& zone, const Arrival& arrival, const Visit& visit) {
  const LoopState& state = loop_[id];
  Zone now = zone;
  if (is_due(arrival.phase) && query_.test(state)) {
    if (!stopwatch()) return;
    // The period that brings it may be the first one to end after the deadline: that is too late.
    if (!now.constrain(1, {query_.deadline, unbounded})) return;
  }
  if (query_.aim == Query::Aim::missed && !owed(arrival.phase) && query_.asks(state) && !query_.test(state)) {
    // What is missed later on in the same modes is missed from here on too.
    std::vector<std::size_t> sources(now.clocks());
    std::iota(sources.begin(), sources.end(), std::size_t{1});
    if (stopwatch()) sources.front() = 0;
    Arrival asked = arrival;
    asked.phase |= owed_bit;
    stay(id, now.select(sources), asked, visit);
  }
  stay(id, std::move(now), arrival, visit);
}

void ProgramSystem::stay(LoopStateId id, Zone now, const Arrival& arrival, const Visit& visit) {
  const std::vector<ClockLimits> clocks = limits_in(loop_[id], is_due(arrival.phase));
  const std::uint64_t discrete = (std::uint64_t{id.value} << phase_bits) | arrival.phase;
  Label label = arrival.label;
  bool whole = false;
  const std::shared_ptr<const Turn> turn = loop_.turn(id);
  // What is looked at up to the end of the program is over as it ends: no time passes there.
  const std::size_t waits = loop_[id].marking.empty() && !is_due(arrival.phase) ? 0 : turn->waits.size();
  for (std::size_t w = 0; w < waits; ++w) {
    Zone later = now;
    if (!wait(later, turn->waits[w], id)) continue;
    whole = whole || later.includes(now);
    later.extrapolate(clocks);
    label.wait = static_cast<std::uint32_t>(w);
    visit({discrete, arrival.faults, std::move(later)}, label);
  }
  if (whole) return;
  now.extrapolate(clocks);
  label.wait = no_wait;
  visit({discrete, arrival.faults, std::move(now)}, label);
}

bool ProgramSystem::wait(Zone& zone, const Wait& wait, LoopStateId id) const {
  const LoopState& state = loop_[id];
  for (const ClockBound& b : wait.bounds) {
    if (!zone.constrain(clock_of(b.component, state), b.clock)) return false;
  }
  if (!wait.anew.empty()) zone.tick();
  zone.elapse();
  for (const ClockBound& b : wait.bounds) {
    if (std::binary_search(wait.anew.begin(), wait.anew.end(), b.component)) continue;
    if (!zone.constrain(clock_of(b.component, state), {0, b.clock.upper})) return false;
  }
  if (!wait.restarted.empty() || !wait.anew.empty()) {
    std::vector<std::size_t> sources(zone.clocks());
    std::iota(sources.begin(), sources.end(), std::size_t{1});
    for (const std::size_t g : wait.restarted) sources[extra() + g] = 0;
    for (const ComponentId c : wait.anew) sources[clock_of(c, state) - 1] = 0;
    zone = zone.select(sources);
  }
  for (std::size_t g = 0; g < state.groups.size(); ++g) {
    const Interval cell = loop_.cells().units(loop_.cell(state.groups[g]), loop_.time());
    if (!zone.constrain(extra() + g + 1, {0, cell.upper})) return false;
  }
  return true;
}

bool ProgramSystem::accepts(const SymbolicState& state) const {
  if (!is_wanted(state)) return false;
  accepted_ = state;
  return true;
}

bool ProgramSystem::is_wanted(const SymbolicState& state) const {
  if (query_.filter.fault && (state.discrete & happened_bit) == 0) return false;
  const LoopStateId id = loop_state(state.discrete);
  const LoopState& at = loop_[id];
  const bool still = (state.discrete & still_bit) != 0;
  cut_off_.stuck = cut_off_.stuck || (state.discrete & stuck_bit) != 0;
  cut_off_.still = cut_off_.still || still;
  if (is_end(state.discrete)) {
    return query_.aim == Query::Aim::stop || (still && (query_.aim == Query::Aim::still || is_due(state.discrete))) ||
           is_last_chance(state);
  }
  cut_off_.spent = cut_off_.spent || is_spent(state);
  const auto& window = query_.window;
  if (window && !state.zone.meets(1, *window)) return false;
  switch (query_.aim) {
    case Query::Aim::goal_conflict:
      return !loop_.turn(id)->conflicts.empty();
    case Query::Aim::no_plan:
      return lacks_a_plan(*loop_.turn(id)) && is_fresh(id);
    case Query::Aim::endless_wait:
      return !at.marking.empty() && may_wait_for_ever(state) && is_fresh(id);
    case Query::Aim::holds:
      return query_.test(at);
    case Query::Aim::late:
    case Query::Aim::missed:
      if (!is_due(state.discrete)) return false;
      return stopwatch() ? state.zone.upper(1) >= query_.deadline : may_wait_for_ever(state);
    case Query::Aim::ends_with:
      return at.marking.empty() && query_.test(at);
    case Query::Aim::happens:
      return true;
    case Query::Aim::undone:
      return (state.discrete & undone_bit) != 0;
    case Query::Aim::spent:
      return is_spent(state);
    case Query::Aim::stop:
    case Query::Aim::still:
    case Query::Aim::nothing:
      return false;
  }
  return false;
}

bool ProgramSystem::may_wait_for_ever(const SymbolicState& state) const {
  const LoopStateId id = loop_state(state.discrete);
  const std::shared_ptr<const Turn> turn = loop_.turn(id);
  return std::any_of(turn->waits.begin(), turn->waits.end(), [&](const Wait& w) {
    Zone zone = state.zone;
    if (!w.endless || !wait(zone, w, id)) return false;
    const bool settles = std::all_of(w.settled.begin(), w.settled.end(), [&](const ClockBound& b) {
      return zone.constrain(clock_of(b.component, loop_[id]), b.clock);
    });
    return settles && (!query_.window || zone.constrain(1, *query_.window));
  });
}

bool ProgramSystem::is_fresh(LoopStateId id) const { return !query_.fresh || query_.fresh(loop_[id], *loop_.turn(id)); }

std::size_t ProgramSystem::clock_of(ComponentId component, const LoopState& state) const {
  const std::vector<ComponentId> live = loop_.live(state.modes);
  const auto at = std::lower_bound(live.begin(), live.end(), component);
  CHECK(at != live.end() && *at == component);
  return 1 + extra() + state.groups.size() + static_cast<std::size_t>(at - live.begin());
}

std::vector<ClockLimits> ProgramSystem::limits_in(const LoopState& state, bool due) const {
  std::vector<ClockLimits> result;
  if (query_.window) {
    const auto& [lower, upper] = *query_.window;
    result.push_back({lower, upper == unbounded ? -1 : upper});
  } else if (stopwatch()) {
    result.push_back({due ? query_.deadline : -1, -1});
  }
  if (progress_clock()) result.push_back({loop_.time().grain(), 0});
  for (const ClockGroup& group : state.groups) {
    ClockLimits limits;
    for (Cell cell = loop_.cell(group);; cell = loop_.cells().around(group.clocks, cell.last + 1)) {
      const Interval readings = loop_.cells().units(cell, loop_.time());
      limits.lower = std::max(limits.lower, readings.lower);
      if (loop_.cells().is_last(cell)) break;
      limits.upper = std::max(limits.upper, readings.upper);
    }
    result.push_back(limits);
  }
  for (const ComponentId component : loop_.live(state.modes)) {
    const std::size_t c = component.index();
    result.push_back(clock_limits(loop_.plant().components[c], state.modes[c], loop_.time()));
  }
  // Of two readings that only one of all limits tells apart either can do what the other can: what cannot go on is not
  // hidden behind what can do more.
  for (std::size_t clock = extra(); clock < result.size(); ++clock) {
    result[clock].lower = result[clock].upper = std::max(result[clock].lower, result[clock].upper);
  }
  return result;
}

}  // namespace rmpl::verifier
