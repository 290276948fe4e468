// The modes of a thread.
// SPDX-License-Identifier: MIT
#include "automata/software/marking_modes.hpp"

#include <algorithm>

#include "base/check.hpp"

namespace rmpl::automata {

MarkingModes::MarkingModes(const Thread& thread) : thread_(thread), of_(thread.markings.size()) {
  const std::size_t markings = thread.markings.size();
  for (std::size_t m = 0; m < markings; ++m) {
    if (thread.markings[m].way == 0) continue;
    of_[m].emplace_back(all_.size());
    all_.push_back({m, std::nullopt});
  }
  std::vector<bool> entered(markings, false);
  for (std::size_t m = 0; m < markings; ++m) {
    if (of_[m].empty()) continue;
    for (const ThreadStep& step : thread.markings[m].steps) {
      for (const ThreadOutcome& outcome : step.outcomes) {
        if (outcome.rarity < 1 && apart(m, outcome.target)) entered[outcome.target] = true;
      }
    }
  }
  for (std::size_t m = 0; m < markings; ++m) {
    if (!entered[m]) continue;
    const ModeId usual = of_[m].front();
    for (int more = leads(m, m, true) ? 2 : 1; more > 0; --more) {
      of_[m].emplace_back(all_.size());
      all_.push_back({m, usual});
    }
  }
}

ModeId MarkingModes::after(ModeId from, const ThreadOutcome& outcome) const {
  const std::vector<ModeId>& modes = of_[outcome.target];
  const std::size_t marking = all_[from.index()].marking;
  if (outcome.rarity == 1 || !apart(marking, outcome.target)) return modes.front();
  CHECK(modes.size() > 1);
  return modes[1] == from ? modes[2] : modes[1];
}

bool MarkingModes::apart(std::size_t from, std::size_t to) const {
  return thread_.markings[to].way == 1 || from == to || leads(from, to, false);
}

bool MarkingModes::leads(std::size_t from, std::size_t to, bool improbable) const {
  const std::vector<ThreadStep>& steps = thread_.markings[from].steps;
  return std::any_of(steps.begin(), steps.end(), [&](const ThreadStep& step) {
    return std::any_of(step.outcomes.begin(), step.outcomes.end(), [&](const ThreadOutcome& outcome) {
      return outcome.target == to && (outcome.rarity < 1) == improbable;
    });
  });
}

}  // namespace rmpl::automata
