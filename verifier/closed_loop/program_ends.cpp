// Where runs of the closed loop end: nothing can follow, time stands still, or the budget of faults is spent.
// SPDX-License-Identifier: MIT
#include <memory>

#include "base/check.hpp"
#include "verifier/closed_loop/loop_instants.hpp"
#include "verifier/closed_loop/program_system.hpp"

namespace rmpl::verifier {

using automata::ComponentId;

/// What a run is cut off in, if there is such a thing.
void ProgramSystem::enter_end(const SymbolicState& state, const Visit& visit) {
  auto found = stop_in(state.zone, state.discrete);
  if (!found) return;
  if (Zone late = state.zone; found->round.empty() && is_due(state.discrete)) {
    const bool in_doubt = stopwatch() && late.constrain(1, last_chance());
    auto too_late = in_doubt ? stop_in(late, state.discrete) : std::nullopt;
    if (too_late && too_late->round.empty()) found = std::move(too_late);
  }
  const std::uint64_t end = found->round.empty() ? stuck_bit : still_bit;
  visit({state.discrete | end, state.faults, std::move(found->zone)}, {no_move, no_wait, false});
}

std::optional<Standstill> ProgramSystem::stop_in(const Zone& zone, std::uint64_t discrete) {
  const bool due = is_due(discrete);
  const LoopStateId id = loop_state(discrete);
  const auto comes_true = [this, due](const LoopState& state) { return due && query_.test(state); };
  LoopInstants instants(loop_, id, extra(), comes_true);
  auto found = find_standstill(zone, 0, instants);
  if (!found) return std::nullopt;
  for (Instant& step : found->round) step.target = instants.state_of(step.target).value;
  return found;
}

Standstill ProgramSystem::standstill(const SymbolicState& end) {
  auto found = stop_in(end.zone, end.discrete);
  CHECK(found && "a run that is cut off is so when it is looked at again");
  return *found;
}

PathEnd ProgramSystem::end_of(const SymbolicState& end, std::size_t position) const {
  PathEnd result{position, {}, {}, {}};
  if (stopwatch() && is_last_chance(end)) result.stopwatch = last_chance();
  const LoopState& state = loop_[loop_state(end.discrete)];
  std::size_t clock = extra();
  for (const ClockGroup& group : state.groups) {
    ++clock;
    for (const automata::ClockId own : group.clocks) {
      result.program.push_back({own, {end.zone.lower(clock), end.zone.upper(clock)}});
    }
  }
  for (const ComponentId component : loop_.live(state.modes)) {
    ++clock;
    result.components.push_back({component, {end.zone.lower(clock), end.zone.upper(clock)}});
  }
  return result;
}

PathState ProgramSystem::state_after(const Instant& step) {
  return {step.target << phase_bits, {step.move, no_wait, false}};
}

/// Whether at some reading more faults are certain than there may still be.
bool ProgramSystem::is_spent(const SymbolicState& state) const {
  const LoopStateId id = loop_state(state.discrete);
  if (loop_[id].marking.empty() && !is_due(state.discrete)) return false;
  const auto& filter = query_.filter;
  const unsigned allowed = filter.only && !filter.fault ? 0 : loop_.faults();
  return more_certain(state.zone, loop_.turn(id)->faulty, allowed - fault_count(state.faults),
                      loop_.live(loop_[id].modes), extra() + loop_[id].groups.size(), loop_.time());
}

}  // namespace rmpl::verifier
