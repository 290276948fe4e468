// An expectation that is asked anew once it was met.
// SPDX-License-Identifier: MIT
#include "runtime/executive/step/stepped_run.hpp"

#include <utility>

namespace rmpl::runtime {

Watch::Watch(SteppedRun& run, automata::Formula formula, bool truth) : run_(run) {
  automata::Expectation expectation;
  expectation.truth = truth;
  expectation.condition = std::move(formula);
  asked_.expectations.push_back(std::move(expectation));
}

bool Watch::holds(const CycleRecord& record, bool ended) {
  if (!expectations_) expectations_.emplace(run_.plant(), run_.theory(), run_.program(), asked_);
  expectations_->observe(record, ended);
  const bool met = expectations_->judgements().front().verdict == Judgement::Verdict::met;
  if (met) expectations_.reset();
  return met;
}

}  // namespace rmpl::runtime
