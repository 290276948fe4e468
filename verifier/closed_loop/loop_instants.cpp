// What may happen at an instant in the closed loop.
// SPDX-License-Identifier: MIT
#include "verifier/closed_loop/loop_instants.hpp"

#include <algorithm>
#include <numeric>

namespace rmpl::verifier {

LoopInstants::LoopInstants(Loop& loop, LoopStateId root, std::size_t others,
                           base::FunctionRef<bool(const LoopState&)> ends)
    : loop_(loop),
      others_(others),
      ends_(ends),
      clocks_(loop.live(loop[root].modes), others + loop[root].groups.size()) {
  const auto& locations = loop.program().locations;
  own_clocks_ = std::any_of(locations.begin(), locations.end(), [](const auto& l) { return !l.own_clocks.empty(); });
  Sources sources(loop[root].groups.size());
  std::iota(sources.begin(), sources.end(), std::size_t{1});
  number(root, std::move(sources));
  at_bound_ = loop.may_rest(root);
}

std::uint64_t LoopInstants::number(LoopStateId state, Sources sources) {
  const auto [at, fresh] = numbers_.try_emplace({state, std::move(sources)}, nodes_.size());
  if (fresh) nodes_.push_back(&at->first);
  return at->second;
}

std::optional<std::size_t> LoopInstants::group_clock(std::uint64_t node, std::size_t group) const {
  const std::size_t source = nodes_[node]->second[group];
  if (source == 0) return std::nullopt;
  return others_ + source;
}

const std::vector<ZoneBox>& LoopInstants::waits(std::uint64_t node) {
  const auto [at, fresh] = waits_.try_emplace(node);
  if (!fresh) return at->second;
  std::vector<ZoneBox>& result = at->second;
  const bool dense = loop_.time().is_dense();
  const std::shared_ptr<const Turn> turn = loop_.turn(state_of(node));
  const auto add = [&](const Box& box, Units earlier, Units before_end) {
    auto wait = clocks_.translated(box, earlier, before_end);
    if (wait) result.push_back(std::move(*wait));
    return wait.has_value();
  };
  // What would come where a fault is certain, only the budget leaves out.
  for (ZoneBox& faulty : certain_faults(turn->faulty, clocks_, loop_.time())) result.push_back(std::move(faulty));
  if (!dense) {
    for (const Outcome& outcome : turn->outcomes) {
      if (outcome.faults == 0) add(outcome.bounds, 1, 1);
    }
    return result;
  }
  const LoopState& state = loop_[state_of(node)];
  for (const Wait& wait : turn->waits) {
    // At its end a wait passes no more time.
    if (!add(wait.bounds, 0, 1)) continue;
    for (std::size_t g = 0; g < state.groups.size(); ++g) {
      const Interval cell = loop_.cells().units(loop_.cell(state.groups[g]), loop_.time());
      const auto clock = group_clock(node, g);
      const bool stays = std::find(wait.restarted.begin(), wait.restarted.end(), g) != wait.restarted.end();
      if (clock && !stays && cell.upper != unbounded) result.back().push_back({*clock, {0, cell.upper - 1}});
    }
  }
  return result;
}

const Instant* LoopInstants::step(std::uint64_t node, std::size_t number) {
  const std::vector<Instant>& all = steps(node);
  return number < all.size() ? &all[number] : nullptr;
}

const std::vector<Instant>& LoopInstants::steps(std::uint64_t node) {
  const auto [at, fresh] = steps_.try_emplace(node);
  if (!fresh || !loop_.time().is_dense()) return at->second;
  const std::shared_ptr<const Turn> turn = loop_.turn(state_of(node));
  for (std::uint32_t move = 0; move < turn->outcomes.size(); ++move) {
    if (turn->outcomes[move].faults == 0) add_step(turn->outcomes[move], move, node, at->second);
  }
  return at->second;
}

/// Where no clock is ever forgotten, what starts one does not come back.
std::optional<std::uint64_t> LoopInstants::target(const Outcome& outcome, std::uint64_t from) {
  const LoopState& there = outcome.state;
  const LoopState& here = loop_[state_of(from)];
  if (!own_clocks_ && (there.groups != here.groups || there.passed != here.passed)) return std::nullopt;
  Sources sources;
  for (const std::size_t source : outcome.sources) {
    sources.push_back(source == 0 ? 0 : nodes_[from]->second[source - 1]);
  }
  return number(loop_.number(there), std::move(sources));
}

void LoopInstants::add_step(const Outcome& outcome, std::uint32_t move, std::uint64_t from,
                            std::vector<Instant>& result) {
  const auto bounds = clocks_.lasting(outcome.bounds, from == 0 && at_bound_);
  if (!bounds) return;
  const LoopState& here = loop_[state_of(from)];
  // A clock that has come to the end of its cell goes on to the next one, and never comes back.
  for (std::size_t g = 0; g < here.groups.size(); ++g) {
    const Cell cell = loop_.cell(here.groups[g]);
    if (loop_.cells().is_last(cell)) continue;
    const Cell next = loop_.cells().around(here.groups[g].clocks, cell.last + 1);
    Instant step{from, move, *bounds, {}, true};
    const Units begins = loop_.cells().units(next, loop_.time()).lower;
    const auto clock = group_clock(from, g);
    if (!clock && begins > 0) continue;
    if (clock) step.bounds.push_back({*clock, {begins, unbounded}});
    result.push_back(std::move(step));
  }
  const std::vector<automata::ComponentId>& anew = loop_.turn(state_of(from))->anew;
  if (outcome.same) {
    clocks_.add_restarts({from, move, *bounds, {}, false}, anew,
                         [&](Instant&& one) { result.push_back(std::move(one)); });
    return;
  }
  Instant step{from, move, *bounds, {}, true};
  const LoopState& there = outcome.state;
  const bool stays = there.marking.empty() == here.marking.empty() && !ends_(there);
  const std::optional<std::uint64_t> node = stays ? target(outcome, from) : std::nullopt;
  if (node) {
    step.leads_on = false;
    step.target = *node;
    step.restarts = clocks_.restarted(here.modes, there.modes, anew);
  }
  result.push_back(std::move(step));
}

}  // namespace rmpl::verifier
