// Told: modes that are impossible, never entered, or never the first.
// SPDX-License-Identifier: MIT
#include <algorithm>

#include "automata/step/transition_rules.hpp"
#include "base/printable.hpp"
#include "compiler/check/vocabulary.hpp"
#include "compiler/lint/plant/report.hpp"

namespace rmpl::compiler {

using automata::Assignment;
using automata::Component;
using automata::ComponentId;
using automata::ModeId;
using automata::TransitionId;
using automata::ValueId;
using grammar::Code;

namespace {

/// Modes with the same finding: of one type, the same one.
using ByType = std::map<std::pair<std::string, ModeId>, std::vector<ComponentId>>;

ByType by_type(const automata::Plant& plant, const std::vector<PlantMode>& found) {
  ByType result;
  for (const PlantMode& mode : found) result[{plant[mode.component].type, mode.mode}].push_back(mode.component);
  return result;
}

Assignment assignment(const automata::Plant& plant, PlantMode mode) {
  return {plant[mode.component].mode, ValueId(mode.mode.index())};
}

void report_impossible(PlantReport& report) {
  for (const auto& [key, instances] : by_type(report.plant(), find_impossible_modes(report.analysis()))) {
    const PlantMode first{instances.front(), key.second};
    const Assignment mode = assignment(report.plant(), first);
    const Contradiction why = report.analysis().blame_at_large().of({&mode, 1}, automata::constant(true));
    const bool alone = why.interconnections.empty();
    auto& finding = report.add(
        Code::impossible_mode, report.at(first),
        "mode " + report.mode(first) + " of " + report.name(instances) +
            (alone ? " is impossible: its constraint contradicts itself" : " contradicts the interconnections"));
    if (!alone) report.blame(finding, why);
  }
}

/// Modes that are not reached as guards never hold: what is told of these guards is enough.
class Explained {
 public:
  explicit Explained(PlantReport& report) : plant_(report.plant()), reach_(report.analysis().reach()) {
    for (std::size_t c = 0; c < plant_.components.size(); ++c) {
      const Component& component = plant_.components[c];
      for (std::size_t round = 0; round < component.modes.size(); ++round) {
        for (std::size_t t = 0; t < component.transitions.size(); ++t) look_at(ComponentId(c), TransitionId(t));
      }
    }
  }
  [[nodiscard]] bool operator()(PlantMode mode) const { return modes_.contains(mode); }

 private:
  void look_at(ComponentId c, TransitionId id) {
    const automata::Transition& t = plant_[c].transitions[id.index()];
    if (!can_ever_be_taken(t) || reach_.reached[c.index()][t.to.index()]) return;
    const bool from_reached = reach_.reached[c.index()][t.from.index()];
    const bool guarded = from_reached && reach_.guards[c.index()][id.index()].verdict == Implied::Verdict::no;
    if (guarded || modes_.contains({c, t.from})) modes_.insert({c, t.to});
  }

  const automata::Plant& plant_;
  const Reach& reach_;
  std::set<PlantMode> modes_;
};

/// Notes for the transitions that lead to a mode: why each is never taken. How many there are.
std::size_t add_reasons(PlantReport& report, PlantMode mode, grammar::Diagnostic& finding) {
  const Component& component = report.plant()[mode.component];
  const Reach& reach = report.analysis().reach();
  std::set<grammar::Span> told;
  for (std::size_t t = 0; t < component.transitions.size(); ++t) {
    const automata::Transition& transition = component.transitions[t];
    if (transition.to != mode.mode || transition.from == mode.mode) continue;
    const grammar::Span span = report.at(transition.origin);
    if (told.size() >= 3 || !told.insert(span).second) continue;
    std::string reason = "the interconnections exclude every state after this transition";
    if (!can_ever_be_taken(transition)) {
      reason = "this transition has no weight";
    } else if (!reach.reached[mode.component.index()][transition.from.index()]) {
      reason = "this transition comes from " + report.mode({mode.component, transition.from}) +
               ", which is never entered either";
    }
    finding.notes.push_back({span, std::move(reason)});
  }
  return told.size();
}

void report_unreachable(PlantReport& report) {
  const Explained explained(report);
  std::vector<PlantMode> found = find_unreachable_modes(report.analysis());
  std::erase_if(found, explained);
  for (const auto& [key, instances] : by_type(report.plant(), found)) {
    const PlantMode first{instances.front(), key.second};
    auto& finding = report.add(Code::unreachable_mode, report.at(first),
                               "mode " + report.mode(first) + " of " + report.name(instances) + " is never entered");
    if (!report.all(instances)) finding.severity = grammar::Severity::note;
    if (add_reasons(report, first, finding) == 0) {
      finding.message += ": no transition leads to it";
      finding.suggestion = "add a transition that leads to it, or remove the mode";
    }
  }
}

void report_impossible_initial(PlantReport& report) {
  ModeSets initial;
  for (const Component& component : report.plant().components) {
    std::vector<bool>& modes = initial.emplace_back();
    for (const double probability : component.initial) modes.push_back(probability > 0);
  }
  for (const auto& [key, instances] : by_type(report.plant(), find_impossible_initial_modes(report.analysis()))) {
    const PlantMode first{instances.front(), key.second};
    const Assignment mode = assignment(report.plant(), first);
    auto& finding = report.add(Code::impossible_initial_mode, report.at(first),
                               "mode " + report.mode(first) + " of " + report.name(instances) +
                                   " has an initial probability, but no initial state has it");
    report.blame(finding, Blame(report.plant(), initial).of({&mode, 1}, automata::constant(true)));
  }
}

}  // namespace

void report_modes(PlantReport& report) {
  report_impossible(report);
  report_unreachable(report);
  report_impossible_initial(report);
}

}  // namespace rmpl::compiler
