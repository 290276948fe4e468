// Told: conditions that no store entails, and such as every store does.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <map>
#include <optional>
#include <string>

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

/// Why nothing entails it. Asks of what is never marked, too: for the report of a judgement that stands.
std::string reason(ModelReport& report, const Formula& formula) {
  for (const automata::VariableId v : variables_of(formula)) {
    if (report.stores().is_spoken_of(v)) continue;
    const auto& seen = report.program().observables;
    return "nothing is told of " + backquoted(report.program().variables.name(v)) +
           (std::find(seen.begin(), seen.end(), v) != seen.end() ? ": that it is seen does not make a guard hold" : "");
  }
  const std::vector<bool> all(report.program().locations.size(), true);
  return report.stores().freedom({true, formula}, all).may_hold
             ? "what makes it hold is told only behind it, or where nothing leads"
             : "nothing that is told makes it hold";
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
    finding.suggestion = always ? "the constraints entail it by themselves" : reason(report, one.condition->formula);
  }
}

}  // namespace rmpl::compiler
