// One estimator, and a window beside it.
// SPDX-License-Identifier: MIT
#include "runtime/executive/answer/log_estimator.hpp"

#include <algorithm>
#include <chrono>
#include <utility>

#include "runtime/executive/cycle/stopwatch.hpp"
#include "runtime/reasoning/estimate/belief.hpp"
#include "runtime/reasoning/estimate/product.hpp"

namespace rmpl::runtime {
namespace {

using Engine = LogEstimatorOptions::Engine;

/// An upper bound of the probability of what a line does not list. A belief that is listed in full adds up to 1 but for
/// rounding.
double unlisted(const Estimate& estimate, const Belief& belief) {
  constexpr double rounding = 1e-12;
  const double missing = std::min(1.0, estimate.missing_total + 1 - std::min(1.0, total(belief)));
  return missing > rounding ? missing : estimate.missing_total;
}

}  // namespace

LogEstimator::LogEstimator(const automata::Plant& plant, LogEstimatorOptions options)
    : plant_(plant), options_(std::move(options)) {
  const bool exact = options_.engine == Engine::exact;
  estimator_ =
      exact ? make_exact_estimator(plant, estimator_options()) : make_k_best_estimator(plant, estimator_options());
  if (options_.forgets_clocks()) live_ = runtime::live_clocks(plant);
  if (options_.window && starts()) window_.emplace(plant, estimator_options(), exact, *options_.window);
}

EstimatorOptions LogEstimator::estimator_options() const {
  EstimatorOptions estimator;
  if (options_.k) estimator.k = estimator.listed = *options_.k;
  if (options_.deadline) estimator.deadline = std::chrono::nanoseconds(options_.deadline->count);
  const bool as_is = options_.thesis || options_.ranks;
  estimator.merge_trajectories = estimator.observation_factor = estimator.normalise = !as_is;
  estimator.ranks = options_.ranks;
  estimator.live_clocks_only = options_.forgets_clocks();
  estimator.account = options_.stats;
  estimator.interruption = options_.interruption;
  estimator.bytes = options_.bytes;
  return estimator;
}

/// The head of a belief: all of it, but with `exact` no more than was asked for. Throws TooManyStates.
Belief LogEstimator::listed(const Belief& belief) const {
  const std::size_t most = options_.engine == Engine::exact && options_.k ? *options_.k : belief.size();
  if (std::min(belief.size(), most) > most_states) {
    throw TooManyStates("the belief has " + std::to_string(belief.size()) + " states");
  }
  return {belief.begin(), belief.begin() + static_cast<std::ptrdiff_t>(std::min(belief.size(), most))};
}

PlantAnswer LogEstimator::answer(const LogLine& line) {
  const bool start = !begun_ && line.is_of_start();
  const bool read_again = before_.observations == line.observations;
  if (start) {
    take_in(line.observations);
    estimator_->start(at_start_);
    if (window_) {
      window_->start(at_start_);
      found_ = window_->trajectories();
    }
  } else {
    // Cycles that were left out went as the line before says.
    for (std::uint64_t i = 1; i <= line.unchanged; ++i) {
      estimator_options().go_on();
      update(before_, line.time_of_unchanged(i), false);
    }
  }
  before_.command = line.command;
  before_.observations = line.observations;
  if (!start) update(before_, line.time, true);
  const bool repeats = !start && stayed_ && read_again && !tells_clocks_ && !window_;
  if (start || !stayed_) list_belief();
  if (window_) tell_history();
  const Estimate& estimate = estimator_->estimate();
  cost_ = {estimate.checked, estimate.missing_mass};
  const double missing = unlisted(estimate, belief_);
  account_.lacking = std::max({account_.lacking, estimate.missing_total, estimate.missing_mass});
  if (!start) {
    account_.cut = account_.cut || estimate.cut;
    account_.checked += cost_.checked;
    account_.dropped = std::max(account_.dropped, cost_.dropped);
    account_.missing = std::max(account_.missing, missing);
  }
  return {line,
          estimate,
          belief_,
          options_.weighs() ? std::optional(missing) : std::nullopt,
          options_.stats ? &cost_ : nullptr,
          window_ ? &history_ : nullptr,
          live_ ? &*live_ : nullptr,
          options_.ranks,
          options_.sampled ? &*options_.sampled : nullptr,
          repeats};
}

void LogEstimator::list_belief() {
  belief_ = listed(estimator_->belief());
  stayed_ = true;
  tells_clocks_ = std::any_of(belief_.begin(), belief_.end(), [&](const BeliefEntry& entry) {
    for (std::size_t c = 0; c < entry.state.clock_starts.size(); ++c) {
      if (!live_ || (*live_)[c][entry.state.modes[c].index()]) return true;
    }
    return false;
  });
}

/// `answered`: what most likely happened is told after it.
void LogEstimator::update(const Step& told, automata::Ticks time, bool answered) {
  begun_ = true;
  const automata::ControlAction action = automata::action_from(plant_, told.command);
  std::optional<Stopwatch> stopwatch;  // which asks the system, as often as there are lines
  if (options_.took) stopwatch.emplace();
  estimator_->update(action, told.observations, time);
  stayed_ = stayed_ && estimator_->stayed();
  if (window_) {
    window_->update(action, told.observations, time);
    if (answered) found_ = window_->trajectories();
  }
  if (stopwatch) options_.took(stopwatch->seconds());
  ++account_.updates;
  times_.push_back(time);
  if (times_.size() > options_.window.value_or(0) + 1) times_.erase(times_.begin());
}

void LogEstimator::tell_history() {
  PlantHistory next{times_, std::move(found_), account_.updates + 1 - times_.size(), {}, window_->cut()};
  const auto unexplained = window_->set_aside();
  for (std::size_t t = 0; t < unexplained.size(); ++t) {
    if (!unexplained[t].empty()) next.unexplained.push_back({times_[t + 1], unexplained[t]});
  }
  account_.searched = account_.searched || window_->searched();
  account_.history_cut = account_.history_cut || next.cut;
  for (std::size_t t = 0; !history_.trajectories.empty() && t < times_.size(); ++t) {
    const auto& last = history_.trajectories.front().states;
    if (next.first + t < history_.first || next.first + t >= history_.first + last.size()) continue;
    const automata::Modes& before = last[next.first + t - history_.first].modes;
    const automata::Modes& now = next.trajectories.front().states[t].modes;
    if (before != now) next.revised.push_back({times_[t], before, now});
  }
  history_ = std::move(next);
}

/// Of several readings of one attribute at the start the last counts.
void LogEstimator::take_in(const automata::Observation& observation) {
  for (const automata::Assignment& reading : observation) {
    std::erase_if(at_start_, [&](const automata::Assignment& known) { return known.variable == reading.variable; });
    at_start_.push_back(reading);
  }
  std::sort(at_start_.begin(), at_start_.end());
}

/// The pointer stays in use, so that nothing counts as lost.
void LogEstimator::give_up() { [[gnu::used]] static const Estimator* given_up = estimator_.release(); }

}  // namespace rmpl::runtime
