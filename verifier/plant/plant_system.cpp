// A plant beside an observer, as a symbolic transition system.
// SPDX-License-Identifier: MIT
#include "verifier/plant/plant_system.hpp"

#include <algorithm>

#include "base/check.hpp"

#include "verifier/plant/plant_instants.hpp"

namespace rmpl::verifier {

using automata::ComponentId;
using automata::Modes;

namespace {

constexpr std::size_t stopwatch = 1;

}  // namespace

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
    visit(sorted(std::move(entered), nullptr), label);
  });
}

void PlantSystem::successors(const SymbolicState& state, const Visit& visit) {
  enumerate_successors(state, [&](Entered&& entered) {
    const Label label = entered.label;
    visit(sorted(std::move(entered), nullptr), label);
  });
}

SymbolicState PlantSystem::sorted(Entered&& entered, Permutation* applied) {
  if (symmetry_.trivial()) {
    return {discrete_of(entered.id, entered.phase), entered.faults, std::move(entered.zone)};
  }
  Modes modes = entered.situation->modes;
  std::vector<ComponentId> live = entered.situation->live;
  const std::size_t others = observer_.timed(entered.phase) ? 1 : 0;
  Permutation permutation = symmetry_.sort(modes, live, others, entered.zone, applied != nullptr);
  if (applied != nullptr) *applied = std::move(permutation);
  return {discrete_of(situations_.number(modes), entered.phase), entered.faults, std::move(entered.zone)};
}

void PlantSystem::enumerate_initial(const VisitEntered& visit) {
  for (std::size_t s = 0; s < start_.size(); ++s) {
    const Phase phase = observer_.start(start_[s]);
    const SituationId id = situations_.number(start_[s]);
    auto situation = situations_[id];
    const Zone zone(situation->live.size() + (observer_.timed(phase) ? 1 : 0));
    enter(id, std::move(situation), phase, 0, zone, {static_cast<std::uint32_t>(s), no_wait, false}, visit);
  }
}

void PlantSystem::enumerate_successors(const SymbolicState& state, const VisitEntered& visit) {
  const SituationId id = situation_of(state.discrete);
  const Phase phase = phase_of(state.discrete);
  if (is_end(phase)) return;
  const auto here = situations_[id];
  const Place place{*here, observer_.timed(phase)};
  const auto moves = situations_.moves(id, late(*here, place, state.zone));
  std::vector<std::size_t> sources;
  for (std::size_t m = 0; m < moves->size(); ++m) {
    const JointStep& move = (*moves)[m];
    if (fault_count(state.faults) + move.faults > situations_.faults()) continue;
    Zone zone = state.zone;
    if (move.hold) {
      if (!wait(zone, move.bounds, place)) continue;
    } else {
      if (!situations_.time().is_dense()) zone.tick();
      if (!within(zone, move.bounds, place)) continue;
    }
    const auto target = situations_[move.target];
    const unsigned faults =
        sets_ == nullptr ? state.faults + move.faults
                         : sets_->after(state.faults, situations_.plant(), here->modes, target->modes, move.faults);
    const auto step_into = [&](Phase next, const Zone& from) {
      sources.clear();
      if (observer_.timed(next)) sources.push_back(observer_.timed(phase) ? stopwatch : 0);
      for (const ComponentId component : target->live) {
        const bool kept = here->modes[component.index()] == target->modes[component.index()];
        sources.push_back(kept ? place.clock_of(component) : 0);
      }
      enter(move.target, target, next, faults, from.select(sources),
            {static_cast<std::uint32_t>(m), no_wait, move.hold}, visit);
    };
    const Phase next = this->next(phase, move.target, *target);
    if (observer_.answers(phase, next)) {
      // The period that brings the response may be the first one to end after the deadline: that is too late.
      Zone late = zone;
      if (late.constrain(stopwatch, *observer_.accepted())) step_into(Phase::armed, late);
    }
    step_into(next, zone);
  }
  enter_end(here, id, phase, state, *moves, visit);
}

Phase PlantSystem::next(Phase phase, SituationId id, const Situation& situation) {
  const std::size_t at = 2 * std::size_t{id.value} + (observer_.owes(phase) ? 1 : 0);
  if (at >= next_.size()) next_.resize(2 * (at + 1));
  if (!next_[at]) next_[at] = observer_.next(phase, situation.modes);
  return *next_[at];
}

/// What a run is cut off in, if there is such a thing.
void PlantSystem::enter_end(const std::shared_ptr<const Situation>& here, SituationId id, Phase phase,
                            const SymbolicState& state, const std::vector<JointStep>& moves,
                            const VisitEntered& visit) {
  if (plainly_goes_on({*here, observer_.timed(phase)}, state.zone, moves)) return;
  const std::size_t others = observer_.timed(phase) ? 1 : 0;
  PlantInstants instants(situations_, id, *here, others, state.zone);
  const auto found = find_standstill(state.zone, id.value, instants);
  if (!found) return;
  const auto end_in = [&](Phase end, const Zone& zone) {
    std::vector<std::size_t> sources;
    for (std::size_t clock = 1 + (observer_.timed(end) ? 0 : others); clock <= zone.clocks(); ++clock) {
      sources.push_back(clock);
    }
    visit({id, here, end, state.faults, zone.select(sources), {no_move, no_wait, false}});
  };
  const bool owed = observer_.owes(phase);
  if (!found->round.empty()) {
    return end_in(owed && !answered_in(*found, phase) ? Phase::still_armed : Phase::still, found->zone);
  }
  if (Zone late = state.zone; owed && late.constrain(stopwatch, observer_.last_chance(situations_.time().grain()))) {
    PlantInstants those(situations_, id, *here, others, late);
    const auto too_late = find_standstill(late, id.value, those);
    if (too_late && too_late->round.empty()) return end_in(Phase::stuck_late, too_late->zone);
  }
  end_in(Phase::stuck, found->zone);
}

/// Whether, in dense time, at each reading time passes or a component whose exit is due can take it: what mostly is so,
/// seen without following any step. Its clock starts anew then, so that steps cannot go round with no time between.
bool PlantSystem::plainly_goes_on(const Place& place, const Zone& zone, const std::vector<JointStep>& moves) const {
  if (!situations_.time().is_dense()) return false;
  const auto reads = [&](const ClockBound& bound) {
    const std::size_t clock = place.clock_of(bound.component);
    return Interval{zone.lower(clock), zone.upper(clock)};
  };
  const auto left_at = [&](const ClockBound& due) {
    return std::any_of(moves.begin(), moves.end(), [&](const JointStep& move) {
      const std::size_t c = due.component.index();
      return move.faults == 0 &&
             std::all_of(move.bounds.begin(), move.bounds.end(),
                         [&](const ClockBound& bound) {
                           if (bound.component == due.component) return bound.clock.contains(due.clock.upper);
                           const Interval range = reads(bound);
                           return bound.clock.contains(range.lower) && bound.clock.contains(range.upper);
                         }) &&
             situations_[move.target]->modes[c] != place.situation.modes[c];
    });
  };
  return std::any_of(place.situation.waits.begin(), place.situation.waits.end(), [&](const Box& box) {
    return std::all_of(box.begin(), box.end(), [&](const ClockBound& bound) {
      const Interval range = reads(bound);
      if (range.lower < bound.clock.lower || range.upper > bound.clock.upper) return false;
      return range.upper < bound.clock.upper || bound.clock.upper == unbounded ||
             (bound.clock.upper > 0 && left_at(bound));
    });
  });
}

bool PlantSystem::answered_in(const Standstill& found, Phase phase) {
  return std::any_of(found.round.begin(), found.round.end(), [&](const Instant& step) {
    return !observer_.owes(observer_.next(phase, situations_.modes(SituationId(step.target))));
  });
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
  return late(*here, {*here, observer_.timed(phase_of(state.discrete))}, state.zone);
}

void PlantSystem::enter(SituationId id, std::shared_ptr<const Situation> situation, Phase phase, unsigned faults,
                        Zone now, Label label, const VisitEntered& visit) const {
  if (!in_time(now, phase, *situation)) return;
  const Place place{*situation, observer_.timed(phase)};
  bool whole = false;
  for (std::size_t w = 0; w < situation->waits.size(); ++w) {
    Zone later = now;
    if (!wait(later, situation->waits[w], place) || !in_time(later, phase, *situation)) continue;
    whole = whole || later.includes(now);
    label.wait = static_cast<std::uint32_t>(w);
    visit({id, situation, phase, faults, std::move(later), label});
  }
  if (whole) return;
  label.wait = no_wait;
  visit({id, std::move(situation), phase, faults, std::move(now), label});
}

bool PlantSystem::accepts(const SymbolicState& state) const {
  const Phase phase = phase_of(state.discrete);
  cut_off_.stuck = cut_off_.stuck || phase == Phase::stuck;
  cut_off_.still = cut_off_.still || phase == Phase::still || phase == Phase::still_armed;
  cut_off_.spent = cut_off_.spent || (!is_end(phase) && is_spent(state));
  if (phase == Phase::still_armed || phase == Phase::stuck_late) return true;
  if (is_end(phase) && observer_.seeks_end()) return true;
  if (phase != Phase::armed) return false;
  if (!observer_.timed(phase)) return true;
  const Interval& accepted = *observer_.accepted();
  return state.zone.upper(stopwatch) >= accepted.lower && state.zone.lower(stopwatch) <= accepted.upper;
}

/// Whether at some reading more faults are certain, with idle controls, than there may still be.
bool PlantSystem::is_spent(const SymbolicState& state) const {
  const auto here = situations_[situation_of(state.discrete)];
  const std::size_t others = observer_.timed(phase_of(state.discrete)) ? 1 : 0;
  return more_certain(state.zone, here->faulty, situations_.faults() - fault_count(state.faults), here->live, others,
                      situations_.time());
}

unsigned PlantSystem::fault_count(unsigned faults) const { return sets_ == nullptr ? faults : (*sets_)[faults].count; }

bool PlantSystem::no_more_faults(unsigned a, unsigned b) const {
  return fault_count(a) <= fault_count(b) && (sets_ == nullptr || subset((*sets_)[a], (*sets_)[b]));
}

bool PlantSystem::within(Zone& zone, const Box& box, const Place& place) {
  return std::all_of(box.begin(), box.end(), [&](const ClockBound& bound) {
    return zone.constrain(place.clock_of(bound.component), bound.clock);
  });
}

bool PlantSystem::wait(Zone& zone, const Box& box, const Place& place) {
  const auto clock = [&](const ClockBound& bound) { return place.clock_of(bound.component); };
  const auto may_begin = [&](const ClockBound& b) { return zone.constrain(clock(b), b.clock); };
  const auto ends = [&](const ClockBound& b) { return zone.constrain(clock(b), {0, b.clock.upper}); };
  if (!std::all_of(box.begin(), box.end(), may_begin)) return false;
  zone.elapse();
  return std::all_of(box.begin(), box.end(), ends);
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
  if (observer_.timed(phase_of(discrete))) {
    const Interval& accepted = *observer_.accepted();
    result.push_back({accepted.lower, accepted.upper == unbounded ? -1 : accepted.upper});
  }
  const auto situation = situations_[situation_of(discrete)];
  result.insert(result.end(), situation->limits.begin(), situation->limits.end());
  if (!observer_.tells_ends_apart()) return;
  // What cannot go on is not to be covered by what can do more: readings are told apart by all limits alike.
  const std::size_t first = observer_.timed(phase_of(discrete)) ? 1 : 0;
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
