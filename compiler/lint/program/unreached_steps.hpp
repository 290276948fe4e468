// Steps of which what comes before never ends, by where the locations stand that may be marked.
// SPDX-License-Identifier: MIT
#pragma once

#include <map>

#include "compiler/lint/lint.hpp"

namespace rmpl::compiler {

/// Where locations stand in the text, and whether one that stands there may be marked.
using MarkedSpans = std::map<grammar::Span, bool>;

/// Reports the first step of each sequence none of whose locations may be marked, where the step before has one.
void report_unreached_steps(const LintInput& input, const MarkedSpans& marked, grammar::Diagnostics& found);

}  // namespace rmpl::compiler
