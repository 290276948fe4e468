// Stop watches around the engines.
// SPDX-License-Identifier: MIT
#include "runtime/scenario/meter.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>

namespace runtime {
namespace {

using Clock = std::chrono::steady_clock;

double since(Clock::time_point begin) { return std::chrono::duration<double>(Clock::now() - begin).count(); }

std::string line(const char* name, const Measurement& m) {
  char text[160];
  std::snprintf(text, sizeof text,
                "  %-16s %6zu calls  %6zu candidates, %zu at most  median %.3f ms  p99 %.3f ms  worst %.3f ms\n", name,
                m.seconds.size(), m.checked, m.most, 1e3 * m.quantile(0.5), 1e3 * m.quantile(0.99),
                1e3 * m.quantile(1));
  return text;
}

}  // namespace

void Measurement::note(double seconds_taken, std::size_t candidates) {
  seconds.push_back(seconds_taken);
  checked += candidates;
  most = std::max(most, candidates);
}

double Measurement::quantile(double share) const {
  if (seconds.empty()) return 0;
  std::vector<double> sorted = seconds;
  std::sort(sorted.begin(), sorted.end());
  return sorted[static_cast<std::size_t>(std::ceil(share * static_cast<double>(sorted.size()))) - 1];
}

std::string text_of(const Measurements& measurements) {
  return line("estimation", measurements.estimation) + line("reconfiguration", measurements.reconfiguration);
}

const Estimate& MeteredEstimator::update(const automata::ControlAction& action,
                                         const automata::Observation& observation, automata::Ticks now) {
  const auto begin = Clock::now();
  const Estimate& estimate = estimator_.update(action, observation, now);
  measurement_.note(since(begin), estimate.checked);
  return estimate;
}

Reconfiguration MeteredReconfigurer::next(const automata::Modes& modes, const automata::Formula& goal) {
  const auto begin = Clock::now();
  Reconfiguration answer = reconfigurer_.next(modes, goal);
  measurement_.note(since(begin), answer.checked);
  return answer;
}

Reconfiguration MeteredReconfigurer::next_of_all(std::span<const automata::Modes> tracked,
                                                 const automata::Formula& goal) {
  const auto begin = Clock::now();
  Reconfiguration answer = reconfigurer_.next_of_all(tracked, goal);
  measurement_.note(since(begin), answer.checked);
  return answer;
}

}  // namespace runtime
