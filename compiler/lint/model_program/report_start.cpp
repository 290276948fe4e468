// Told: model programs that have no start, and draws before it that never turn out so.
// SPDX-License-Identifier: MIT
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "automata/step/marking_step.hpp"
#include "compiler/lint/model_program/report.hpp"

namespace rmpl::compiler {

using automata::LocationId;
using grammar::Code;

namespace {

grammar::Diagnostic& report_no_start(ModelReport& report, const char* why) {
  const char* what = report.places().locations.empty() ? "the plant" : "the model program";
  return report.add(Code::no_initial_state, *report.name(), std::string(what) + " has no start: " + why);
}

using Together = std::vector<std::vector<LocationId>>;  ///< `started_together`

void start(const automata::InitialBranch& branch, const Together& together, std::vector<LocationId>& told) {
  for (const LocationId started : branch.started) {
    told.insert(told.end(), together[started.index()].begin(), together[started.index()].end());
  }
}

/// What is told in every start.
std::vector<LocationId> certain(const automata::ModelProgram& program, const Together& together) {
  std::vector<LocationId> told = together.front();
  for (const automata::InitialDraw& draw : program.initial) {
    if (draw.branches.size() == 1) start(draw.branches.front(), together, told);
  }
  return told;
}

/// A branch of a draw, and what contradicts it.
struct NeverDrawn {
  LocationId branch;
  ToldContradiction blamed;
};

/// The branches of a draw that contradict what is certain.
std::vector<NeverDrawn> never_drawn(ModelReport& report, const automata::InitialDraw& draw, const Together& together,
                                    const std::vector<LocationId>& certain) {
  std::vector<NeverDrawn> never;
  for (const automata::InitialBranch& branch : draw.branches) {
    std::vector<LocationId> told = certain;
    start(branch, together, told);
    if (auto blamed = report.stores().contradiction(told); blamed) {
      never.push_back({branch.started.front(), *std::move(blamed)});
    }
  }
  return never;
}

bool has_start(const automata::ModelProgram& program) {
  const automata::MarkingStep::Ways starts = automata::MarkingStep(program).initial();
  return !starts || !starts->empty();  // too many to be listed: taken for some
}

}  // namespace

bool report_start(ModelReport& report) {
  const Together& together = report.together();
  const std::vector<LocationId> told = certain(report.program(), together);
  if (const auto blamed = report.stores().contradiction()) {
    report.blame(report_no_start(report, "its constraints contradict each other"), *blamed);
    return false;
  }
  if (const auto blamed = report.stores().contradiction(told)) {
    auto& finding = report_no_start(
        report, blamed->standing.empty() ? "the constraints told at the start contradict each other"
                                         : "the constraints told at the start contradict those of the whole program");
    report.blame(finding, *blamed);
    return false;
  }
  if (!has_start(report.program())) {
    report_no_start(report, "the constraints told at the start contradict each other, whatever is drawn");
    return false;
  }
  std::set<grammar::Span> reported;
  for (const automata::InitialDraw& draw : report.program().initial) {
    for (const NeverDrawn& never : never_drawn(report, draw, together, told)) {
      const grammar::Span branch = report.span_of(never.branch);
      if (!reported.insert(branch).second) continue;
      auto& finding = report.add(Code::impossible_initial_mode, branch,
                                 "this branch is never drawn: its constraints contradict those told in every start");
      report.blame(finding, never.blamed);
    }
  }
  return true;
}

}  // namespace rmpl::compiler
