// The options of tcca-check program, as written: what needs a plant to be understood stays text.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tools/tcca-check/property_check.hpp"
#include "tools/tcca-check/timed_formula.hpp"
#include "verifier/property/property.hpp"

namespace rmpl::tools {

/// A property that holds for any program.
struct GeneralCheck {
  verifier::ProgramProperty::Kind kind;
  bool of_all = false;  ///< it is one of `all`, and not asked for by its name: *undone* then only warns
};

struct ProgramOptions {
  std::string program, plant;         ///< paths; the plant may be empty
  std::string entry;                  ///< the definition to start with; empty: the one that no other calls
  std::vector<GeneralCheck> general;  ///< of the properties that hold for any program
  std::vector<std::string> nevers, finallys;
  std::vector<TimedFormula> eventuallys;  ///< without a time: as `within` says
  std::vector<TimedResponse> responses;   ///< without a response: as `within` says
  std::optional<TimedFormula> within;     ///< a time for the former, a time and a response for the latter
  bool allow_stuck = false;               ///< a run that gets stuck is no violation of its own
  bool each_fault = false;
  bool fewest_faults = false;
  std::optional<unsigned> cut_sets;  ///< the most faults that such a set may hold
  WindowOptions window;
  std::string scenario;  ///< where to write a witness as a scenario; empty: nowhere
  automata::Ticks cycle = {automata::Ticks::per_second / 2};  ///< of that scenario, where time is dense
  std::string report;  ///< where to write a page to look at traces; empty: nowhere
  Freedom freedom;
  Budget budget;
  bool statistics = false;

  [[nodiscard]] std::vector<std::string> models() const;
};

void add_program_options(Command& command, ProgramOptions& options, Common& common);

}  // namespace rmpl::tools
