// rmpl-run estimate over a model program: beliefs over markings, and what most likely happened.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "automata/phca.hpp"
#include "runtime/reasoning/estimate/marking/marking_estimator.hpp"
#include "tools/rmpl-run/log_options.hpp"
#include "tools/shared/options.hpp"

namespace rmpl::tools {

struct ModelEstimateOptions {
  std::string model;  ///< paths, for messages
  std::string log;
  LogOptions reading;
  runtime::MarkingOptions estimator;
  bool text = false;  ///< for people, with the source of what is marked, in place of JSON
  bool stats = false;
  bool quiet = false;
};

/// Answers a log. Throws base::InputError where an input is wrong or no start is consistent, runtime::TooManyStates.
ExitStatus estimate_model(const automata::ModelProgram& program, const ModelEstimateOptions& options);

}  // namespace rmpl::tools
