// Told: constraints that are told together wherever they are, and contradict each other.
// SPDX-License-Identifier: MIT
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "compiler/check/vocabulary.hpp"
#include "compiler/lint/model_program/report.hpp"

namespace rmpl::compiler {

using automata::LocationId;

namespace {

void report_contradiction(ModelReport& report, ToldContradiction blamed) {
  const auto told = [&](LocationId l) {
    return backquoted(to_text(report.program().locations[l.index()].told, report.program().variables));
  };
  const LocationId last = blamed.told.back();
  blamed.told.pop_back();
  std::string message =
      told(last) + (blamed.told.empty() ? " contradicts the constraints" : " is told in the same instant as ");
  for (std::size_t b = 0; b < blamed.told.size(); ++b) message += (b == 0 ? "" : ", ") + told(blamed.told[b]);
  auto& finding = report.add(grammar::Code::contradicting_goals, report.span_of(last),
                             message + ": such an instant is impossible, so the program never gets there");
  report.blame(finding, blamed);
}

}  // namespace

void report_contradictions(ModelReport& report) {
  const automata::ModelProgram& program = report.program();
  const auto& together = report.together();
  std::vector<bool> within(program.locations.size(), false);  // something inside is told of already
  std::set<grammar::Span> reported;
  for (std::size_t l = program.locations.size(); l-- > 0;) {  // children stand behind their parents
    bool told = within[l];
    if (!told && report.reachable()[l]) {
      auto blamed = report.stores().contradiction(together[l]);
      told = blamed.has_value();
      if (told && reported.insert(report.span_of(blamed->told.back())).second)
        report_contradiction(report, *std::move(blamed));
    }
    if (told && program.locations[l].parent) within[program.locations[l].parent->index()] = true;
  }
}

}  // namespace rmpl::compiler
