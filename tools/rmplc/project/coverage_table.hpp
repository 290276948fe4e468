// How much of what there is flights and traces have come to.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "runtime/report/coverage.hpp"

namespace rmpl::tools {

struct CoverageCount {
  runtime::CoverageItem::Kind kind;
  std::size_t touched = 0, all = 0;

  /// `modes`, `transitions`, `faults`, `locations`.
  [[nodiscard]] std::string plural() const { return runtime::to_string(kind) + std::string("s"); }
};

/// One for each kind, in the order of the kinds.
std::vector<CoverageCount> count_coverage(const std::vector<runtime::CoverageItem>& items);

}  // namespace rmpl::tools
