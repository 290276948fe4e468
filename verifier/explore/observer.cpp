// Observers: what is looked for along a run.
// SPDX-License-Identifier: MIT
#include "verifier/explore/observer.hpp"

namespace verifier {

Observer Observer::reach(Test target, std::optional<Interval> window) {
  return {false, std::move(target), nullptr, window};
}

Observer Observer::miss(Test after, Test then, Units deadline) {
  return {true, std::move(after), std::move(then), Interval{deadline, unbounded}};
}

Phase Observer::next(Phase phase, const automata::Modes& modes) const {
  if (!response_) return trigger_(modes) ? Phase::armed : Phase::searching;
  switch (phase) {
    case Phase::searching:
      if (!trigger_(modes)) return Phase::searching;
      return release_(modes) ? Phase::closed : Phase::armed;
    case Phase::armed:
      return release_(modes) ? Phase::closed : Phase::armed;
    case Phase::closed:
      return Phase::closed;
  }
  return phase;
}

}  // namespace verifier
