// An estimator for replay: it returns the estimates that a trace lists.
// SPDX-License-Identifier: MIT
#pragma once

#include <utility>

#include "runtime/reasoning/estimate/estimator.hpp"

namespace rmpl::runtime {

/// `set` gives it each cycle. Without a belief, the estimate is certain.
class ToldEstimator final : public Estimator {
 public:
  void set(const automata::Modes& modes, const automata::Observation& set_aside, Belief belief) {
    belief_ = std::move(belief);
    estimate_.modes = modes;
    estimate_.set_aside = set_aside;
    estimate_.consistent = set_aside.empty();
    estimate_.probability = probability_of(modes);
  }
  const Estimate& start(const automata::Observation&) override { return estimate_; }
  const Estimate& update(const automata::ControlAction&, const automata::Observation&, automata::Ticks) override {
    return estimate_;
  }
  [[nodiscard]] const Belief& belief() const override { return belief_; }
  [[nodiscard]] const Estimate& estimate() const override { return estimate_; }
  [[nodiscard]] double probability_of(const automata::Modes& modes) const override {
    double all = 0, own = 0;
    for (const BeliefEntry& entry : belief_) {
      all += entry.probability;
      if (entry.state.modes == modes) own += entry.probability;
    }
    return all > 0 ? own / all : 1;
  }
  [[nodiscard]] std::size_t groups() const override { return 1; }
  [[nodiscard]] std::size_t questions() const override { return 0; }
  [[nodiscard]] std::size_t solver_calls() const override { return 0; }

 private:
  Estimate estimate_;
  Belief belief_;
};

}  // namespace rmpl::runtime
