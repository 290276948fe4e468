// What keeps the belief of one group of threads of a model program: the two halves of an update, so that several groups
// can agree on it (compare filter.hpp).
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "automata/step/marking_step.hpp"
#include "runtime/reasoning/estimate/marking_estimator.hpp"

namespace rmpl::runtime {

/// By number of the filter's step.
struct NumberedEntry {
  automata::MarkingStep::Number marking = 0;
  double probability = 0;
};
using NumberedBelief = std::vector<NumberedEntry>;

class MarkingFilter {
 public:
  /// Exact, or k-best. Keeps a reference to the program.
  MarkingFilter(const automata::ModelProgram& program, const MarkingOptions& options);

  /// The initial belief given what is seen; false, and the belief without it, where nothing explains that.
  bool start(const automata::Observation& observation);
  /// Works out the belief after a step; false where nothing explains the observation. The belief stays as it was until
  /// `adopt`.
  bool condition(const automata::Command& command, const automata::Observation& observation);
  /// After `condition`: works out the prediction instead; false where there is none.
  bool predict();
  /// Takes what was worked out last as the belief.
  void adopt();

  [[nodiscard]] const NumberedBelief& belief() const { return belief_; }
  [[nodiscard]] automata::MarkingStep& step() { return step_; }
  [[nodiscard]] bool cut() const { return cut_; }
  [[nodiscard]] std::size_t checked() const { return checked_; }

 private:
  void forget();
  void add(automata::MarkingStep::Number marking, double probability);
  bool sum(const NumberedBelief& sources);
  bool work_out(bool seen);
  void keep_best();

  MarkingOptions options_;
  automata::MarkingStep step_;
  NumberedBelief belief_;
  NumberedBelief next_;
  std::vector<double> prior_;                           ///< by number; 0 between updates
  std::vector<automata::MarkingStep::Number> reached_;  ///< whose prior is positive
  bool cut_ = false;
  std::size_t checked_ = 0;
};

}  // namespace rmpl::runtime
