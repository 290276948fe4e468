// Told: conditions that no store entails, and such as every store does.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include "compiler/check/vocabulary.hpp"
#include "compiler/lint/model_program/report.hpp"
#include "compiler/lint/program/consequences.hpp"

namespace rmpl::compiler {

using automata::Formula;
using automata::LocationId;
using grammar::Code;
using grammar::Span;

namespace {

enum class Verdict { open, never, always };

struct Judged {
  Verdict verdict = Verdict::open;
  const PlacedCondition* condition = nullptr;
};

/// Whether the construct that a condition belongs to, the closest one around it, may be marked.
bool is_reached(ModelReport& report, Span condition) {
  std::optional<Span> closest;
  bool reached = false;
  for (std::size_t l = 0; l < report.program().locations.size(); ++l) {
    const Span span = report.span_of(LocationId(l));
    const bool around = span.file == condition.file && span.begin <= condition.begin && span.end >= condition.end;
    if (!around || (closest && span.end - span.begin > closest->end - closest->begin)) continue;
    if (span != closest) reached = false;
    closest = span;
    reached = reached || report.reachable()[l];
  }
  return reached || !closest;
}

/// The first variable of a formula that nothing is told of.
std::optional<automata::VariableId> untold_variable(ModelReport& report, const Formula& formula) {
  for (const automata::VariableId v : variables_of(formula)) {
    if (!report.stores().is_spoken_of(v)) return v;
  }
  return std::nullopt;
}

bool is_seen(const ModelReport& report, automata::VariableId variable) {
  const auto& seen = report.program().observables;
  return std::find(seen.begin(), seen.end(), variable) != seen.end();
}

/// Says why nothing entails it; a note, where a plant that holds the program may be what is to tell. Asks of what is
/// never marked, too: for the report of a judgement that stands.
void explain_never(ModelReport& report, const Formula& formula, grammar::Diagnostic& finding) {
  if (const auto variable = untold_variable(report, formula)) {
    std::string reason = "the program tells nothing about " + backquoted(report.program().variables.name(*variable));
    const bool is_plant = report.places().locations.empty();
    if (is_seen(report, *variable)) {
      reason += ": an observation does not make a guard true";
    } else if (!is_plant) {
      reason += "; a plant that contains this program may connect it";
      finding.severity = grammar::Severity::note;
    }
    finding.suggestion = std::move(reason);
    return;
  }
  const std::vector<bool> all(report.program().locations.size(), true);
  finding.suggestion =
      report.stores().freedom({true, formula}, all).may_hold
          ? "the constraints that would entail it are told only after this condition, or in unreachable locations"
          : "no told constraint entails it";
}

}  // namespace

void report_conditions(ModelReport& report) {
  std::map<Span, Judged> judged;
  for (const PlacedCondition& condition : report.places().conditions) {
    Judged one{Verdict::open, &condition};
    if (condition.formula.kind != Formula::Kind::constant) {  // a constant is meant as it stands
      const Freedom free = report.stores().freedom({true, condition.formula}, report.reachable());
      if (!free.may_hold) one.verdict = Verdict::never;
      if (!free.may_fail) one.verdict = Verdict::always;
    }
    const auto [known, fresh] = judged.emplace(condition.span, one);
    if (!fresh && known->second.verdict != one.verdict) known->second.verdict = Verdict::open;
  }
  for (const auto& [span, one] : judged) {
    if (one.verdict == Verdict::open || !is_reached(report, span)) continue;
    const bool always = one.verdict == Verdict::always;
    const Consequences consequences = consequences_of(one.condition->construct, true);
    auto& finding =
        report.add(always ? Code::condition_always_holds : Code::condition_never_holds, span,
                   backquoted(report.input().sources.text(span)) + (always ? " always holds: " : " can never hold: ") +
                       (always ? consequences.always : consequences.never));
    if (always) {
      finding.suggestion = "the constraints of the program entail it";
    } else {
      explain_never(report, one.condition->formula, finding);
    }
  }
}

}  // namespace rmpl::compiler
