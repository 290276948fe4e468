// A log of a model program answered line by line: what was commanded and seen goes in, the belief over markings and
// what most likely happened come out. SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <cstddef>
#include <functional>
#include <memory>
#include <vector>

#include "automata/phca.hpp"
#include "runtime/executive/answer/log_estimator.hpp"
#include "runtime/executive/answer/marking_answer.hpp"
#include "runtime/executive/trace/log.hpp"
#include "runtime/reasoning/estimate/marking/marking_estimator.hpp"

namespace rmpl::runtime {

/// Whether an option is set that has a meaning for plants alone.
bool is_about_plants(const LogEstimatorOptions& options);
/// How a model program is estimated by the options of a plant; `beam` in place of the engine.
MarkingOptions marking_options(const LogEstimatorOptions& options, bool beam);

class MarkingLogEstimator {
 public:
  /// Keeps the reference to the program. `interruption`, set from outside, ends an answer; `took` is called with what
  /// an update took, in seconds. Both may be null.
  MarkingLogEstimator(const automata::ModelProgram& program, const MarkingOptions& options,
                      const std::atomic<bool>* interruption = nullptr, std::function<void(double)> took = nullptr);

  /// Whether some initial marking is possible. Where none is, nothing can be answered.
  [[nodiscard]] bool starts() const { return estimator_->estimate().possible; }

  /// Takes a line in, which is a step. What is told of it stands until the next call. Throws Interrupted,
  /// TooManyStates: what was to be worked out is lost then.
  const MarkingAnswer& answer(const LogLine& line);

  [[nodiscard]] const LogAccount& account() const { return account_; }
  [[nodiscard]] MarkingEstimator& estimator() { return *estimator_; }

 private:
  void update(const LogLine& told, automata::Ticks time);
  void tell_history(bool start);
  void take_in(const automata::Observation& observation);

  const automata::ModelProgram& program_;
  const MarkingOptions options_;
  const std::atomic<bool>* interruption_;
  std::function<void(double)> took_;
  std::unique_ptr<MarkingEstimator> estimator_;
  LogAccount account_;
  MarkingAnswer answer_;
  bool begun_ = false;  ///< a step was taken
  automata::Observation at_start_;
  LogLine before_;
  std::vector<automata::Ticks> times_{automata::Ticks{}};  ///< of what the window sets out from, and of updates since
  std::vector<automata::Marking> last_;                    ///< the most likely trajectory after the line before
  std::size_t last_first_ = 0;                             ///< the update after which that sets out
};

}  // namespace rmpl::runtime
