// Counting by kind.
// SPDX-License-Identifier: MIT
#include "tools/rmplc/project/coverage_table.hpp"

namespace rmpl::tools {

std::vector<CoverageCount> count_coverage(const std::vector<runtime::CoverageItem>& items) {
  using Kind = runtime::CoverageItem::Kind;
  std::vector<CoverageCount> counts;
  for (const Kind kind : {Kind::mode, Kind::transition, Kind::fault, Kind::location}) {
    CoverageCount& count = counts.emplace_back(CoverageCount{kind, 0, 0});
    for (const runtime::CoverageItem& item : items) {
      if (item.kind != kind) continue;
      ++count.all;
      if (item.runs > 0) ++count.touched;
    }
  }
  return counts;
}

}  // namespace rmpl::tools
