// An estimator that is told what was commanded and seen, update by update.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "python/model.hpp"
#include "runtime/executive/answer/log_estimator.hpp"
#include "runtime/executive/answer/marking_log_estimator.hpp"
#include "runtime/executive/trace/json_line.hpp"
#include "runtime/executive/trace/log.hpp"

namespace rmpl::python {

/// Of a plant or a model program. Lines of a log go in one by one, as JSON, and what `rmpl-run estimate` prints comes
/// out.
class Estimator {
 public:
  /// `beam`: of a model program, in place of the engine. Throws base::InputError where no start is possible, or an
  /// option has no meaning for what is estimated.
  Estimator(ModelPointer model, const runtime::LogEstimatorOptions& options, bool beam);

  /// The answer to a line; empty where the line tells changes, and none before it was whole. Throws base::InputError
  /// where it is wrong, which leaves the belief as it was; and runtime::TooManyStates, runtime::MemorySpent, which end
  /// the estimator.
  const std::string& update(const std::string& line);

  /// Of a model program the names of its variables; of a plant nothing.
  [[nodiscard]] const std::optional<std::vector<std::string>>& variables() const { return variables_; }

 private:
  void answer();

  ModelPointer model_;
  std::istringstream input_;
  std::optional<runtime::LogReader> reader_;
  std::optional<runtime::LogEstimator> plant_;            ///< this one
  std::optional<runtime::MarkingLogEstimator> markings_;  ///< or this
  std::optional<std::vector<std::string>> variables_;
  bool stats_;
  runtime::LogLine line_;
  runtime::AnswerWriter writer_;
  runtime::JsonLine json_;
  bool spent_ = false;
};

}  // namespace rmpl::python
