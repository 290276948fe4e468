// The properties that can be asked of a plant, and what is answered (semantics 7).
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "automata/logic/formula.hpp"
#include "automata/step/plant_step.hpp"
#include "verifier/plant/commands.hpp"
#include "verifier/plant/fault_sets.hpp"
#include "verifier/search/limits.hpp"
#include "verifier/witness/trace.hpp"

namespace rmpl::verifier {

/// The absolute times at which a target counts, both ends included.
struct Window {
  std::optional<automata::Ticks> not_before;
  std::optional<automata::Ticks> by;
};

/// Some run comes to a state in which `target` holds. In sampled time the states are those at multiples of the period.
struct Reachability {
  automata::Formula target;
  Window window;
  bool fastest = false;  ///< the witness is to take the least time, not the fewest steps
};

/// No run comes to a state in which `never` holds.
struct Safety {
  automata::Formula never;
  Window window;
  bool fastest = false;
};

/// On every run, whenever `after` holds, `then` holds at some time at most `within` later, that time itself included. A
/// run on which time comes to a stop violates nothing.
struct Response {
  automata::Formula after;
  automata::Formula then;
  automata::Ticks within;
};

using Property = std::variant<Reachability, Safety, Response>;

/// `reachability`, `safety`, `response`.
std::string name_of(const Property& property);

/// What is free in a check.
struct CheckOptions {
  std::optional<automata::Ticks> period;  ///< sampled time, above 0; none: dense
  std::optional<unsigned> faults = 0;     ///< none only with `fewest_faults`
  Commands commands = Commands::one;
  /// A formula over attributes holds at a state where the store allows it; with this, where the store implies it. A
  /// response is then missed only where the store refutes `then`; otherwise already where it does not imply it.
  bool entailed = false;
  /// With the least number of faults that leads to a trace; `faults` is then the most that is tried, none: any number.
  bool fewest_faults = false;
  /// All minimal sets of faults that lead to a trace, with no more than `faults` faults.
  bool cut_sets = false;
  /// Of states that are alike but for the names of like components, one is explored. No verdict depends on it.
  bool symmetry = true;
  /// How many threads explore, 1 or more. No result depends on it.
  unsigned threads = 1;
  /// Modes to start in, all clocks 0, in place of the initial distribution of their components.
  std::vector<automata::Assignment> from;
};

/// A minimal set of faults, with a trace that has them and no others.
struct FaultTrace {
  std::vector<Fault> faults;
  Trace trace;
};

/// Throws base::InputError where `from` names what is no mode of a component, or one component twice.
void demand_modes(const automata::Plant& plant, const std::vector<automata::Assignment>& from);
/// Throws base::InputError: `from` gives modes in which no state to start in is possible.
[[noreturn]] void refuse_start();

enum class Verdict { holds, violated, undecided };

struct Result {
  Verdict verdict = Verdict::undecided;
  std::optional<Trace> trace;             ///< a witness of reachability, a counterexample of the others
  std::optional<unsigned> fewest_faults;  ///< those of the trace, where they were asked for and there is one
  std::vector<FaultTrace> cut_sets;       ///< where they were asked for; smallest first
  /// Why it is undecided; or, beside a trace, why a better one (fewer steps, or less time) may have been missed.
  std::optional<Limit> limit;
  /// No initial state is possible (semantics 3), so that nothing is reachable: the verdict says nothing of the plant.
  bool startless = false;
  Progress progress;
};

/// Checks one property. Every trace has been replayed. Throws base::InputError where `from` names what is no mode,
/// or contradicts itself, or gives modes in which no state to start in is possible.
Result check(automata::PlantStep& step, const Property& property, const CheckOptions& options, const Limits& limits);

}  // namespace rmpl::verifier
