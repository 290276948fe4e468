// Violations of properties of a program: for each property what to look for, and the searches for it.
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <tuple>
#include <vector>

#include "verifier/closed_loop/evidence.hpp"
#include "verifier/closed_loop/step_memory.hpp"
#include "verifier/property/property.hpp"
#include "verifier/verdict/answer.hpp"

namespace rmpl::verifier {

/// The properties, all of which are to be asked of a program.
std::vector<ProgramProperty> of_programs(const std::vector<Property>& properties);

/// All searches in one closed loop. What one of them has worked out the next ones find done: plans, cycles, and what
/// follows a state, where they leave the same things free.
class Searches {
 public:
  /// `program` is bound to the plant of `step`. Keeps references. Throws base::InputError where `options.from` gives
  /// modes in which no state to start in is possible.
  Searches(const automata::Program& program, automata::PlantStep& step, const std::vector<ProgramProperty>& properties,
           const CheckOptions& options, const Limits& limits);

  /// How many faults may happen in all from now on. None before.
  void allow_faults(unsigned faults);
  /// Whether there is no state to start in. Throws LimitReached, as all that follows.
  bool startless();

  /// The first run found that violates the property.
  std::optional<Witness> violation(const ProgramProperty& property, const FaultFilter& only);
  /// `shown` is what the witness is to show, where it is a property.
  std::optional<Witness> search(const Query& query, const ProgramProperty* shown = nullptr);
  /// A run that goes round for ever without the program ending, or without what the query waits for.
  std::optional<Witness> lasso(Query query, const ProgramProperty& shown);
  /// Whether the formula holds at a state: the store implies it, or (not `certain`) allows it.
  std::function<bool(const LoopState&)> holds(const automata::Formula& formula, bool certain);

  /// How runs have been seen to be cut off since `forget_seen`.
  [[nodiscard]] const CutOff& cut_off() const { return cut_off_; }
  /// Of the last violation, where they are asked for.
  [[nodiscard]] const std::vector<CutSet>& cut_sets() const { return cut_sets_; }
  void forget_seen();
  [[nodiscard]] Progress progress() const { return meter_.progress(); }

 private:
  std::optional<Witness> at_a_moment(Query query, const ProgramProperty& property);
  std::optional<Witness> what_does_not_come(Query query, const ProgramProperty& property);
  std::optional<Witness> search_cut_sets(ProgramSystem& system, const Query& query, const ProgramProperty* shown);
  void remember(ProgramSystem& system, const Query& query, const ProgramProperty* shown);
  void see(const ProgramSystem& system);
  const std::vector<LoopState>& start();

  automata::PlantStep& step_;
  const CheckOptions& options_;
  Meter meter_;
  std::shared_ptr<const runtime::NominalGraph> graph_;
  std::unique_ptr<runtime::Reconfigurer> reconfigurer_;
  Loop loop_;
  Evidence evidence_;
  std::optional<std::vector<LoopState>> start_;
  StepMemory::Room room_;
  /// By what searches have in common: the property, where it has a stopwatch; how faults are marked; the clock of
  /// progress.
  std::map<std::tuple<const ProgramProperty*, bool, bool>, StepMemory> memories_;
  std::vector<CutSet> cut_sets_;
  CutOff cut_off_;
};

}  // namespace rmpl::verifier
