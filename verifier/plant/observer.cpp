// Observers: what is looked for along a run.
// SPDX-License-Identifier: MIT
#include "verifier/plant/observer.hpp"

namespace rmpl::verifier {

Observer Observer::reach(Test target, std::optional<Interval> window) {
  return {false, std::move(target), nullptr, window};
}

Observer Observer::miss(Test after, Test then, std::optional<Units> deadline) {
  const auto too_late = deadline ? std::optional(Interval{*deadline, unbounded}) : std::nullopt;
  return {true, std::move(after), std::move(then), too_late};
}

Observer Observer::end() {
  Observer result(
      false, [](const automata::Modes&) { return false; }, nullptr, std::nullopt);
  result.seeks_end_ = true;
  return result;
}

Phase Observer::next(Phase phase, const automata::Modes& modes) const {
  const bool open = phase == Phase::armed && response_;
  return (open || trigger_(modes)) && !(response_ && release_(modes)) ? Phase::armed : Phase::searching;
}

}  // namespace rmpl::verifier
