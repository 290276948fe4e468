// Plants as Markov decision processes.
// SPDX-License-Identifier: MIT
#include "verifier/markov/plant_process.hpp"

#include <algorithm>

namespace rmpl::verifier {

using automata::ControlAction;
using automata::ModeId;
using automata::Modes;

PlantProcess::PlantProcess(automata::PlantStep& step, Commands commands, const Walked& walked, bool long_clocks,
                           Meter& meter)
    : LongClocks(walked.longest_in_state),
      step_(step),
      walked_(walked),
      meter_(meter),
      ages_(step.plant(), walked.period, long_clocks ? std::optional(walked.longest_in_state) : std::nullopt,
            walked.for_ever) {
  for_each_action(step.plant(), commands, [this](const ControlAction& action) { actions_.push_back(action); });
}

StateNumber PlantProcess::enter(Modes modes, std::vector<Units> ages, unsigned faults) {
  if (!walked_.left_out.faults_beyond) faults = 0;
  ListNumbers::List list;
  list.reserve(2 * modes.size() + 1);
  for (const ModeId mode : modes) list.push_back(mode.value);
  for (const Units age : ages) list.push_back(static_cast<std::uint32_t>(age));
  list.push_back(faults);
  const StateNumber result = numbers_.number(list);
  if (result < states_.size()) return result;
  meter_.count_state();
  const Prospect prospect = prospect_of(walked_, modes);
  State& state = states_.emplace_back(State{std::move(modes), std::move(ages), faults, {}, {}, prospect, -1});
  for (std::size_t c = 0; c < state.ages.size(); ++c) {
    if (state.ages[c] == kept_apart) {
      state.longest.push_back(ages_.last(c, state.modes[c]));
    } else if (const Units left = ages_.left(c, state.modes[c], state.ages[c]); left > 0) {
      state.in_state.add(state.ages[c], left);
    }
  }
  return result;
}

LongClocks::Settled PlantProcess::settle(StateNumber number, const std::vector<Units>& readings) {
  const State& state = states_[number];
  std::vector<Units> ages = state.ages;
  Settled result{};
  std::size_t next = 0;
  for (std::size_t c = 0; c < ages.size(); ++c) {
    if (ages[c] != kept_apart) continue;
    const Units reading = readings[next];
    if (reading > state.longest[next++]) {
      ages[c] = reading;
    } else {
      result.readings.push_back(reading);
    }
  }
  result.state = enter(state.modes, std::move(ages), state.faults);
  return result;
}

std::vector<Process::Start> PlantProcess::initial() {
  std::vector<Start> result;
  for (const Draw& draw : initial_draws(step_, walked_.from, meter_).outcomes) {
    std::vector<Units> ages;
    for (std::size_t c = 0; c < draw.modes.size(); ++c) ages.push_back(ages_.entered(c, draw.modes[c]));
    const StateNumber state = enter(draw.modes, std::move(ages), 0);
    result.push_back({at_start({state, std::vector<Units>(states_[state].longest.size(), 0)}), draw.probability});
  }
  return result;
}

bool PlantProcess::wanted(StateNumber state) {
  State& own = states_[state];
  if (own.wanted < 0) own.wanted = walked_.wanted(own.modes) ? 1 : 0;
  return own.wanted == 1;
}

const std::vector<Row>& PlantProcess::rows(StateNumber number_of_state, Real less_likely_than) {
  rows_.clear();
  const State state = states_[number_of_state];
  LeftOut left_out = walked_.left_out;
  left_out.less_likely_than = std::max(left_out.less_likely_than, less_likely_than / many_steps);
  if (left_out.faults_beyond) *left_out.faults_beyond -= state.faults;
  for (const ControlAction& action : actions_) {
    const automata::AllEnabled* enabled = step_.enabled_if_permitted(state.modes, action);
    if (enabled == nullptr) continue;
    const automata::AllEnabled kept = *enabled;
    const Draws drawn = StepDraws(step_, state.modes, kept, walked_.period).at(state.ages, left_out, meter_);
    if (drawn.outcomes.empty() && drawn.left_out == 0) continue;
    Row row;
    row.left_out = drawn.left_out;
    for (const Draw& draw : drawn.outcomes) {
      const Prospect prospect = prospect_of(walked_, draw.modes);
      if (draw.probability.upper * prospect.within(walked_.steps) < less_likely_than) {
        row.foreseen.add(draw.probability.upper, prospect);
        continue;
      }
      std::vector<Units> ages;
      Passage passage;
      std::size_t clock = 0;  // of this state
      for (std::size_t c = 0; c < state.ages.size(); ++c) {
        const bool apart = state.ages[c] == kept_apart;
        const bool restarted = automata::restarts(step_.plant().components[c], kept[c]);
        ages.push_back(ages_.after(c, state.modes[c], state.ages[c], draw.modes[c], restarted));
        if (ages.back() == kept_apart) {
          const bool goes_on = apart && !restarted && draw.modes[c] == state.modes[c];
          passage.push_back(goes_on ? Source{clock, 0} : Source{std::nullopt, 0});
        }
        if (apart) ++clock;
      }
      const StateNumber to = enter(draw.modes, std::move(ages), state.faults + draw.faults);
      row.edges.push_back({to, draw.probability, number(passage, clock)});
    }
    const bool known = std::any_of(rows_.begin(), rows_.end(), [&](const Row& other) {
      return other.left_out == row.left_out && other.foreseen == row.foreseen &&
             std::equal(other.edges.begin(), other.edges.end(), row.edges.begin(), row.edges.end(),
                        [](const Branch& a, const Branch& b) {
                          return a.to == b.to && a.probability == b.probability && a.passage == b.passage;
                        });
    });
    if (!known) rows_.push_back(std::move(row));
  }
  return rows_;
}

}  // namespace rmpl::verifier
