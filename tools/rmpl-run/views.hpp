// The views of one flight: a page, and files for tools of others.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "runtime/report/flight.hpp"
#include "runtime/report/page.hpp"
#include "tools/shared/options.hpp"

namespace rmpl::tools {

/// Where to write what; empty: not.
struct ViewPaths {
  std::string report, vcd, csv, mcap;

  [[nodiscard]] bool any() const { return !report.empty() || !vcd.empty() || !csv.empty() || !mcap.empty(); }
};

/// `--report`, `--vcd`, `--csv` and `--mcap`.
void add_views(Command& command, ViewPaths& paths);

class Views {
 public:
  /// Throws base::InputError where one of them cannot be written. Keeps references to plant and program.
  Views(const ViewPaths& paths, const automata::Plant& plant, const automata::Program& program);

  /// Writes each anew, as a whole. The page has its drawings from the first time on; one that there cannot be is told
  /// once on standard error, unless `quiet`. Throws base::InputError.
  void write(const runtime::Flight& flight, bool quiet);

 private:
  ViewPaths paths_;
  const automata::Plant& plant_;
  const automata::Program& program_;
  std::optional<runtime::Drawings> drawings_;
};

}  // namespace rmpl::tools
