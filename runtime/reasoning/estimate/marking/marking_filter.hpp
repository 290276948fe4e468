// What keeps the belief of one group of threads of a model program (compare filter.hpp and conditioning.hpp).
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "automata/step/marking_stages.hpp"
#include "automata/step/marking_step.hpp"
#include "runtime/reasoning/estimate/marking/marking_estimator.hpp"
#include "runtime/reasoning/estimate/set_aside.hpp"

namespace rmpl::runtime {

/// By number of the filter's step.
struct NumberedEntry {
  automata::MarkingStep::Number marking = 0;
  double probability = 0;
};
using NumberedBelief = std::vector<NumberedEntry>;
/// The same by primitive locations of the group.
using GroupBelief = std::vector<std::pair<automata::Marking, double>>;

class MarkingFilter {
 public:
  /// As the options say. Keeps a reference to the program.
  MarkingFilter(const automata::ModelProgram& program, const MarkingOptions& options);

  /// The initial belief given what is seen. Readings that nothing explains are set aside: a smallest set, of several
  /// the first in order.
  Conditioned start(const automata::Observation& observation);
  /// The belief after a step, likewise; all readings are set aside where no marking is possible, and the belief stays.
  Conditioned update(const automata::Command& command, const automata::Observation& observation);
  /// Goes on from what is best of another belief, normalised, by primitive locations; `missing` as in `missing_total`.
  void resume(const GroupBelief& belief, double missing);

  [[nodiscard]] const NumberedBelief& belief() const { return belief_; }
  [[nodiscard]] GroupBelief by_marking() const;
  [[nodiscard]] automata::MarkingStep& step() { return step_; }
  [[nodiscard]] bool cut() const { return cut_; }
  [[nodiscard]] std::size_t checked() const { return checked_; }
  /// As in `MarkingEstimate`; the first of what was adopted last.
  [[nodiscard]] double missing_mass() const { return missing_mass_; }
  [[nodiscard]] double missing_total() const;

 private:
  [[nodiscard]] bool exact() const { return options_.kind == MarkingOptions::Kind::exact; }
  void forget();
  bool few_ways(std::size_t most);
  void add(automata::MarkingStep::Number marking, double probability);
  bool sum();
  void add_all();
  bool add_stages(const std::vector<automata::MarkingStages::Place>& begins, const std::vector<double>& weights);
  void add_listed();
  void weigh(automata::MarkingStep::Number marking, double prior);
  bool work_out(const automata::Observation& observation);
  bool explains(const automata::Observation& readings);
  std::optional<automata::Observation> to_set_aside(const automata::Observation& observation);
  void adopt();
  void keep_best();
  [[nodiscard]] double greatest_factor() const;

  MarkingOptions options_;
  automata::MarkingStep step_;
  automata::MarkingStages stages_;
  std::vector<bool> told_of_;  ///< by variable: whether any location or constraint speaks of it
  NumberedBelief belief_;
  NumberedBelief next_;
  std::vector<double> way_;                             ///< by place of the stages; 0 between updates
  std::vector<double> prior_;                           ///< by number; 0 between updates
  std::vector<automata::MarkingStep::Number> reached_;  ///< whose prior is positive
  automata::Observation seen_;
  double lost_ = 0, kept_ = 1;  ///< of what was worked out last: what it is worth
  bool weighed_ = false;        ///< what was worked out last, with the readings
  bool summed_ = false;         ///< it was summed, so that `reached_` has all that is predicted
  double missing_mass_ = 0;
  double missing_ratio_ = 0;  ///< what was not kept since the start, at most, by what was
  bool cut_ = false;
  std::size_t checked_ = 0;
};

}  // namespace rmpl::runtime
