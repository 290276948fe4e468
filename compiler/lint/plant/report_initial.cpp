// Told: plants without an initial state, or without any.
// SPDX-License-Identifier: MIT
#include "compiler/check/vocabulary.hpp"
#include "compiler/lint/plant/report.hpp"

namespace rmpl::compiler {

using automata::Assignment;
using automata::Component;
using automata::ComponentId;
using grammar::Code;

namespace {

/// The initial modes of the components whose other modes are left out of account in a contradiction.
std::vector<Assignment> starts_in(const automata::Plant& plant, const automata::PlantIndex& index,
                                  const Contradiction& why) {
  std::set<ComponentId> components;
  for (const Assignment& a : why.never) components.insert(*index.component_of(a.variable));
  std::vector<Assignment> result;
  for (const ComponentId c : components) {
    for (std::size_t m = 0; m < plant[c].modes.size(); ++m) {
      if (plant[c].initial[m] > 0) result.push_back({plant[c].mode, automata::ValueId(m)});
    }
  }
  return result;
}

}  // namespace

void report_initial_state(PlantReport& report) {
  Blame blame(report.plant(), report.analysis().reach().initial);
  Contradiction why = blame.of({}, automata::constant(true));
  const std::vector<Assignment> starts = starts_in(report.plant(), report.analysis().index(), why);
  auto& finding = report.add(Code::no_initial_state, report.declarations().plant,
                             "the plant has no initial state: the interconnections exclude " + report.list(starts));
  why.never.clear();
  report.blame(finding, why);
}

void report_impossible_plant(PlantReport& report) {
  automata::Theory interconnections(report.plant().variables);
  for (const automata::Interconnection& q : report.plant().interconnections) interconnections.tell(q.constraint);
  Contradiction why = report.analysis().blame_at_large().of({}, automata::constant(true));
  if (interconnections.consistent({})) {
    auto& finding =
        report.add(Code::no_initial_state, report.declarations().plant,
                   "the plant has no possible state: in every combination, the modes contradict the interconnections");
    report.blame(finding, why);
    return;
  }
  const grammar::Span first = why.interconnections.empty()
                                  ? report.declarations().plant
                                  : report.at(report.plant().interconnections[why.interconnections.front()].origin);
  if (!why.interconnections.empty()) why.interconnections.erase(why.interconnections.begin());
  auto& finding = report.add(Code::contradictory_interconnections, first,
                             why.interconnections.empty() ? "this interconnection can never hold"
                                                          : "this interconnection can never hold together with others");
  report.blame(finding, why);
}

}  // namespace rmpl::compiler
