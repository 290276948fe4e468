// What can be asked of a program that controls a plant, and what is answered (semantics 7).
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "automata/logic/formula.hpp"
#include "verifier/closed_loop/loop_trace.hpp"
#include "verifier/property/property.hpp"

namespace rmpl::verifier {

struct ProgramProperty {
  enum class Kind {
    goal_conflict,  ///< no cycle asserts goals that contradict each other
    no_plan,        ///< no goal is without a plan
    endless_wait,   ///< no wait lasts for ever
    termination,    ///< the program ends on every run
    never,          ///< `formula` does not hold while the program runs or as it ends
    eventually,     ///< `formula` holds at some time up to `within`, on every run
    finally         ///< `formula` holds where the program ends
  };
  Kind kind;
  automata::Formula formula = automata::constant(true);
  automata::Ticks within = {};
  std::string text = {};  ///< the formula as written
};

/// `goal-conflict`, `no-plan`, `endless-wait`, `termination`, `never`, `eventually`, `finally`.
std::string_view name_of(ProgramProperty::Kind kind);

struct ProgramOptions {
  std::optional<automata::Ticks> period;  ///< sampled time, above 0; none: dense
  unsigned faults = 0;
  bool entailed = false;  ///< as in `CheckOptions`
  std::vector<automata::Assignment> from = {};
};

struct ProgramAnswer {
  Verdict verdict = Verdict::undecided;
  std::optional<LoopTrace> trace = std::nullopt;  ///< of a violation
};

struct ProgramResult {
  std::vector<ProgramAnswer> answers;  ///< one a property, in order
  std::optional<Limit> limit = std::nullopt;
  bool startless = false;  ///< no initial state is possible, so that nothing can be violated
  Progress progress = {};

  /// Violated where one property is, else undecided where one is.
  [[nodiscard]] Verdict verdict() const;
};

/// What may come of a single fault, whenever it happens; or of none. Each with the soonest run on which it comes so.
struct FaultOutcome {
  std::optional<FaultStep> fault;
  std::optional<LoopTrace> happens = std::nullopt;  ///< the way to the fault; nothing where it cannot happen
  std::optional<LoopTrace> success = std::nullopt;  ///< the program ends, and every `finally` holds
  std::optional<LoopTrace> lost = std::nullopt;     ///< a property among never, eventually and finally is violated
  std::optional<LoopTrace> waits = std::nullopt;    ///< the program waits for ever
  std::optional<LoopTrace> goes_on = std::nullopt;  ///< it goes on for ever without ending
  std::optional<LoopTrace> no_plan = std::nullopt;  ///< a goal is without a plan
  bool decided = false;

  /// Whether it can lose the mission, or keep the program from ending.
  [[nodiscard]] bool fails() const { return lost || waits || goes_on; }
};

struct FaultTable {
  std::vector<FaultOutcome> rows;  ///< no fault, then every fault transition, in declaration order
  std::optional<Limit> limit = std::nullopt;
  Progress progress = {};
};

/// `program` is bound to the plant of `step`. Every trace has been replayed. Throws base::InputError where `from`
/// gives modes in which no state to start in is possible.
ProgramResult check(const automata::Program& program, automata::PlantStep& step,
                    const std::vector<ProgramProperty>& properties, const ProgramOptions& options,
                    const Limits& limits);

/// Takes every fault by itself. `properties` say what the mission is; `options.faults` is not looked at.
FaultTable check_each_fault(const automata::Program& program, automata::PlantStep& step,
                            const std::vector<ProgramProperty>& properties, const ProgramOptions& options,
                            const Limits& limits);

}  // namespace rmpl::verifier
