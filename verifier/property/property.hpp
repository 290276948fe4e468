// What can be asked of a plant, and of a program that controls one (semantics 7).
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "automata/logic/formula.hpp"
#include "automata/time/time.hpp"
#include "verifier/property/commands.hpp"

namespace rmpl::verifier {

/// The absolute times at which a target counts, both ends included.
struct Window {
  std::optional<automata::Ticks> not_before;
  std::optional<automata::Ticks> by;
  /// Whether every time counts.
  [[nodiscard]] bool is_all() const { return !not_before && !by; }
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
/// run that is stuck violates nothing; one on which time stands still and `then` never comes does.
struct Response {
  automata::Formula after;
  automata::Formula then;
  automata::Ticks within;
};

/// On every run something can follow, and time passes.
struct Stuck {};

/// What is asked of a program.
struct ProgramProperty {
  enum class Kind {
    goal_conflict,  ///< no cycle asserts goals that contradict each other
    no_plan,        ///< no goal is without a plan
    endless_wait,   ///< no wait lasts for ever
    termination,    ///< the program ends on every run
    stuck,          ///< on every run something can follow, and time passes, as long as the program runs
    undone,         ///< no command for reward takes away what a goal achieved
    never,          ///< `formula` does not hold while the program runs or as it ends
    eventually,     ///< `formula` holds at some time up to `within`, on every run
    response,       ///< each time `formula` holds while the program runs, `then` holds at most `within` later
    finally         ///< `formula` holds where the program ends
  };
  Kind kind;
  automata::Formula formula = automata::constant(true);
  automata::Ticks within = {};
  std::string text = {};  ///< the formula as written
  automata::Formula then = automata::constant(true);
  std::string then_text = {};  ///< `then` as written
  Window window = {};          ///< of `never`: when the formula counts
  bool fastest = false;        ///< of what is violated at one moment: the witness is to take the least time
  /// It only warns: of all answers together it says nothing.
  bool warning = false;
};

/// What every program should have, in the order in which it is told.
inline constexpr std::array general_kinds = {ProgramProperty::Kind::goal_conflict, ProgramProperty::Kind::no_plan,
                                             ProgramProperty::Kind::endless_wait,  ProgramProperty::Kind::termination,
                                             ProgramProperty::Kind::stuck,         ProgramProperty::Kind::undone};

/// The last one is asked of a program with its plant, the others of a plant alone.
using Property = std::variant<Reachability, Safety, Response, Stuck, ProgramProperty>;

/// `goal-conflict`, `no-plan`, `endless-wait`, `termination`, `stuck`, `undone`, `never`, `eventually`, `response`,
/// `finally`.
std::string_view name_of(ProgramProperty::Kind kind);
/// `reachability`, `safety`, `response`, `stuck`, or the name of what is asked of a program.
std::string name_of(const Property& property);
/// What it says of states, each formula once; `true` where it says nothing.
std::vector<automata::Formula> formulas_of(const Property& property);

/// What is free in a check.
struct CheckOptions {
  std::optional<automata::Ticks> period;  ///< sampled time, above 0; none: dense
  std::optional<unsigned> faults = 0;     ///< none only with `fewest_faults`
  Commands commands = Commands::one;      ///< of a plant alone: under a program they are the executive's
  /// A formula over attributes holds at a state where the store allows it; with this, where the store implies it. A
  /// response is then missed only where the store refutes `then`; otherwise already where it does not imply it.
  bool entailed = false;
  /// With the least number of faults that leads to a witness; `faults` is then the most that is tried, none: any
  /// number.
  bool fewest_faults = false;
  /// All minimal sets of faults that lead to a witness, with no more than `faults` faults.
  bool cut_sets = false;
  /// Of states that are alike but for the names of like components, one is explored. No verdict depends on it.
  bool symmetry = true;
  /// What has nothing to do with the question is left alone, where that decides it. No verdict depends on it.
  bool slice = true;
  /// Parts of a target that have nothing to do with each other are searched as one until there are so many states, and
  /// then each by itself (plant/meeting.hpp). No verdict depends on it.
  std::size_t states_as_one = 4096;
  /// Beyond so many states of so many components a plan is tried, where the question names no times: its run is an
  /// answer, though there may be a shorter one. Few components are searched sooner than planned for.
  std::size_t states_before_plan = 4096;
  std::size_t components_for_plan = 32;
  /// States are put together where they are one set cut in pieces. No verdict depends on it.
  bool merge = true;
  /// States that differ only in what time alone has led timers to are one (plant/folds.hpp). No verdict depends on it.
  bool fold = true;
  /// Modes to start in, all clocks 0, in place of the initial distribution of their components.
  std::vector<automata::Assignment> from;
};

/// What a search may cost, as it was asked; nothing set is no limit.
struct Bounds {
  std::optional<std::size_t> states;
  std::optional<automata::Ticks> time;
  std::optional<std::size_t> bytes;
};

/// A property with what is free in it.
struct Question {
  Property property;
  CheckOptions options;
  Bounds bounds = {};
};

/// Properties of a program that are decided together.
struct ProgramQuestion {
  std::vector<Property> properties;
  CheckOptions options;
  Bounds bounds = {};
};

}  // namespace rmpl::verifier
