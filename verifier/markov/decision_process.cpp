// Meeting all states of a process.
// SPDX-License-Identifier: MIT
#include "verifier/markov/decision_process.hpp"

#include <algorithm>

namespace rmpl::verifier {

bool DecisionProcess::is_chain() const {
  return std::all_of(rows.begin(), rows.end(), [](const auto& choices) { return choices.size() <= 1; });
}

Enclosure DecisionProcess::at_start(const std::vector<Enclosure>& values) const {
  Enclosure result;
  for (const auto& [point, probability] : start) {
    if (values[point.state].upper > 0) result = result + probability * values[point.state];
  }
  return result;
}

DecisionProcess explore(Process& process, std::optional<Units> steps, Meter& meter) {
  DecisionProcess result;
  result.start = process.initial();
  // States are numbered as they are met: in order of the steps that lead to them.
  Units depth = 0;
  std::size_t next_depth = process.states();
  for (StateNumber state = 0; state < process.states(); ++state) {
    meter.poll();
    meter.at(process.states() - state);
    if (state == next_depth) {
      ++depth;
      next_depth = process.states();
    }
    result.wanted.push_back(process.wanted(state));
    const bool ends = result.wanted.back() || (steps && depth >= *steps);
    result.rows.push_back(ends ? std::vector<Row>{} : process.rows(state, 0));
  }
  return result;
}

}  // namespace rmpl::verifier
