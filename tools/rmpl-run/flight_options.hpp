// What `rmpl-run scenario` was asked for.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "automata/time/time.hpp"
#include "runtime/executive/scenario/run.hpp"
#include "runtime/executive/trace/trace_writer.hpp"
#include "tools/shared/options.hpp"

namespace rmpl::tools {

struct FlightOptions {
  std::vector<std::string> files;
  std::vector<std::string> only;      ///< names of scenarios; empty: all
  std::vector<std::string> monitors;  ///< files; empty: those of the project
  std::string trace;                  ///< paths of what is written; empty: not
  std::string junit;
  std::string report;
  std::string vcd, csv, mcap;
  std::string coverage;
  runtime::TraceDetail detail = runtime::TraceDetail::changes;
  std::uint64_t keyframe = runtime::TraceWriter::usual_keyframe;
  std::vector<std::string> components;
  automata::Ticks from;
  automata::Ticks to = automata::Ticks::infinite();
  std::optional<std::uint64_t> seed;
  std::string commands;  ///< of a model program: the list; empty: scenarios fly
  runtime::ScenarioOptions::Engine engine = runtime::ScenarioOptions::Engine::k_best;
  runtime::ScenarioOptions::Recovery recovery = runtime::ScenarioOptions::Recovery::planner;
  std::size_t k = 16;
  unsigned jobs = 1;
  bool follow = false;
  bool real_time = false;
  bool stats = false;

  /// Whether the data of the flights are wanted.
  [[nodiscard]] bool records() const { return !report.empty() || !vcd.empty() || !csv.empty() || !mcap.empty(); }
  /// Several files are told as a table; the flights of one as stories, unless nobody wants to hear them.
  [[nodiscard]] bool tells_stories(const Common& common) const {
    return common.format == Format::text && !common.quiet && (files.size() == 1 || common.verbose);
  }
};

}  // namespace rmpl::tools
