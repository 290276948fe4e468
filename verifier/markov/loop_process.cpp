// The closed loop as a Markov chain.
// SPDX-License-Identifier: MIT
#include "verifier/markov/loop_process.hpp"

#include <algorithm>
#include <numeric>

#include "base/check.hpp"

namespace rmpl::verifier {

using automata::Modes;

LoopProcess::LoopProcess(Loop& loop, automata::PlantStep& step, const Walked& walked, bool long_clocks, bool joins,
                         Outlook* outlook, Meter& meter)
    : LongClocks(walked.longest_in_state),
      loop_(loop),
      step_(step),
      walked_(walked),
      long_clocks_(long_clocks),
      joins_wanted_(joins),
      meter_(meter),
      ages_(step.plant(), walked.period, long_clocks ? std::optional(walked.longest_in_state) : std::nullopt,
            walked.for_ever),
      cycles_(loop, step, walked.period, outlook) {}

StateNumber LoopProcess::enter(std::vector<LoopStateId> places, const std::vector<Units>& readings,
                               std::vector<Units> ages, unsigned faults, std::vector<std::size_t>& apart) {
  apart.clear();
  if (const auto hazard = steady_hazard(places)) return enter_steady(*hazard);
  stop_idle_clocks(places, ages);
  State entered{{}, walked_.left_out.faults_beyond ? faults : 0, std::move(ages), {}, {}, {}, {}, {}};
  std::vector<std::size_t> groups(readings.size());
  std::iota(groups.begin(), groups.end(), std::size_t{0});
  const std::vector<Interval> before = cycles_.cells(places.front());
  const auto passed = [&](std::size_t g) { return readings[g] > before[g].upper; };
  if (std::any_of(groups.begin(), groups.end(), passed)) {
    for (LoopStateId& place : places) place = cycles_.go_on(place, readings, groups);
    std::sort(places.begin(), places.end());
    places.erase(std::unique(places.begin(), places.end()), places.end());
  }
  entered.places = std::move(places);
  const std::vector<Interval>& cells = cycles_.cells(entered.places.front());
  for (std::size_t i = 0; i < groups.size(); ++i) {
    const Interval& cell = cells[i];
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
  ListNumbers::List list{static_cast<std::uint32_t>(entered.places.size())};
  for (const LoopStateId place : entered.places) list.push_back(static_cast<std::uint32_t>(place.index()));
  list.push_back(entered.faults);
  for (std::size_t c = 0; c < entered.ages.size(); ++c) {
    if (entered.ages[c] == 0) continue;
    list.push_back(static_cast<std::uint32_t>(c));
    list.push_back(static_cast<std::uint32_t>(entered.ages[c]));
  }
  for (const Units reading : entered.readings) list.push_back(static_cast<std::uint32_t>(reading));
  const StateNumber result = numbers_.number(list);
  if (result < states_.size()) return result;
  entered.prospect = {0, 0};
  for (const LoopStateId place : entered.places) {
    entered.prospect = entered.prospect | prospect_of(walked_, loop_[place].modes);
  }
  const Modes& modes = loop_[entered.places.front()].modes;
  for (std::size_t c = 0; c < entered.ages.size(); ++c) {
    if (entered.ages[c] == joined) continue;
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
    const StateNumber state = walked_.wanted(draw.modes)
                                  ? enter_end()
                                  : enter({cycles_.at_rest(loop_.number(*at))}, {}, std::move(ages), 0, none);
    result.push_back({at_start({state, std::vector<Units>(states_[state].longest.size(), 0)}), draw.probability});
  }
  return result;
}

bool LoopProcess::tells_more_apart() {
  if (!joins_.learn()) return false;
  states_.clear();
  steady_.clear();
  end_.reset();
  numbers_ = {};
  return true;
}

LongClocks::Settled LoopProcess::settle(StateNumber number_of_state, const std::vector<Units>& readings) {
  const State state = states_[number_of_state];
  if (state.places.empty()) return {number_of_state, {}};
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
  Settled result{enter(state.places, of_groups, std::move(ages), state.faults, apart), {}};
  for (const std::size_t g : apart) result.readings.push_back(of_groups[g]);
  result.readings.insert(result.readings.end(), of_components.begin(), of_components.end());
  return result;
}

}  // namespace rmpl::verifier
