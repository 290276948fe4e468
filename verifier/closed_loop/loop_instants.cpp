// What may happen at an instant in the closed loop.
// SPDX-License-Identifier: MIT
#include "verifier/closed_loop/loop_instants.hpp"

#include <algorithm>

namespace rmpl::verifier {

LoopInstants::LoopInstants(Loop& loop, LoopStateId root, std::size_t others,
                           base::FunctionRef<bool(const automata::Modes&)> ends)
    : loop_(loop),
      root_(root),
      others_(others),
      ends_(ends),
      clocks_(loop.live(loop[root].modes), others + loop[root].groups.size()) {
  const auto& locations = loop.program().locations;
  own_clocks_ = std::any_of(locations.begin(), locations.end(), [](const auto& l) { return !l.own_clocks.empty(); });
  auto& sources = sources_[root.value];
  for (std::size_t g = 0; g < loop[root].groups.size(); ++g) sources.push_back(g + 1);
}

std::optional<std::size_t> LoopInstants::group_clock(LoopStateId node, std::size_t group) const {
  const std::size_t source = sources_.at(node.value)[group];
  if (source == 0) return std::nullopt;
  return others_ + source;
}

const std::vector<ZoneBox>& LoopInstants::waits(std::uint64_t node) {
  const auto [at, fresh] = waits_.try_emplace(node);
  if (!fresh) return at->second;
  std::vector<ZoneBox>& result = at->second;
  const bool dense = loop_.time().is_dense();
  const std::shared_ptr<const Turn> turn = loop_.turn(LoopStateId(node));
  const auto add = [&](const Box& box, Units earlier, Units before_end) {
    auto wait = clocks_.translated(box, earlier, before_end);
    if (wait) result.push_back(std::move(*wait));
    return wait.has_value();
  };
  // What would come where a fault is certain, only the budget leaves out.
  for (const ClockBound& bound : turn->faulty) add({bound}, dense ? 0 : 1, dense ? 0 : 1);
  if (!dense) {
    for (const Outcome& outcome : turn->outcomes) {
      if (outcome.faults == 0) add(outcome.bounds, 1, 1);
    }
    return result;
  }
  const LoopState& state = loop_[LoopStateId(node)];
  for (const Wait& wait : turn->waits) {
    // At its end a wait passes no more time.
    if (!add(wait.bounds, 0, 1)) continue;
    for (std::size_t g = 0; g < state.groups.size(); ++g) {
      const Interval cell = loop_.cells().units(loop_.cell(state.groups[g]), loop_.time());
      const auto clock = group_clock(LoopStateId(node), g);
      if (!clock || cell.upper == unbounded) continue;
      // A clock that each call starts anew stays at 0 while time passes.
      if (cell.upper >= 1 || !own_clocks_) result.back().push_back({*clock, {0, cell.upper - 1}});
    }
  }
  return result;
}

const std::vector<Instant>& LoopInstants::steps(std::uint64_t node) {
  const auto [at, fresh] = steps_.try_emplace(node);
  if (!fresh || !loop_.time().is_dense()) return at->second;
  const std::shared_ptr<const Turn> turn = loop_.turn(LoopStateId(node));
  for (std::uint32_t move = 0; move < turn->outcomes.size(); ++move) {
    if (turn->outcomes[move].faults == 0) add_step(turn->outcomes[move], move, LoopStateId(node), at->second);
  }
  return at->second;
}

/// Where no clock is ever forgotten, what starts one does not come back; a program that does so while the plant stands
/// still lets time pass.
bool LoopInstants::comes_back(const Outcome& outcome, LoopStateId from, Instant& step) {
  const LoopState& there = outcome.state;
  const LoopState& here = loop_[from];
  const bool moves = own_clocks_ && there.modes != here.modes;
  if (!moves && (there.groups != here.groups || there.passed != here.passed)) return false;
  std::vector<std::size_t> sources;
  for (std::size_t g = 0; g < there.groups.size(); ++g) {
    const std::size_t source = own_clocks_ ? outcome.sources[g] : g + 1;
    sources.push_back(source == 0 ? 0 : sources_.at(from.value)[source - 1]);
  }
  const auto [known, fresh] = sources_.try_emplace(loop_.number(there).value, sources);
  std::vector<std::size_t> restarts;
  for (std::size_t g = 0; g < sources.size() && !fresh; ++g) {
    if (sources[g] == known->second[g]) continue;
    if (sources[g] != 0) return false;
    restarts.push_back(others_ + known->second[g]);
  }
  step.restarts = std::move(restarts);
  return true;
}

void LoopInstants::add_step(const Outcome& outcome, std::uint32_t move, LoopStateId from,
                            std::vector<Instant>& result) {
  const auto bounds = clocks_.translated(outcome.bounds, 0, 0);
  if (!bounds) return;
  const LoopState& here = loop_[from];
  // A clock that has come to the end of its cell goes on to the next one, and never comes back.
  for (std::size_t g = 0; g < here.groups.size(); ++g) {
    const Cell cell = loop_.cell(here.groups[g]);
    if (loop_.cells().is_last(cell)) continue;
    const Cell next = loop_.cells().around(here.groups[g].clocks, cell.last + 1);
    Instant step{from.value, move, *bounds, {}, true};
    const Units begins = loop_.cells().units(next, loop_.time()).lower;
    const auto clock = group_clock(from, g);
    if (!clock && begins > 0) continue;
    if (clock) step.bounds.push_back({*clock, {begins, unbounded}});
    result.push_back(std::move(step));
  }
  if (outcome.same) return;
  Instant step{from.value, move, *bounds, {}, true};
  const LoopState& there = outcome.state;
  if (there.marking.empty() == here.marking.empty() && !ends_(there.modes) && comes_back(outcome, from, step)) {
    step.leads_on = false;
    step.target = loop_.number(there).value;
    const std::vector<std::size_t> moved = clocks_.restarted(loop_[from].modes, there.modes);
    step.restarts.insert(step.restarts.end(), moved.begin(), moved.end());
  }
  result.push_back(std::move(step));
}

}  // namespace rmpl::verifier
