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

bool Observer::Remembered::operator()(SituationId id, const Situation& situation) {
  if (answers.size() <= id.index()) answers.resize(id.index() + 1);
  auto& answer = answers[id.index()];
  if (!answer) answer = test(situation.modes);
  return *answer;
}

Phase Observer::next(Phase phase, SituationId id, const Situation& situation) {
  if (!response_) return trigger_(id, situation) ? Phase::armed : Phase::searching;
  switch (phase) {
    case Phase::searching:
      if (!trigger_(id, situation)) return Phase::searching;
      return release_(id, situation) ? Phase::closed : Phase::armed;
    case Phase::armed:
      return release_(id, situation) ? Phase::closed : Phase::armed;
    case Phase::closed:
      return Phase::closed;
  }
  return phase;
}

}  // namespace verifier
