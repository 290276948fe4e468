// Cycles of a closed loop.
// SPDX-License-Identifier: MIT
#include "verifier/markov/loop_cycles.hpp"

#include <algorithm>

namespace rmpl::verifier {

using automata::Modes;

namespace {

/// The entry of a state of the loop in a list that grows as it is asked for.
template <class Entry>
Entry& entry_of(std::vector<Entry>& entries, LoopStateId at) {
  if (entries.size() <= at.index()) entries.resize(std::max(at.index() + 1, 2 * entries.size()));
  return entries[at.index()];
}

}  // namespace

const std::vector<Interval>& LoopCycles::cells(LoopStateId at) {
  auto& known = entry_of(cells_, at);
  if (!known) {
    known.emplace();
    for (const ClockGroup& group : loop_[at].groups) {
      known->push_back(loop_.cells().units(loop_.cell(group), loop_.time()));
    }
  }
  return *known;
}

LoopStateId LoopCycles::go_on(LoopStateId at, const std::vector<Units>& readings, std::vector<std::size_t>& groups) {
  const ClockCells& cells = loop_.cells();
  LoopState state = loop_[at];
  LoopState settled{std::move(state.marking), std::move(state.modes),   std::move(state.passed), {},
                    std::move(state.no_plan), std::move(state.position)};
  groups.clear();
  for (std::size_t g = 0; g < state.groups.size(); ++g) {
    ClockGroup& group = state.groups[g];
    Cell cell = loop_.cell(group);
    while (!cells.is_last(cell) && readings[g] > cells.units(cell, loop_.time()).upper) {
      cell = cells.around(group.clocks, cell.last + 1);
    }
    if (cells.is_last(cell)) {
      settled.passed.insert(settled.passed.end(), group.clocks.begin(), group.clocks.end());
      continue;
    }
    group.position = cell.first;
    settled.groups.push_back(std::move(group));
    groups.push_back(g);
  }
  std::sort(settled.passed.begin(), settled.passed.end());
  return loop_.number(settled);
}

const Outlook::Told& LoopCycles::told(LoopStateId at) {
  if (outlook_ == nullptr) return nothing_;
  const Outlook::Told*& known = entry_of(told_, at);
  if (known == nullptr) known = &outlook_->tell(loop_[at].marking, loop_[at].modes);
  return *known;
}

LoopStateId LoopCycles::at_rest(LoopStateId at) {
  auto& known = entry_of(at_rest_, at);
  if (known) return *known;
  const Outlook::Told& told = this->told(at);
  LoopStateId result = at;
  if (!told.idle.empty() && told.modes != loop_[at].modes) {
    LoopState state = loop_[at];
    state.modes = told.modes;
    result = loop_.number(state);
  }
  known = result;
  return result;
}

LoopCycles::Cycle* LoopCycles::at(LoopStateId at) {
  auto& known = entry_of(cycles_, at);
  if (known) return known->get();
  known.emplace();
  const LoopState& here = loop_[at];
  if (here.marking.empty()) return nullptr;
  const automata::ControlAction action = loop_.action(at);
  const automata::AllEnabled* enabled = step_.enabled_if_permitted(here.modes, action);
  if (enabled == nullptr) return nullptr;
  StepDraws draws(step_, here.modes, *enabled, period_);
  *known = std::make_unique<Cycle>(Cycle{std::move(draws), step_.restarted(here.modes, action), {}});
  return known->get();
}

void LoopCycles::follow(LoopStateId at, Cycle& cycle, const std::vector<Modes>& modes) {
  std::vector<Modes> unknown;
  for (const Modes& next : modes) {
    if (!cycle.followers.contains(next)) unknown.push_back(next);
  }
  if (unknown.empty()) return;
  std::vector<Outcome> outcomes = loop_.outcomes(at, unknown);
  for (std::size_t i = 0; i < outcomes.size(); ++i) {
    const LoopStateId next = at_rest(loop_.number(outcomes[i].state));
    cycle.followers.emplace(std::move(unknown[i]), Follower{next, std::move(outcomes[i].sources)});
  }
  loop_.explored(at);
}

}  // namespace rmpl::verifier
