// Conditions of programs that decide nothing: they never hold, always hold, or speak of what is never reached.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include "automata/assignment_text.hpp"
#include "automata/controls.hpp"
#include "automata/logic/given.hpp"
#include "base/product.hpp"
#include "compiler/check/vocabulary.hpp"
#include "compiler/lint/program/bound_programs.hpp"
#include "compiler/lint/program/consequences.hpp"
#include "compiler/lint/program/passes.hpp"
#include "compiler/lint/program/possibilities.hpp"
#include "compiler/lint/program/reachable_modes.hpp"

namespace rmpl::compiler {

using automata::Assignment;
using automata::Formula;
using grammar::Code;

namespace {

enum class Verdict { open, never, always, out_of_reach };

/// What can be said of a condition in all its expansions, in all programs; `open` where they differ.
struct Judged {
  Verdict verdict = Verdict::open;
  const PlacedCondition* condition = nullptr;
  std::vector<automata::Origin> blamed;
  std::string unreached;
  std::string commanded = {};  ///< of what never holds: the control that it speaks of, and that no state determines
};

class Judge {
 public:
  explicit Judge(const BoundProgram& bound)
      : bound_(bound), possible_(bound.program.variables, bound.plant), consistent_(possible_.consistent()) {}

  Judged operator()(const PlacedCondition& condition) {
    // A constant is meant as it stands.
    if (!consistent_ || condition.formula.kind == Formula::Kind::constant) return {Verdict::open, &condition, {}, {}};
    if (!possible_.can_hold(condition.formula)) {
      return {Verdict::never, &condition, possible_.blame(condition.formula), {}};
    }
    if (!possible_.can_fail(condition.formula)) {
      return {Verdict::always, &condition, possible_.blame(negation(condition.formula)), {}};
    }
    if (std::string control = undetermined(condition.formula); !control.empty()) {
      return {Verdict::never, &condition, {}, {}, std::move(control)};
    }
    if (bound_.plant == nullptr) return {Verdict::open, &condition, {}, {}};
    if (!reach_) reach_.emplace(*bound_.plant, bound_.also);
    std::string unreached = unreached_modes(condition.formula);
    if (unreached.empty() || possible_.can_hold(automata::conjunction({condition.formula, reach_->formula()}))) {
      return {Verdict::open, &condition, {}, {}};
    }
    return {Verdict::out_of_reach, &condition, {}, std::move(unreached)};
  }

  /// A control for which a formula is implied in no state, whatever else holds: what is in force is no part of what a
  /// program knows, and nothing in the model or of what is read determines it. Empty where there is none.
  std::string undetermined(const Formula& formula) {
    if (bound_.plant == nullptr) return {};
    constexpr std::size_t most = 256;
    std::vector<std::vector<Assignment>> values;
    std::size_t combinations = 1;
    for (const automata::VariableId variable : variables_of(formula)) {
      if (!is_control(*bound_.plant, variable) || is_constrained(variable)) continue;
      auto& own = values.emplace_back();
      for (std::size_t v = 0; v < bound_.plant->variables[variable].values.size(); ++v) {
        own.push_back({variable, automata::ValueId(v)});
      }
      combinations *= own.size();
      if (combinations > most) return {};
    }
    if (values.empty()) return {};
    std::vector<Formula> all;
    base::for_each_combination(values, [&](const std::vector<Assignment>& command) {
      all.push_back(automata::with_values(formula, command));
    });
    if (possible_.can_hold(automata::conjunction(std::move(all)))) return {};
    return bound_.plant->variables.name(values.front().front().variable);
  }

  /// Whether a sensor reads the variable, or something in the model says of it.
  [[nodiscard]] bool is_constrained(automata::VariableId variable) const {
    const auto speaks = [&](const Formula& formula) {
      const auto variables = variables_of(formula);
      return std::binary_search(variables.begin(), variables.end(), variable);
    };
    const automata::Plant& plant = *bound_.plant;
    const auto& seen = plant.observables;
    return std::find(seen.begin(), seen.end(), variable) != seen.end() ||
           std::any_of(plant.interconnections.begin(), plant.interconnections.end(),
                       [&](const auto& q) { return speaks(q.constraint); }) ||
           std::any_of(plant.components.begin(), plant.components.end(), [&](const automata::Component& component) {
             return std::any_of(component.modes.begin(), component.modes.end(),
                                [&](const automata::Mode& mode) { return speaks(mode.constraint); });
           });
  }

  /// The modes that a formula speaks of, or that stand for what it speaks of, and that are never reached.
  std::string unreached_modes(const Formula& formula) {
    std::string text;
    for (const automata::VariableId variable : variables_of(formula)) {
      const auto component = bound_.plant->component_of(variable);
      if (!component) continue;
      const automata::Component& read = (*bound_.plant)[*component];
      for (std::size_t m = 0; m < read.modes.size(); ++m) {
        if (reach_->reached({variable, automata::ValueId(m)})) continue;
        text += (text.empty() ? "" : ", ") + backquoted(to_text(read, automata::ModeId(m)));
      }
    }
    return text;
  }

 private:
  const BoundProgram& bound_;
  Possibilities possible_;
  bool consistent_;
  std::optional<ReachableModes> reach_;
};

void report(const LintInput& input, grammar::Span span, const Judged& judged, grammar::Diagnostics& found) {
  const auto [never, always] = consequences_of(judged.condition->construct);
  const std::string text = backquoted(input.sources.text(span));
  if (judged.verdict == Verdict::out_of_reach) {
    auto& finding = add_finding(found, Code::condition_out_of_reach, span,
                                text + " holds in no state that the plant can reach: " + never);
    finding.suggestion = judged.unreached + ": no transitions lead there from the initial modes";
    return;
  }
  const bool holds = judged.verdict == Verdict::always;
  auto& finding = add_finding(found, holds ? Code::condition_always_holds : Code::condition_never_holds, span,
                              text + (holds ? " always holds: " : " can never hold: ") + (holds ? always : never));
  if (!judged.commanded.empty()) {
    finding.suggestion =
        backquoted(judged.commanded) +
        " is a control, and a program reads only modes and sensors: ask for the mode that the command leads to";
  }
  constexpr std::size_t shown = 4;
  for (std::size_t b = 0; b < std::min(shown, judged.blamed.size()); ++b) {
    finding.notes.push_back({input.places.at(judged.blamed[b]), holds ? "this makes it hold" : "this contradicts it"});
  }
}

}  // namespace

void lint_conditions(const LintInput& input, grammar::Diagnostics& found) {
  std::map<grammar::Span, Judged> judged;
  for (const BoundProgram& bound : bound_programs(input)) {
    if (bound.places.conditions.empty()) continue;
    Judge judge(bound);
    for (const PlacedCondition& condition : bound.places.conditions) {
      const auto known = judged.find(condition.span);
      if (known != judged.end() && known->second.verdict == Verdict::open) continue;
      Judged one = judge(condition);
      if (known == judged.end()) {
        judged.emplace(condition.span, std::move(one));
      } else if (known->second.verdict != one.verdict) {
        known->second.verdict = Verdict::open;
      }
    }
  }
  for (const auto& [span, one] : judged) {
    if (one.verdict != Verdict::open) report(input, span, one, found);
  }
}

}  // namespace rmpl::compiler
