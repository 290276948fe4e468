// A plant beside an observer, as a symbolic transition system.
// SPDX-License-Identifier: MIT
#include "verifier/explore/plant_system.hpp"

#include <algorithm>
#include <cassert>

namespace verifier {

using automata::ComponentId;

namespace {

constexpr std::size_t stopwatch = 1;

}  // namespace

PlantSystem::PlantSystem(Situations& situations, Observer& observer, const std::vector<SituationId>& start)
    : situations_(situations), observer_(observer), start_(start) {}

void PlantSystem::initial(const Visit& visit) {
  for (const SituationId id : start_) {
    const Phase phase = observer_.start(id, situations_[id]);
    if (phase != Phase::closed) enter(id, phase, 0, Zone(limits(id, phase).size()), {}, visit);
  }
}

void PlantSystem::successors(const SymbolicState& state, const Visit& visit) {
  const SituationId id = situation_of(state.discrete);
  const Phase phase = phase_of(state.discrete);
  const std::vector<Move>& moves = situations_.moves(id);
  for (std::size_t m = 0; m < moves.size(); ++m) {
    const Move& move = moves[m];
    const unsigned faults = state.faults + move.faults;
    if (faults > situations_.faults()) continue;
    Zone zone = state.zone;
    if (move.hold) {
      if (!wait(zone, move.bounds, id, phase)) continue;
    } else {
      if (!situations_.reading().is_dense()) zone.tick();
      if (!within(zone, move.bounds, id, phase)) continue;
    }
    const Situation& target = situations_[move.target];
    Phase next = observer_.next(phase, move.target, target);
    if (next == Phase::closed) {
      // The period that brings the response may be the first one to end after the deadline: that is too late.
      if (phase != Phase::armed || !observer_.timed(phase) || !zone.constrain(stopwatch, *observer_.accepted()))
        continue;
      next = Phase::armed;
    }
    std::vector<std::size_t> sources;
    if (observer_.timed(next)) sources.push_back(observer_.timed(phase) ? stopwatch : 0);
    for (const ComponentId component : target.live) {
      const bool kept = situations_[id].modes[component.index()] == target.modes[component.index()];
      sources.push_back(kept ? clock_of(component, id, phase) : 0);
    }
    enter(move.target, next, faults, zone.select(sources), {static_cast<std::uint32_t>(m), no_wait, move.hold}, visit);
  }
}

void PlantSystem::enter(SituationId id, Phase phase, unsigned faults, const Zone& zone, Label label,
                        const Visit& visit) const {
  const std::vector<ClockLimits> clocks = limits(id, phase);
  const std::uint64_t discrete = (std::uint64_t{id.value} << phase_bits) | static_cast<std::uint64_t>(phase);
  bool whole = false;
  const auto& waits = situations_[id].waits;
  for (std::size_t w = 0; w < waits.size(); ++w) {
    Zone later = zone;
    if (!wait(later, waits[w], id, phase) || !in_time(later, phase)) continue;
    whole = whole || later.includes(zone);
    later.extrapolate(clocks);
    label.wait = static_cast<std::uint32_t>(w);
    visit({discrete, faults, std::move(later)}, label);
  }
  Zone now = zone;
  if (whole || !in_time(now, phase)) return;
  now.extrapolate(clocks);
  label.wait = no_wait;
  visit({discrete, faults, std::move(now)}, label);
}

bool PlantSystem::accepts(const SymbolicState& state) const {
  const Phase phase = phase_of(state.discrete);
  if (phase != Phase::armed) return false;
  if (!observer_.timed(phase)) return true;
  const Interval& accepted = *observer_.accepted();
  return state.zone.upper(stopwatch) >= accepted.lower && state.zone.lower(stopwatch) <= accepted.upper;
}

bool PlantSystem::within(Zone& zone, const Box& box, SituationId id, Phase phase) const {
  return std::all_of(box.begin(), box.end(), [&](const ClockBound& bound) {
    return zone.constrain(clock_of(bound.component, id, phase), bound.clock);
  });
}

bool PlantSystem::wait(Zone& zone, const Box& box, SituationId id, Phase phase) const {
  const auto clock = [&](const ClockBound& bound) { return clock_of(bound.component, id, phase); };
  const auto may_begin = [&](const ClockBound& b) { return zone.constrain(clock(b), b.clock); };
  const auto ends = [&](const ClockBound& b) { return zone.constrain(clock(b), {0, b.clock.upper}); };
  if (!std::all_of(box.begin(), box.end(), may_begin)) return false;
  zone.elapse();
  return std::all_of(box.begin(), box.end(), ends);
}

bool PlantSystem::in_time(Zone& zone, Phase phase) const {
  return !observer_.timed(phase) || zone.constrain(stopwatch, {0, observer_.accepted()->upper});
}

std::vector<ClockLimits> PlantSystem::limits(SituationId id, Phase phase) const {
  std::vector<ClockLimits> result = situations_[id].limits;
  if (observer_.timed(phase)) {
    const Interval& accepted = *observer_.accepted();
    result.insert(result.begin(), {accepted.lower, accepted.upper == unbounded ? -1 : accepted.upper});
  }
  return result;
}

std::size_t PlantSystem::clock_of(ComponentId component, SituationId id, Phase phase) const {
  const auto& live = situations_[id].live;
  const auto at = std::lower_bound(live.begin(), live.end(), component);
  assert(at != live.end() && *at == component);
  return 1 + static_cast<std::size_t>(at - live.begin()) + (observer_.timed(phase) ? 1 : 0);
}

}  // namespace verifier
