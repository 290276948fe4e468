// Itineraries: a symbolic path told in the names of the plant.
// SPDX-License-Identifier: MIT
#include "verifier/plant/itinerary.hpp"

#include <algorithm>

#include "base/check.hpp"

namespace rmpl::verifier {

using automata::ComponentId;
using automata::Modes;

namespace {

ComponentId renamed_component(ComponentId component, const Permutation& permutation) {
  const auto at = std::find_if(permutation.begin(), permutation.end(),
                               [&](const Renaming& r) { return r.component == component.value; });
  return at != permutation.end() ? ComponentId(at->to) : component;
}

Box renamed_box(const Box& box, const Permutation& permutation) {
  Box result = box;
  for (ClockBound& bound : result) bound.component = renamed_component(bound.component, permutation);
  std::sort(result.begin(), result.end());
  return result;
}

std::vector<ComponentId> renamed(std::vector<ComponentId> components, const Permutation& permutation) {
  for (ComponentId& component : components) component = renamed_component(component, permutation);
  std::sort(components.begin(), components.end());
  return components;
}

/// The move from these modes that leads to the target in the same way.
JointStep counterpart(const JointStep& move, const Permutation& names, const Modes& from, const Late& late,
                      unsigned faults, Situations& situations) {
  const SituationId target = situations.number(renamed(situations.modes(move.target), names));
  const Box bounds = renamed_box(move.bounds, names);
  const std::vector<ComponentId> restarted = renamed(move.restarted, names);
  const auto moves = situations.moves(situations.number(from), renamed(late, names), faults);
  const auto found = std::find_if(moves->begin(), moves->end(), [&](const JointStep& m) {
    return m.target == target && m.faults == move.faults && m.hold == move.hold && m.bounds == bounds &&
           m.restarted == restarted && m.exits == move.exits;
  });
  CHECK(found != moves->end() && "what a permutation keeps is a move on both sides");
  return *found;
}

/// What each live clock reads.
Box ranges(const PlantSystem::Entered& entered, const PlantSystem& system) {
  Box result;
  std::size_t clock = system.has_extra(entered.phase) ? 1 : 0;
  for (const ComponentId component : entered.situation->live) {
    ++clock;
    result.push_back({component, {entered.zone.lower(clock), entered.zone.upper(clock)}});
  }
  return result;
}

}  // namespace

std::vector<Leg> itinerary(const std::vector<PathState>& path, PlantSystem& system) {
  std::vector<Leg> legs;
  Permutation names;  // from what was explored to the plant
  std::optional<SymbolicState> state;
  for (const PathState& next : path) {
    std::optional<PlantSystem::Entered> entered;
    const auto keep = [&](PlantSystem::Entered&& candidate) {
      const bool same = candidate.label.move == next.label.move && candidate.label.wait == next.label.wait &&
                        candidate.phase == PlantSystem::phase_of(next.discrete) &&
                        candidate.progressed == PlantSystem::progressed(next.discrete);
      if (same) entered = std::move(candidate);
    };
    if (state) {
      system.enumerate_successors(*state, next.label.move, keep);
    } else {
      system.enumerate_initial(keep);
    }
    CHECK(entered && "a path that the search found cannot be followed");

    if (next.label.move == PlantSystem::no_move && is_end(entered->phase)) {
      legs.back().end = renamed_box(ranges(*entered, system), names);
      legs.back().cut_off = entered->phase;
      break;
    }
    Leg leg{renamed(entered->situation->modes, names), entered->phase, std::nullopt, std::nullopt, {}, std::nullopt};
    leg.progressed = entered->progressed;
    if (state) {
      const Late late = system.late(*state);
      const auto moves =
          system.situations().moves(PlantSystem::situation_of(state->discrete), late, system.faults_left(*state));
      leg.move = counterpart((*moves)[next.label.move], names, legs.back().modes, late, system.faults_left(*state),
                             system.situations());
    }
    if (next.label.wait != PlantSystem::no_wait) {
      leg.wait = renamed_box(entered->situation->waits[next.label.wait], names);
      leg.restarted = renamed(entered->situation->restarted, names);
    }
    legs.push_back(std::move(leg));

    Permutation applied;
    state = system.sorted(std::move(*entered), &applied);
    names = composed(inverse(applied), names);
    CHECK(state->discrete == next.discrete && "a path that the search found leads elsewhere");
  }
  return legs;
}

}  // namespace rmpl::verifier
