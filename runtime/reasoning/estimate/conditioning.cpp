// An update, and what becomes of readings that nothing explains.
// SPDX-License-Identifier: MIT
#include "runtime/reasoning/estimate/conditioning.hpp"

namespace rmpl::runtime {

using automata::Observation;

Conditioned Conditioning::start(Filter& filter, const Observation& observation) {
  if (filter.start(observation)) return {};
  targets_.begin();
  targets_.add(step_.initial_moves());
  const auto refute = [&](const Observation& readings) { return targets_.refute(readings); };
  const auto aside = readings_to_set_aside(observation, refute);
  if (aside && filter.start(without(observation, *aside))) return {*aside, true};
  return {observation, filter.start({})};
}

Conditioned Conditioning::update(Filter& filter, const StepInput& input, automata::Ticks before) {
  if (filter.condition(input)) {
    filter.adopt(input, true);
    return {};
  }
  targets_.begin();
  for (const BeliefEntry& entry : filter.belief()) {
    targets_.add(step_.moves(entry.state, input.action, before, input.now));
  }
  const auto refute = [&](const Observation& readings) { return targets_.refute(readings); };
  Observation aside = readings_to_set_aside(input.observation, refute).value_or(input.observation);
  Observation rest = without(input.observation, aside);
  const bool doubtful = filter.estimate().cut || filter.estimate().missing_total > 0;
  bool follows = filter.widen({input.action, rest, input.now, input.deadline}, aside, doubtful);
  if (!follows) {
    aside = input.observation;
    rest.clear();
    follows = filter.widen({input.action, rest, input.now, input.deadline}, aside, doubtful);
  }
  const StepInput counted{input.action, rest, input.now, input.deadline};
  follows ? filter.adopt(counted, false) : filter.stay(counted);
  return {std::move(aside), follows};
}

}  // namespace rmpl::runtime
