// The options of tcca-check program, as written: what needs a plant to be understood stays text.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tools/tcca-check/property_check.hpp"
#include "verifier/property/property.hpp"

namespace rmpl::tools {

/// A constraint that is to come true in time.
struct Promise {
  std::string constraint;
  std::optional<automata::Ticks> within;  ///< nothing: as `--within` says
};

/// What is owed each time something else holds.
struct Answered {
  std::string asks;
  automata::Ticks within;
  std::string then;
};

/// A property that holds for any program; as part of `all` *undone* only warns.
struct GeneralCheck {
  verifier::ProgramProperty::Kind kind;
  bool warning = false;
};

struct ProgramOptions {
  std::string program, plant;         ///< paths; the plant may be empty
  std::string entry;                  ///< the definition to start with; empty: the one that no other calls
  std::vector<GeneralCheck> general;  ///< of the properties that hold for any program
  std::vector<std::string> nevers, finallys;
  std::vector<Promise> eventuallys;
  std::vector<Answered> responses;
  std::optional<automata::Ticks> within;
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

void add_program_options(CLI::App& command, ProgramOptions& options, Common& common);

}  // namespace rmpl::tools
