// Where runs of a plant are cut off.
// SPDX-License-Identifier: MIT
#include <algorithm>

#include "verifier/behaviour/folds.hpp"
#include "verifier/plant/plant_instants.hpp"
#include "verifier/plant/plant_system.hpp"

namespace rmpl::verifier {

using automata::ComponentId;
using automata::Modes;

/// What a run is cut off in, if there is such a thing.
void PlantSystem::enter_end(const std::shared_ptr<const Situation>& here, SituationId id, Phase phase,
                            const SymbolicState& state, const std::vector<JointStep>& moves,
                            const VisitEntered& visit) {
  if (plainly_goes_on({*here, has_extra(phase)}, state.zone, moves)) return;
  enter_end(id, phase, state.faults, state.zone, visit);
}

bool PlantSystem::enter_end(SituationId id, Phase phase, unsigned faults, const Zone& zone, const VisitEntered& visit) {
  const auto here = situations_[id];
  const std::size_t others = has_extra(phase) ? 1 : 0;
  const Place place{*here, has_extra(phase)};
  if (const auto bound = worth_a_cut(place, zone)) {
    const auto ends_in = [&](const Interval& part) {
      Zone where = zone;
      return where.constrain(place.clock_of(bound->component), part) && enter_end(id, phase, faults, where, visit);
    };
    const bool before = ends_in({0, bound->clock.upper - 1});
    // Where a response is owed, it matters in which part it comes too late.
    if (before && !observer_.owes(phase)) return true;
    return ends_in({bound->clock.upper, unbounded}) || before;
  }
  bool ended = false;  // in a part
  const auto look = [&](const Zone& where, std::optional<Standstill>& found) {
    PlantInstants instants(situations_, id, *here, others, where, folds_, goes_on_ == GoesOn::idle);
    found = find_standstill(where, id.value, instants);
    if (!instants.asked()) return true;
    // Steps of the instant lead to where it matters whether a mode has ended: each part is looked at by itself.
    folds_->cut(here->modes, others, where, *instants.asked(), [&](const Modes& modes, Zone&& part) {
      ended = enter_end(situations_.number(modes), phase, faults, part, visit) || ended;
    });
    return false;
  };
  std::optional<Standstill> found;
  if (!look(zone, found) || !found) return ended;
  const auto end_in = [&](Phase end, const Zone& where) {
    std::vector<std::size_t> sources;
    for (std::size_t clock = 1 + (has_extra(end) ? 0 : others); clock <= where.clocks(); ++clock) {
      sources.push_back(clock);
    }
    visit({id, here, end, faults, where.select(sources), {no_move, no_wait, false}});
    return true;
  };
  const bool owed = observer_.owes(phase);
  if (!found->round.empty()) {
    return end_in(owed && !answered_in(*found, phase) ? Phase::still_armed : Phase::still, found->zone);
  }
  if (owed && observer_.some_day()) return end_in(Phase::stuck_late, found->zone);
  if (Zone late = zone; owed && late.constrain(stopwatch, observer_.last_chance(situations_.time().grain()))) {
    std::optional<Standstill> too_late;
    if (!look(late, too_late)) return ended;
    if (too_late && too_late->round.empty()) return end_in(Phase::stuck_late, too_late->zone);
  }
  return end_in(Phase::stuck, found->zone);
}

/// Where many components may be at their bounds or not, the first one to tell apart: mostly few are at one instant, but
/// steps are told for each set of them that may be.
std::optional<ClockBound> PlantSystem::worth_a_cut(const Place& place, const Zone& zone) {
  constexpr std::size_t many = 7;
  std::optional<ClockBound> result;
  std::size_t count = 0;
  const auto& live = place.situation.live;
  for (std::size_t i = 0; i < live.size(); ++i) {
    const Units bound = place.situation.stays_until[i];
    const std::size_t clock = place.clock_of(live[i]);
    if (bound <= 0 || bound == unbounded || zone.upper(clock) < bound || zone.lower(clock) >= bound) continue;
    ++count;
    if (!result) result = ClockBound{live[i], {0, bound}};
  }
  return count >= many ? result : std::nullopt;
}

/// Whether, in dense time, at each reading time passes or a component whose exit is due can take it: what mostly is so,
/// seen without following any step. Its clock starts anew then, so that steps cannot go round with no time between.
bool PlantSystem::plainly_goes_on(const Place& place, const Zone& zone, const std::vector<JointStep>& moves) const {
  if (!situations_.time().is_dense()) return false;
  const auto reads_in = [&](const Zone& some, const ClockBound& bound) {
    const std::size_t clock = place.clock_of(bound.component);
    return Interval{some.lower(clock), some.upper(clock)};
  };
  const auto reads = [&](const ClockBound& bound) { return reads_in(zone, bound); };
  const auto left_at = [&](const ClockBound& due) {
    Zone then = zone;
    if (!then.constrain(place.clock_of(due.component), {due.clock.upper, due.clock.upper})) return true;
    // Steps are told without those that only stay: what is due as well has to move, too.
    const Late all_due = due_in(place.situation, place, then);
    const auto own = std::find(all_due.begin(), all_due.end(), due.component);
    if (own != all_due.end() && late(place.situation, place, then).empty() &&
        situations_.leave_together(place.situation.modes, all_due, static_cast<std::size_t>(own - all_due.begin()))) {
      return true;
    }
    return std::any_of(moves.begin(), moves.end(), [&](const JointStep& move) {
      const std::size_t c = due.component.index();
      return move.faults == 0 && (goes_on_ == GoesOn::somehow || situations_.is_idle(move)) &&
             std::all_of(move.bounds.begin(), move.bounds.end(),
                         [&](const ClockBound& bound) {
                           const Interval range = reads_in(then, bound);
                           const Interval left = lasting(bound.clock, bound.sharp);
                           return left.contains(range.lower) && left.contains(range.upper);
                         }) &&
             situations_[move.target]->modes[c] != place.situation.modes[c] &&
             std::all_of(all_due.begin(), all_due.end(), [&](ComponentId other) {
               const std::size_t o = other.index();
               return situations_[move.target]->modes[o] != place.situation.modes[o];
             });
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

bool PlantSystem::answered_in(const Standstill& found, Phase phase) const {
  return std::any_of(found.round.begin(), found.round.end(), [&](const Instant& step) {
    return !observer_.owes(observer_.next(phase, situations_.modes(SituationId(step.target))));
  });
}

Late PlantSystem::due_in(const Situation& situation, const Place& place, const Zone& zone) {
  Late result;
  for (std::size_t i = 0; i < situation.live.size(); ++i) {
    const Units bound = situation.stays_until[i];
    if (bound != unbounded && zone.upper(place.clock_of(situation.live[i])) >= bound) {
      result.push_back(situation.live[i]);
    }
  }
  return result;
}

}  // namespace rmpl::verifier
