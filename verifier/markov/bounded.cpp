// Backward induction with bounds.
// SPDX-License-Identifier: MIT
#include "verifier/markov/bounded.hpp"

#include "verifier/markov/row_value.hpp"

namespace rmpl::verifier {

std::vector<Enclosure> within_steps(const DecisionProcess& decisions, Aim aim, const std::vector<Units>& steps,
                                    Meter& meter) {
  const std::vector<bool> possible = may_reach(decisions);
  std::vector<Enclosure> values(decisions.size());
  for (std::size_t s = 0; s < values.size(); ++s) {
    if (decisions.wanted[s]) values[s] = certain();
  }
  std::vector<Enclosure> next = values;
  std::vector<Enclosure> result;
  Units now = 0;
  bool settled = false;
  for (const Units step : steps) {
    for (; now < step && !settled; ++now) {
      meter.at_steps(static_cast<std::size_t>(now), 0);
      settled = true;
      for (std::size_t s = 0; s < values.size(); ++s) {
        if (!possible[s] || decisions.wanted[s] || decisions.rows[s].empty()) continue;
        meter.poll();
        next[s] = best_value(decisions.rows[s], values, aim);
        settled = settled && next[s] == values[s];
      }
      values.swap(next);
    }
    now = step;
    result.push_back(as_probability(decisions.at_start(values)));
  }
  return result;
}

}  // namespace rmpl::verifier
