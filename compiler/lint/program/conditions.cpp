// Conditions of programs that decide nothing: they never hold, always hold, or speak of what is never reached.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include "automata/assignment_text.hpp"
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
    if (bound_.plant == nullptr) return {Verdict::open, &condition, {}, {}};
    if (!reach_) reach_.emplace(*bound_.plant, bound_.also);
    std::string unreached = unreached_modes(condition.formula);
    if (unreached.empty() || possible_.can_hold(automata::conjunction({condition.formula, reach_->formula()}))) {
      return {Verdict::open, &condition, {}, {}};
    }
    return {Verdict::out_of_reach, &condition, {}, std::move(unreached)};
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
                                text + " speaks of what the plant cannot reach: " + never);
    finding.suggestion = judged.unreached + ": no transition leads there from the initial modes";
    return;
  }
  const bool holds = judged.verdict == Verdict::always;
  auto& finding = add_finding(found, holds ? Code::condition_always_holds : Code::condition_never_holds, span,
                              text + (holds ? " always holds: " : " can never hold: ") + (holds ? always : never));
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
