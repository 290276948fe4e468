// The closed loop as a Markov chain.
// SPDX-License-Identifier: MIT
#include "verifier/markov/loop_process.hpp"

#include <algorithm>

#include "base/check.hpp"

namespace rmpl::verifier {

using automata::Modes;

LoopProcess::LoopProcess(Loop& loop, automata::PlantStep& step, const Walked& walked, bool long_clocks, Meter& meter)
    : loop_(loop),
      step_(step),
      walked_(walked),
      long_clocks_(long_clocks),
      meter_(meter),
      ages_(step.plant(), walked.period, long_clocks, walked.for_ever) {}

StateNumber LoopProcess::enter(LoopState state, const std::vector<Units>& readings, std::vector<Units> ages,
                               unsigned faults, std::vector<std::size_t>& apart) {
  const ClockCells& cells = loop_.cells();
  LoopState settled{std::move(state.marking), std::move(state.modes),   std::move(state.passed), {},
                    std::move(state.no_plan), std::move(state.position)};
  State entered{{}, walked_.left_out.faults_beyond ? faults : 0, std::move(ages), {}, {}, -1};
  apart.clear();
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
    const Interval units = cells.units(cell, loop_.time());
    const bool is_long = long_clocks_ && units.upper - units.lower > longest_in_state;
    entered.readings.push_back(is_long ? kept_apart : readings[g]);
    if (!is_long) continue;
    entered.longest.push_back(units.upper);
    apart.push_back(g);
  }
  std::sort(settled.passed.begin(), settled.passed.end());
  for (std::size_t c = 0; c < entered.ages.size(); ++c) {
    if (entered.ages[c] == kept_apart) entered.longest.push_back(ages_.last(c, settled.modes[c]));
  }
  entered.loop = loop_.number(settled);
  ListNumbers::List list{static_cast<std::uint32_t>(entered.loop.index()), entered.faults};
  for (const Units age : entered.ages) list.push_back(static_cast<std::uint32_t>(age));
  for (const Units reading : entered.readings) list.push_back(static_cast<std::uint32_t>(reading));
  const StateNumber result = numbers_.number(list);
  if (result == states_.size()) {
    states_.push_back(std::move(entered));
    meter_.count_state();
  }
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
    const StateNumber state = enter(*at, {}, std::move(ages), 0, none);
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
  Settled result{enter(loop_[state.loop], of_groups, std::move(ages), state.faults, apart), {}};
  for (const std::size_t g : apart) result.readings.push_back(of_groups[g]);
  result.readings.insert(result.readings.end(), of_components.begin(), of_components.end());
  return result;
}

Branch LoopProcess::branch_to(const State& state, const LoopState& here, const automata::AllEnabled& enabled,
                              const Outcome& outcome, const Draw& draw) {
  const auto apart_before = [&state](std::size_t group) {
    return static_cast<std::size_t>(
        std::count(state.readings.begin(), state.readings.begin() + static_cast<std::ptrdiff_t>(group), kept_apart));
  };
  // A long clock is taken to read what it may in its cell; `follow` sees to the bound.
  std::vector<Units> readings;
  std::vector<std::optional<std::size_t>> from(outcome.sources.size());
  for (std::size_t g = 0; g < outcome.sources.size(); ++g) {
    const std::size_t source = outcome.sources[g];
    if (source == 0) {
      readings.push_back(1);
    } else if (state.readings[source - 1] != kept_apart) {
      readings.push_back(state.readings[source - 1] + 1);
    } else {
      readings.push_back(loop_.cells().units(loop_.cell(outcome.state.groups[g]), loop_.time()).lower);
      from[g] = apart_before(source - 1);
    }
  }
  std::size_t clock = apart_before(state.readings.size());
  std::vector<Units> ages;
  Passage of_components;
  for (std::size_t c = 0; c < state.ages.size(); ++c) {
    const bool apart = state.ages[c] == kept_apart;
    const bool restarted = automata::restarts(step_.plant().components[c], enabled[c]);
    ages.push_back(ages_.after(c, here.modes[c], state.ages[c], draw.modes[c], restarted));
    if (ages.back() == kept_apart) {
      const bool goes_on = apart && !restarted && draw.modes[c] == here.modes[c];
      of_components.push_back(goes_on ? Source{clock, 0} : Source{std::nullopt, 0});
    }
    if (apart) ++clock;
  }
  std::vector<std::size_t> apart;
  const StateNumber to = enter(outcome.state, readings, std::move(ages), state.faults + draw.faults, apart);
  Passage passage;
  for (const std::size_t g : apart) passage.push_back({from[g], from[g] ? 0 : readings[g]});
  passage.insert(passage.end(), of_components.begin(), of_components.end());
  return {to, draw.probability, number(passage, clock)};
}

const std::vector<Row>& LoopProcess::rows(StateNumber number_of_state, Real less_likely_than) {
  rows_.clear();
  const State state = states_[number_of_state];
  const LoopState here = loop_[state.loop];
  if (here.marking.empty()) return rows_;
  const automata::ControlAction action = loop_.action(state.loop);
  const automata::AllEnabled* enabled = step_.enabled_if_permitted(here.modes, action);
  if (enabled == nullptr) return rows_;
  const automata::AllEnabled kept = *enabled;
  LeftOut left_out = walked_.left_out;
  left_out.less_likely_than = std::max(left_out.less_likely_than, less_likely_than);
  if (left_out.faults_beyond) *left_out.faults_beyond -= state.faults;
  const Draws drawn = draws(step_, here.modes, kept, state.ages, walked_.period, left_out, meter_);
  if (drawn.outcomes.empty() && drawn.left_out == 0) return rows_;
  std::vector<Modes> modes;
  modes.reserve(drawn.outcomes.size());
  for (const Draw& draw : drawn.outcomes) modes.push_back(draw.modes);
  const std::vector<Outcome> outcomes = loop_.outcomes(state.loop, modes);
  Row row;
  row.left_out = drawn.left_out;
  for (std::size_t i = 0; i < outcomes.size(); ++i) {
    row.edges.push_back(branch_to(state, here, kept, outcomes[i], drawn.outcomes[i]));
  }
  loop_.explored(state.loop);
  rows_.push_back(std::move(row));
  return rows_;
}

}  // namespace rmpl::verifier
