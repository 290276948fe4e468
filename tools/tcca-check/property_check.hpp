// One property of a plant: its options, its check, its answer. For reachability, safety, response and stuck.
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "tools/tcca-check/check_options.hpp"

namespace rmpl::tools {

struct PropertyOptions {
  std::string model;
  std::string main;  ///< the definition that a model program starts with; empty: the one that no other calls
  Freedom freedom;
  Budget budget;
  verifier::Commands commands = verifier::Commands::one;
  bool fewest_faults = false;
  std::optional<unsigned> cut_sets;  ///< the most faults that such a set may hold
  bool no_symmetry = false;
  bool statistics = false;
  std::string report;  ///< where to write a page to look at traces; empty: nowhere
};

/// What is asked: whether a formula holds somewhere, or for any dead end, of which one is enough.
enum class Asked { formula, dead_end };
void add_property_options(Command& command, PropertyOptions& options, Common& common, Asked asked = Asked::formula);

/// When a formula counts, and which trace is wanted.
struct WindowOptions {
  verifier::Window window;
  bool fastest = false;
};
void add_window(Command& command, WindowOptions& options);
/// With `period`, of a search in steps of that length. Throws base::InputError where no time, or the end of no step, is
/// in the window: whatever is asked about it would hold.
void check_window(const verifier::Window& window, std::optional<automata::Ticks> period);

/// What is asked of `within inf` is violated by runs without end, which are no way to a state.
inline constexpr const char* no_cut_sets_of_some_day =
    "--cut-sets: what may come some day (within inf) has none, as a run without end is no way to a state; give a "
    "finite "
    "time, or ask with --fewest-faults";

/// The period of the steps that was asked for; else that of a plant that has no other reading of time.
std::optional<automata::Ticks> period_of(const Freedom& freedom, const automata::Plant& plant);

/// Checks the property that `ask` makes of the plant, and prints the answer. `title` is the property as it was asked.
/// Throws base::InputError, base::LimitError and Rejected.
ExitStatus check_property(const PropertyOptions& options, const Common& common, const std::string& title,
                          const std::function<verifier::Property(const automata::Plant&)>& ask);

}  // namespace rmpl::tools
