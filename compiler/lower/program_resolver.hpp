// Constraints of programs: parameters, clocks, goals; checked against a plant, or names as they come.
// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <optional>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

#include "automata/program.hpp"
#include "compiler/check/resolve.hpp"
#include "compiler/lower/arguments.hpp"
#include "compiler/lower/part.hpp"

namespace rmpl::compiler {

/// Why a goal does not ask what the executive knows (`Resolver::ask_of_knowledge`).
inline constexpr const char* goal_asks_no_knowledge = "in a goal: no command can achieve it";

/// Fills in the variables and clocks of a program. With a plant, the table is the plant's and every name is checked;
/// without, the table collects what is mentioned, and `x = y` takes y for a value: where y turns out to be a variable
/// of the program, `check_values` says that it cannot be told. A model program has the variables that it declares for a
/// plant, and no clocks.
class ProgramResolver final : public Resolver {
 public:
  ProgramResolver(automata::Program& program, bool model, const Part* plant, grammar::Diagnostics& diagnostics);

  /// What names stand for from now on. The environment must live as long as it is in use.
  void enter(const Environment* environment) { environment_ = environment; }
  [[nodiscard]] const Environment* environment() const { return environment_; }

  /// A goal: the conjuncts that assign a mode, and the others.
  struct Goal {
    std::vector<automata::Assignment> modes;
    std::vector<automata::Formula> constraints;
  };
  /// Any constraint over modes and attributes; `true` is the empty goal. What no command can achieve is reported.
  Goal goal(const grammar::Constraint& constraint);
  /// A clock of one expansion's own; nothing where the name is a variable of the plant, and then it has been reported.
  std::optional<automata::ClockId> own(const grammar::Name& declared, const std::string& unique);
  /// The clock that a step starts; nothing where the name is a variable of the plant, and then it has been reported.
  std::optional<automata::ClockId> start(const grammar::Name& name);
  /// Without a plant, once all is resolved: reports each `x = y` of a condition whose y is a variable or a clock, too.
  void check_values();
  /// Reports a clock of a model program.
  void report_clock(const grammar::Name& clock);
  /// What a call passes on from here.
  Passed pass(const grammar::Argument& argument);

  std::optional<automata::VariableId> variable(const grammar::Name& name) override;

 protected:
  std::optional<grammar::Name> meaning(const grammar::Name& name) override;
  automata::Formula reference(const grammar::Reference& reference) override;
  automata::Formula clock(const grammar::ClockBound& bound) override;
  std::optional<automata::ValueId> find_value(automata::VariableId variable, const std::string& value) override;
  [[nodiscard]] bool closed() const override { return plant_ != nullptr; }
  void taken_for_value(const grammar::Name& name) override;
  void annotate(grammar::Diagnostic& diagnostic) override;
  [[nodiscard]] bool lost_its_meaning(const grammar::Name& name) const override;
  [[nodiscard]] bool is_component(automata::VariableId variable) const override {
    return !closed() || modes_.contains(variable);
  }

 private:
  struct Goals {
    Goal goal;
    std::unordered_map<automata::VariableId, automata::ValueId> asked;
  };
  void add_goals(const grammar::Constraint& constraint, Goals& goals);
  void add_comparison(const grammar::Comparison& comparison, const grammar::Constraint& whole, Goals& goals);
  void add_constraint(const grammar::Constraint& constraint, Goals& goals);
  bool report_commanded(const automata::Formula& formula, const grammar::Constraint& constraint);
  [[nodiscard]] const Passed* passed(const std::string& name) const;
  /// What a clock of the expansion's own is called in the automaton; null where it has none of that name.
  [[nodiscard]] const grammar::Name* own_clock(const std::string& name) const;
  bool report_variable(const grammar::Name& clock);
  automata::ClockId clock_named(const std::string& name);

  automata::Program& program_;
  const bool model_;
  const Part* plant_;
  const Environment* environment_ = nullptr;
  std::unordered_set<automata::VariableId> modes_;  ///< of the plant
  std::unordered_map<std::string, automata::ClockId> clocks_;
  /// Without a plant: the values seen so far, so that a mention costs no walk through the domain.
  std::unordered_map<automata::VariableId, std::unordered_map<std::string, automata::ValueId>> seen_;
  std::unordered_set<automata::VariableId> overflowed_;  ///< with more values than fit
  /// Without a plant: where each variable is mentioned first, and names taken for values, by their place.
  std::unordered_map<automata::VariableId, grammar::Span> mentions_;
  std::map<std::pair<std::uint32_t, std::uint32_t>, grammar::Name> taken_for_values_;
};

}  // namespace rmpl::compiler
