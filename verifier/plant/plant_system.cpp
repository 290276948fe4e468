// A plant beside an observer, as a symbolic transition system.
// SPDX-License-Identifier: MIT
#include "verifier/plant/plant_system.hpp"

#include <algorithm>
#include <numeric>

#include "base/check.hpp"

#include "verifier/behaviour/folds.hpp"
#include "verifier/plant/instant_clocks.hpp"

namespace rmpl::verifier {

using automata::ComponentId;
using automata::Modes;

PlantSystem::PlantSystem(Situations& situations, Observer observer, const Symmetry& symmetry,
                         const std::vector<Modes>& start)
    : situations_(situations),
      observer_(std::move(observer)),
      symmetry_(symmetry),
      start_(start),
      ranks_(situations.plant(), start.empty() ? Modes{} : start.front()) {}

void PlantSystem::initial(const Visit& visit) {
  enumerate_initial([&](Entered&& entered) {
    const Label label = entered.label;
    SymbolicState next = sorted(std::move(entered), nullptr);
    if (progress_) abstract(next);
    visit(std::move(next), label);
  });
}

void PlantSystem::successors(const SymbolicState& state, const Visit& visit) {
  enumerate_successors(state, [&](Entered&& entered) {
    const Label label = entered.label;
    SymbolicState next = sorted(std::move(entered), nullptr);
    if (progress_) abstract(next);
    visit(std::move(next), label);
  });
}

SymbolicState PlantSystem::sorted(Entered&& entered, Permutation* applied) {
  if (symmetry_.trivial()) {
    return {discrete_of(entered.id, entered.phase, entered.progressed), entered.faults, std::move(entered.zone)};
  }
  Modes modes = entered.situation->modes;
  std::vector<ComponentId> live = entered.situation->live;
  const std::size_t others = has_extra(entered.phase) ? 1 : 0;
  Permutation permutation = symmetry_.sort(modes, live, others, entered.zone, applied != nullptr);
  if (applied != nullptr) *applied = std::move(permutation);
  return {discrete_of(situations_.number(modes), entered.phase, entered.progressed), entered.faults,
          std::move(entered.zone)};
}

void PlantSystem::enumerate_initial(const VisitEntered& visit) {
  for (std::size_t s = 0; s < start_.size(); ++s) {
    const Phase phase = observer_.start(start_[s]);
    const SituationId id = situations_.number(start_[s]);
    auto situation = situations_[id];
    const Zone zone(situation->live.size() + (has_extra(phase) ? 1 : 0));
    enter(id, std::move(situation), phase, 0, zone, {static_cast<std::uint32_t>(s), no_wait, false}, visit);
  }
}

void PlantSystem::enumerate_successors(const SymbolicState& state, const VisitEntered& visit) {
  const SituationId id = situation_of(state.discrete);
  const Phase phase = phase_of(state.discrete);
  if (is_end(phase)) return;
  const auto here = situations_[id];
  const auto moves = situations_.moves(id, late(*here, {*here, has_extra(phase)}, state.zone), faults_left(state));
  for (std::uint32_t m = 0; m < moves->size(); ++m) take(state, here, m, (*moves)[m], visit);
  enter_end(here, id, phase, state, *moves, visit);
}

void PlantSystem::enumerate_successors(const SymbolicState& state, std::uint32_t move, const VisitEntered& visit) {
  const SituationId id = situation_of(state.discrete);
  const Phase phase = phase_of(state.discrete);
  if (is_end(phase)) return;
  const auto here = situations_[id];
  const auto moves = situations_.moves(id, late(*here, {*here, has_extra(phase)}, state.zone), faults_left(state));
  if (move == no_move) return enter_end(here, id, phase, state, *moves, visit);
  take(state, here, move, (*moves)[move], visit);
}

/// Where the clocks may be as the move ends.
bool PlantSystem::pass(Zone& zone, const JointStep& move, const Place& place) const {
  if (move.hold) {
    if (!progress_ || !move.restarted.empty()) return wait(zone, move.bounds, move.restarted, place);
    // One period at least: a run without end takes time in it.
    if (!within(zone, move.bounds, place)) return false;
    zone.tick();
    return wait(zone, move.bounds, {}, place);
  }
  if (!situations_.time().is_dense()) zone.tick();
  return within(zone, move.bounds, place);
}

/// Whether a step, in dense time, is possible at no reading: seen from each bound alone, before anything is copied.
bool PlantSystem::misses(const Zone& zone, const JointStep& move, const Place& place) const {
  if (!situations_.time().is_dense()) return false;
  return std::any_of(move.bounds.begin(), move.bounds.end(), [&](const ClockBound& bound) {
    return !zone.meets(place.clock_of(bound.component), bound.clock);
  });
}

void PlantSystem::take(const SymbolicState& state, const std::shared_ptr<const Situation>& here, std::uint32_t number,
                       const JointStep& move, const VisitEntered& visit) {
  const Phase phase = phase_of(state.discrete);
  const Place place{*here, has_extra(phase)};
  if (misses(state.zone, move, place)) return;
  const auto target = situations_[move.target];
  const unsigned faults =
      sets_ == nullptr ? state.faults + move.faults
                       : sets_->after(state.faults, situations_.plant(), here->modes, target->modes, move.faults);
  const auto step_into = [&](Phase next, const Zone& from, bool progressed) {
    std::vector<std::size_t>& sources = sources_;
    sources.clear();
    if (has_extra(next)) sources.push_back(!progress_ && observer_.timed(phase) ? stopwatch : 0);
    for (const ComponentId component : target->live) {
      const bool kept = here->modes[component.index()] == target->modes[component.index()] &&
                        !std::binary_search(move.restarted.begin(), move.restarted.end(), component);
      sources.push_back(kept ? place.clock_of(component) : 0);
    }
    const Label label{number, no_wait, move.hold || target->modes == here->modes};
    if (progress_) return enter(move.target, target, next, faults, from.select(sources), label, visit, progressed);
    enter_unfolded(*here, move.target, target, next, faults, from.select(sources), label, visit);
  };
  const Phase next = this->next(phase, move.target, *target);
  if (progress_) {
    for (const bool progressed : {false, true}) {
      Zone zone = state.zone;
      const Interval waited = progressed ? Interval{situations_.time().grain(), unbounded} : Interval{0, 0};
      if (zone.constrain(stopwatch, waited) && pass(zone, move, place)) step_into(next, zone, progressed);
    }
    return;
  }
  Zone zone = state.zone;
  if (!pass(zone, move, place)) return;
  if (observer_.answers(phase, next) && observer_.accepted()) {
    // The period that brings the response may be the first one to end after the deadline: that is too late.
    Zone late = zone;
    if (late.constrain(stopwatch, *observer_.accepted())) step_into(Phase::armed, late, false);
  }
  step_into(next, zone, false);
}

Phase PlantSystem::next(Phase phase, SituationId id, const Situation& situation) {
  const std::size_t at = 2 * std::size_t{id.value} + (observer_.owes(phase) ? 1 : 0);
  if (at >= next_.size()) next_.resize(2 * (at + 1));
  if (!next_[at]) next_[at] = observer_.next(phase, situation.modes);
  return *next_[at];
}

Late PlantSystem::late(const Situation& situation, const Place& place, const Zone& zone) const {
  Late result;
  if (!situations_.time().is_dense()) return result;
  for (std::size_t i = 0; i < situation.live.size(); ++i) {
    const Units bound = situation.stays_until[i];
    if (bound >= 0 && zone.upper(place.clock_of(situation.live[i])) > bound) result.push_back(situation.live[i]);
  }
  return result;
}

Late PlantSystem::late(const SymbolicState& state) {
  const auto here = situations_[situation_of(state.discrete)];
  return late(*here, {*here, has_extra(phase_of(state.discrete))}, state.zone);
}

void PlantSystem::enter_unfolded(const Situation& from, SituationId id, std::shared_ptr<const Situation> situation,
                                 Phase phase, unsigned faults, Zone zone, Label label,
                                 const VisitEntered& visit) const {
  const std::vector<ComponentId>* open = folds_ == nullptr ? nullptr : &folds_->in(from.modes);
  if (open == nullptr || open->empty()) {
    return enter(id, std::move(situation), phase, faults, std::move(zone), label, visit);
  }
  folds_->unfold(situation->modes, has_extra(phase) ? 1 : 0, zone, *open, [&](const Modes& modes, Zone&& part) {
    const SituationId in = situations_.number(modes);
    enter(in, situations_[in], phase, faults, std::move(part), label, visit);
  });
}

void PlantSystem::enter(SituationId id, std::shared_ptr<const Situation> situation, Phase phase, unsigned faults,
                        Zone now, Label label, const VisitEntered& visit, bool progressed) const {
  if (!in_time(now, phase, *situation)) return;
  const Place place{*situation, has_extra(phase)};
  // A wait in which clocks restart takes a unit at least: it holds nothing of what is there at once, which goes first,
  // so that witnesses lose no time.
  bool whole = !situation->restarted.empty();
  if (whole) visit({id, situation, phase, faults, now, label, progressed});
  for (std::size_t w = 0; w < situation->waits.size(); ++w) {
    Zone later = now;
    if (!wait(later, situation->waits[w], situation->restarted, place) || !in_time(later, phase, *situation)) continue;
    whole = whole || later.includes(now);
    label.wait = static_cast<std::uint32_t>(w);
    visit({id, situation, phase, faults, std::move(later), label, progressed});
  }
  if (whole) return;
  label.wait = no_wait;
  visit({id, std::move(situation), phase, faults, std::move(now), label, progressed});
}

bool PlantSystem::accepts(const SymbolicState& state) const {
  const Phase phase = phase_of(state.discrete);
  cut_off_.stuck = cut_off_.stuck || phase == Phase::stuck;
  cut_off_.still = cut_off_.still || phase == Phase::still || phase == Phase::still_armed;
  cut_off_.spent = cut_off_.spent || (!is_end(phase) && is_spent(state));
  if (phase == Phase::still_armed || phase == Phase::stuck_late) return true;
  if (is_end(phase) && observer_.seeks_end()) return true;
  if (phase != Phase::armed) return false;
  if (observer_.some_day()) return may_wait_for_ever(state);
  if (!observer_.timed(phase)) return true;
  return state.zone.meets(stopwatch, *observer_.accepted());
}

/// Whether at some reading more faults are certain, with idle controls, than there may still be.
bool PlantSystem::is_spent(const SymbolicState& state) const {
  const auto here = situations_[situation_of(state.discrete)];
  const std::size_t others = has_extra(phase_of(state.discrete)) ? 1 : 0;
  return more_certain(state.zone, here->faulty, faults_left(state), here->live, others, situations_.time());
}

unsigned PlantSystem::faults_left(const SymbolicState& state) const {
  return situations_.faults() - fault_count(state.faults);
}

/// Whether time may pass without end from each reading, with all controls idle and no exit that chance would take.
bool PlantSystem::may_wait_for_ever(const SymbolicState& state) const {
  const SituationId id = situation_of(state.discrete);
  const auto here = situations_[id];
  const Place place{*here, has_extra(phase_of(state.discrete))};
  const bool endless = std::any_of(here->waits.begin(), here->waits.end(), [&](const Box& box) {
    return std::all_of(box.begin(), box.end(), [&](const ClockBound& bound) {
      const Units least = state.zone.lower(place.clock_of(bound.component));
      const bool restarts = std::binary_search(here->restarted.begin(), here->restarted.end(), bound.component);
      return (bound.clock.upper == unbounded || (restarts && least <= bound.clock.upper)) && least >= bound.clock.lower;
    });
  });
  if (!endless) return false;
  const Exits& exits = situations_.idle_exits(id);
  return std::all_of(exits.open.begin(), exits.open.end(), [](const auto& open) { return open.empty(); });
}

void PlantSystem::abstract(SymbolicState& state) {
  std::vector<ClockLimits> bounds;
  limits(state.discrete, bounds);
  state.zone.extrapolate(bounds);
}

unsigned PlantSystem::fault_count(unsigned faults) const { return sets_ == nullptr ? faults : (*sets_)[faults].count; }

TransitionSystem::FaultMeasures PlantSystem::fault_measures(unsigned faults) const {
  return sets_ == nullptr ? TransitionSystem::fault_measures(faults) : sets_->measures(faults);
}

bool PlantSystem::no_more_faults(unsigned a, unsigned b) const {
  return fault_count(a) <= fault_count(b) && (sets_ == nullptr || subset((*sets_)[a], (*sets_)[b]));
}

bool PlantSystem::within(Zone& zone, const Box& box, const Place& place) {
  return std::all_of(box.begin(), box.end(), [&](const ClockBound& bound) {
    return zone.constrain(place.clock_of(bound.component), bound.clock);
  });
}

bool PlantSystem::wait(Zone& zone, const Box& box, const std::vector<ComponentId>& restarted, const Place& place) {
  const auto clock = [&](const ClockBound& bound) { return place.clock_of(bound.component); };
  const auto may_begin = [&](const ClockBound& b) { return zone.constrain(clock(b), b.clock); };
  const auto ends = [&](const ClockBound& b) {
    return std::binary_search(restarted.begin(), restarted.end(), b.component) ||
           zone.constrain(clock(b), {0, b.clock.upper});
  };
  if (!std::all_of(box.begin(), box.end(), may_begin)) return false;
  if (!restarted.empty()) zone.tick();
  zone.elapse();
  if (!std::all_of(box.begin(), box.end(), ends)) return false;
  if (restarted.empty()) return true;
  std::vector<std::size_t> sources(zone.clocks());
  std::iota(sources.begin(), sources.end(), std::size_t{1});
  for (const ComponentId component : restarted) sources[place.clock_of(component) - 1] = 0;
  zone = zone.select(sources);
  return true;
}

bool PlantSystem::in_time(Zone& zone, Phase phase, const Situation& situation) const {
  if (!observer_.timed(phase)) return true;
  return zone.constrain(stopwatch, {0, observer_.accepted()->upper}) &&
         (time_left_ == nullptr || time_left_->cut(zone, situation.modes, situation.live));
}

std::uint32_t PlantSystem::rank(std::uint64_t discrete) {
  return ranks_.sum(situations_.modes(situation_of(discrete)));
}

void PlantSystem::limits(std::uint64_t discrete, std::vector<ClockLimits>& result) {
  result.clear();
  if (progress_) result.push_back({situations_.time().grain(), 0});
  if (observer_.timed(phase_of(discrete))) {
    const Interval& accepted = *observer_.accepted();
    result.push_back({accepted.lower, accepted.upper == unbounded ? -1 : accepted.upper});
  }
  const auto situation = situations_[situation_of(discrete)];
  result.insert(result.end(), situation->limits.begin(), situation->limits.end());
  if (!observer_.tells_ends_apart()) return;
  // What cannot go on is not to be covered by what can do more: readings are told apart by all limits alike.
  const std::size_t first = has_extra(phase_of(discrete)) ? 1 : 0;
  for (std::size_t clock = first; clock < result.size(); ++clock) {
    result[clock].lower = result[clock].upper = std::max(result[clock].lower, result[clock].upper);
  }
}

std::size_t PlantSystem::Place::clock_of(ComponentId component) const {
  const auto& live = situation.live;
  const auto at = std::lower_bound(live.begin(), live.end(), component);
  CHECK(at != live.end() && *at == component);
  return 1 + static_cast<std::size_t>(at - live.begin()) + (timed ? 1 : 0);
}

}  // namespace rmpl::verifier
