// The closed loop as a Markov chain.
// SPDX-License-Identifier: MIT
#include "verifier/markov/loop_process.hpp"

#include <algorithm>
#include <numeric>

#include "base/check.hpp"

namespace rmpl::verifier {

using automata::Modes;

LoopProcess::LoopProcess(Loop& loop, automata::PlantStep& step, const Walked& walked, bool long_clocks, Meter& meter)
    : LongClocks(walked.longest_in_state),
      loop_(loop),
      step_(step),
      walked_(walked),
      long_clocks_(long_clocks),
      meter_(meter),
      ages_(step.plant(), walked.period, long_clocks ? std::optional(walked.longest_in_state) : std::nullopt,
            walked.for_ever) {}

namespace {

/// The entry of a state of the loop in a list that grows as it is asked for.
template <class Entry>
Entry& entry_of(std::vector<Entry>& entries, LoopStateId at) {
  if (entries.size() <= at.index()) entries.resize(std::max(at.index() + 1, 2 * entries.size()));
  return entries[at.index()];
}

}  // namespace

const std::vector<Interval>& LoopProcess::cells(LoopStateId at) {
  auto& known = entry_of(cells_, at);
  if (!known) {
    known.emplace();
    for (const ClockGroup& group : loop_[at].groups) {
      known->push_back(loop_.cells().units(loop_.cell(group), loop_.time()));
    }
  }
  return *known;
}

LoopStateId LoopProcess::go_on(LoopStateId at, const std::vector<Units>& readings, std::vector<std::size_t>& groups) {
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

StateNumber LoopProcess::enter(LoopStateId at, const std::vector<Units>& readings, std::vector<Units> ages,
                               unsigned faults, std::vector<std::size_t>& apart) {
  State entered{{}, walked_.left_out.faults_beyond ? faults : 0, std::move(ages), {}, {}, {}, {}, -1};
  apart.clear();
  std::vector<std::size_t> groups(readings.size());
  std::iota(groups.begin(), groups.end(), std::size_t{0});
  const auto passed = [&](std::size_t g) { return readings[g] > cells(at)[g].upper; };
  entered.loop = std::any_of(groups.begin(), groups.end(), passed) ? go_on(at, readings, groups) : at;
  for (std::size_t i = 0; i < groups.size(); ++i) {
    const Interval& cell = cells(entered.loop)[i];
    const Units reading = readings[groups[i]];
    if (long_clocks_ && cell.upper - cell.lower > walked_.longest_in_state) {
      entered.readings.push_back(kept_apart);
      entered.longest.push_back(cell.upper);
      apart.push_back(groups[i]);
    } else {
      entered.readings.push_back(reading);
      entered.in_state.add(reading, cell.upper - reading);
    }
  }
  ListNumbers::List list{static_cast<std::uint32_t>(entered.loop.index()), entered.faults};
  for (const Units age : entered.ages) list.push_back(static_cast<std::uint32_t>(age));
  for (const Units reading : entered.readings) list.push_back(static_cast<std::uint32_t>(reading));
  const StateNumber result = numbers_.number(list);
  if (result < states_.size()) return result;
  const Modes& modes = loop_[entered.loop].modes;
  entered.prospect = prospect_of(walked_, modes);
  for (std::size_t c = 0; c < entered.ages.size(); ++c) {
    if (entered.ages[c] == kept_apart) {
      entered.longest.push_back(ages_.last(c, modes[c]));
    } else if (const Units left = ages_.left(c, modes[c], entered.ages[c]); left > 0) {
      entered.in_state.add(entered.ages[c], left);
    }
  }
  states_.push_back(std::move(entered));
  meter_.count_state();
  return result;
}

std::vector<Process::Start> LoopProcess::initial() {
  std::vector<Start> result;
  std::vector<std::size_t> none;
  const std::vector<LoopState> states = loop_.initial(walked_.from);
  for (const Draw& draw : initial_draws(step_, walked_.from, meter_).outcomes) {
    const auto at =
        std::find_if(states.begin(), states.end(), [&](const LoopState& state) { return state.modes == draw.modes; });
    CHECK(at != states.end() && "the loop starts wherever the plant does");
    std::vector<Units> ages;
    for (std::size_t c = 0; c < draw.modes.size(); ++c) ages.push_back(ages_.entered(c, draw.modes[c]));
    const StateNumber state = enter(loop_.number(*at), {}, std::move(ages), 0, none);
    result.push_back({at_start({state, std::vector<Units>(states_[state].longest.size(), 0)}), draw.probability});
  }
  return result;
}

bool LoopProcess::wanted(StateNumber state) {
  State& own = states_[state];
  if (own.wanted < 0) own.wanted = walked_.wanted(loop_[own.loop].modes) ? 1 : 0;
  return own.wanted == 1;
}

LongClocks::Settled LoopProcess::settle(StateNumber number_of_state, const std::vector<Units>& readings) {
  const State state = states_[number_of_state];
  std::size_t next = 0;
  std::vector<Units> of_groups = state.readings;
  for (Units& reading : of_groups) {
    if (reading == kept_apart) reading = readings[next++];
  }
  std::vector<Units> of_components;
  std::vector<Units> ages = state.ages;
  for (Units& age : ages) {
    if (age != kept_apart) continue;
    const Units reading = readings[next];
    if (reading > state.longest[next++]) {
      age = reading;
    } else {
      of_components.push_back(reading);
    }
  }
  std::vector<std::size_t> apart;
  Settled result{enter(state.loop, of_groups, std::move(ages), state.faults, apart), {}};
  for (const std::size_t g : apart) result.readings.push_back(of_groups[g]);
  result.readings.insert(result.readings.end(), of_components.begin(), of_components.end());
  return result;
}

Branch LoopProcess::branch_to(const State& state, const Modes& here, const std::vector<bool>& restarted,
                              const Follower& follower, const Draw& draw) {
  const auto apart_before = [&state](std::size_t group) {
    return static_cast<std::size_t>(
        std::count(state.readings.begin(), state.readings.begin() + static_cast<std::ptrdiff_t>(group), kept_apart));
  };
  // A long clock is taken to read what it may in its cell; `follow` sees to the bound.
  std::vector<Units> readings;
  std::vector<std::optional<std::size_t>> from(follower.sources.size());
  for (std::size_t g = 0; g < follower.sources.size(); ++g) {
    const std::size_t source = follower.sources[g];
    if (source == 0) {
      readings.push_back(1);
    } else if (state.readings[source - 1] != kept_apart) {
      readings.push_back(state.readings[source - 1] + 1);
    } else {
      readings.push_back(cells(follower.loop)[g].lower);
      from[g] = apart_before(source - 1);
    }
  }
  std::size_t clock = apart_before(state.readings.size());
  std::vector<Units> ages;
  Passage of_components;
  for (std::size_t c = 0; c < state.ages.size(); ++c) {
    const bool apart = state.ages[c] == kept_apart;
    ages.push_back(ages_.after(c, here[c], state.ages[c], draw.modes[c], restarted[c]));
    if (ages.back() == kept_apart) {
      const bool goes_on = apart && !restarted[c] && draw.modes[c] == here[c];
      of_components.push_back(goes_on ? Source{clock, 0} : Source{std::nullopt, 0});
    }
    if (apart) ++clock;
  }
  std::vector<std::size_t> apart;
  const StateNumber to = enter(follower.loop, readings, std::move(ages), state.faults + draw.faults, apart);
  Passage passage;
  for (const std::size_t g : apart) passage.push_back({from[g], from[g] ? 0 : readings[g]});
  passage.insert(passage.end(), of_components.begin(), of_components.end());
  return {to, draw.probability, number(passage, clock)};
}

LoopProcess::Cycle* LoopProcess::cycle(LoopStateId at) {
  auto& known = entry_of(cycles_, at);
  if (known) return known->get();
  known.emplace();
  const LoopState& here = loop_[at];
  if (here.marking.empty()) return nullptr;
  const automata::ControlAction action = loop_.action(at);
  const automata::AllEnabled* enabled = step_.enabled_if_permitted(here.modes, action);
  if (enabled == nullptr) return nullptr;
  StepDraws draws(step_, here.modes, *enabled, walked_.period);
  *known = std::make_unique<Cycle>(Cycle{std::move(draws), step_.restarted(here.modes, action), {}});
  return known->get();
}

void LoopProcess::follow_all(LoopStateId at, Cycle& cycle, const std::vector<Draw>& draws) {
  std::vector<Modes> unknown;
  for (const Draw& draw : draws) {
    if (!cycle.followers.contains(draw.modes)) unknown.push_back(draw.modes);
  }
  if (unknown.empty()) return;
  std::vector<Outcome> outcomes = loop_.outcomes(at, unknown);
  for (std::size_t i = 0; i < outcomes.size(); ++i) {
    const LoopStateId next = loop_.number(outcomes[i].state);
    cycle.followers.emplace(std::move(unknown[i]), Follower{next, std::move(outcomes[i].sources)});
  }
  loop_.explored(at);
}

const std::vector<Row>& LoopProcess::rows(StateNumber number_of_state, Real less_likely_than) {
  rows_.clear();
  const State state = states_[number_of_state];
  Cycle* const cycle = this->cycle(state.loop);
  if (cycle == nullptr) return rows_;
  LeftOut left_out = walked_.left_out;
  left_out.less_likely_than = std::max(left_out.less_likely_than, less_likely_than);
  if (left_out.faults_beyond) *left_out.faults_beyond -= state.faults;
  const Draws drawn = cycle->draws.at(state.ages, left_out, meter_);
  if (drawn.outcomes.empty() && drawn.left_out == 0) return rows_;
  follow_all(state.loop, *cycle, drawn.outcomes);
  const Modes here = loop_[state.loop].modes;
  Row row;
  row.left_out = drawn.left_out;
  for (const Draw& draw : drawn.outcomes) {
    row.edges.push_back(branch_to(state, here, cycle->restarted, cycle->followers.at(draw.modes), draw));
  }
  rows_.push_back(std::move(row));
  return rows_;
}

}  // namespace rmpl::verifier
