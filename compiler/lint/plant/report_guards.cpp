// Told: guards that never hold, that overlap, that begin too late, or whose transitions something always goes before;
// transitions without effect.
// SPDX-License-Identifier: MIT
#include <algorithm>

#include "compiler/check/vocabulary.hpp"
#include "compiler/lint/plant/report.hpp"

namespace rmpl::compiler {

using automata::Assignment;
using automata::Component;
using automata::ComponentId;
using automata::TransitionId;
using automata::ValueId;
using grammar::Code;

namespace {

/// A transition as written, `a, b -> c when …`, makes one for each source; something is told of it where it is so of
/// all of an instance that set out from modes that are reached.
struct Written {
  PlantTransition first;
  std::vector<ComponentId> instances;
};

std::vector<Written> as_written(PlantReport& report, const std::vector<PlantTransition>& found) {
  const std::set<PlantTransition> all(found.begin(), found.end());
  std::map<std::pair<std::string, grammar::Span>, Written> result;
  const Reach& reach = report.analysis().reach();
  std::set<std::pair<ComponentId, grammar::Span>> done;
  for (const PlantTransition& transition : found) {
    const ComponentId c = transition.component;
    const grammar::Span span = report.at(transition);
    if (!done.emplace(c, span).second) continue;
    const Component& component = report.plant()[c];
    bool whole = true;
    for (std::size_t t = 0; t < component.transitions.size(); ++t) {
      const automata::Transition& other = component.transitions[t];
      if (other.origin != report[transition].origin || !reach.reached[c.index()][other.from.index()]) continue;
      whole = whole && all.contains({c, TransitionId(t)});
    }
    if (!whole) continue;
    Written& written = result.try_emplace({component.type, span}, Written{transition, {}}).first->second;
    written.instances.push_back(c);
  }
  std::vector<Written> list;
  list.reserve(result.size());
  for (auto& [key, written] : result) list.push_back(std::move(written));
  return list;
}

std::string ends(const PlantReport& report, PlantTransition transition) {
  return report.mode({transition.component, report[transition].from}) + " to " +
         report.mode({transition.component, report[transition].to});
}

/// What the guard reads and the last modes and command that were tried leave open.
std::vector<std::string> left_open(PlantReport& report, const Implied& guard) {
  std::vector<std::string> result;
  for (const Assignment& read : guard.read) {
    if (report.analysis().questions().follows(guard.context, is(read.variable, read.value))) continue;
    result.push_back(backquoted(report.plant().variables.name(read.variable)));
  }
  return result;
}

void report_impossible_guards(PlantReport& report) {
  for (const Written& written : as_written(report, find_impossible_guards(report.analysis()))) {
    const automata::Transition& t = report[written.first];
    const Assignment mode{report.plant()[written.first.component].mode, ValueId(t.from.index())};
    const Contradiction why = report.analysis().blame().of({&mode, 1}, t.guard);
    const bool contradicts = !report.analysis().questions().possible({&mode, 1}, t.guard);
    if (!contradicts) {
      const std::vector<automata::VariableId> read = variables_of(t.guard);
      const bool told =
          std::any_of(read.begin(), read.end(), [&](automata::VariableId v) { return report.undriven().contains(v); });
      if (told) continue;  // as an input that is not connected
    }
    auto& finding = report.add(Code::impossible_guard, report.at(written.first),
                               "the guard of the transition from " + ends(report, written.first) + " of " +
                                   report.name(written.instances) + " can never hold");
    if (!report.all(written.instances)) finding.severity = grammar::Severity::note;
    if (!contradicts) {
      const Implied& guard =
          report.analysis().reach().guards[written.first.component.index()][written.first.transition.index()];
      finding.message += ": no modes and no command imply it";
      const auto open = left_open(report, guard);
      if (!open.empty()) finding.suggestion = "check what determines " + enumerated(open, 3);
    } else if (why.empty()) {
      finding.message += ": it contradicts itself";
    } else {
      report.blame(finding, why);
    }
  }
}

void report_overlaps(PlantReport& report) {
  std::map<std::tuple<std::string, grammar::Span, grammar::Span>, std::pair<Overlap, std::vector<ComponentId>>> all;
  for (const Overlap& overlap : find_overlapping_guards(report.analysis())) {
    const grammar::Span first = report.at(PlantTransition{overlap.component, overlap.first});
    const grammar::Span second = report.at(PlantTransition{overlap.component, overlap.second});
    auto& entry =
        all.try_emplace({report.plant()[overlap.component].type, first, second}, overlap, std::vector<ComponentId>{})
            .first->second;
    if (entry.second.empty() || entry.second.back() != overlap.component) entry.second.push_back(overlap.component);
  }
  for (const auto& [key, entry] : all) {
    const auto& [overlap, instances] = entry;
    const PlantTransition first{overlap.component, overlap.first};
    const PlantTransition second{overlap.component, overlap.second};
    auto& finding = report.add(Code::overlapping_guards, report.at(first),
                               "two transitions of " + report.name(instances) + " can be enabled at once, from " +
                                   ends(report, first) + " and to " +
                                   report.mode({second.component, report[second].to}) + ", and each is equally likely");
    std::vector<Assignment> evidence = overlap.read;
    for (const Assignment& a : overlap.context) {
      if (std::find(evidence.begin(), evidence.end(), a) == evidence.end()) evidence.push_back(a);
    }
    finding.notes.push_back(
        {report.at(second), "the guard of this transition holds too, for example with " + report.list(evidence)});
    finding.suggestion = "make the guards exclude each other, or give both transitions weights with `with`";
  }
}

/// Whether wherever the one would be taken, another has taken the component to the same mode.
bool is_redundant(PlantReport& report, PlantTransition late, const std::vector<TransitionId>& by) {
  if (report[late].weight.kind != automata::Weight::Kind::none) return false;
  return std::all_of(by.begin(), by.end(), [&](TransitionId early) {
    const automata::Transition& other = report[PlantTransition{late.component, early}];
    return other.to == report[late].to && !report.plant()[late.component].is_fault(other);
  });
}

void report_shadows(PlantReport& report, const std::vector<Shadow>& shadows) {
  std::vector<PlantTransition> found;
  std::map<PlantTransition, std::vector<TransitionId>> by;
  for (const Shadow& shadow : shadows) {
    found.push_back({shadow.component, shadow.transition});
    by[found.back()] = shadow.by;
  }
  std::set<grammar::Span> redundant;
  for (const auto& [late, early] : by) redundant.insert(report.at(late));
  for (const auto& [late, early] : by) {
    if (!is_redundant(report, late, early)) redundant.erase(report.at(late));
  }
  for (const Written& written : as_written(report, found)) {
    auto& finding =
        report.add(Code::shadowed_transition, report.at(written.first),
                   "the transition from " + ends(report, written.first) + " of " + report.name(written.instances) +
                       " is never taken: another transition always preempts it");
    if (!report.all(written.instances)) finding.severity = grammar::Severity::note;
    for (const TransitionId early : by[written.first]) {
      const PlantTransition one{written.first.component, early};
      const bool fault = report.plant()[one.component].is_fault(report[one]);
      finding.notes.push_back(
          {report.at(one), fault ? "this fault is certain whenever its guard holds"
                                 : "this transition has no time bounds, and is enabled whenever the other one is"});
    }
    const grammar::Span span = finding.span;
    if (report.all(written.instances) && redundant.contains(span) && report.is_beside_plant(span))
      propose(finding, report.removals().of_statement(span));
  }
}

void report_idle(PlantReport& report) {
  for (const Written& written : as_written(report, find_idle_transitions(report.analysis()))) {
    const automata::Transition& transition = report[written.first];
    const bool timed = report.plant().has_timed_exit(written.first.component, transition.from);
    auto& finding = report.add(Code::idle_transition, report.at(written.first),
                               "the transition from " + report.mode({written.first.component, transition.from}) +
                                   " of " + report.name(written.instances) + " to the same mode changes nothing" +
                                   (timed ? ": the clock of the mode continues" : ""));
    if (!timed || !report.all(written.instances)) finding.severity = grammar::Severity::note;
    const grammar::Span span = finding.span;
    if (report.all(written.instances) && report.is_beside_plant(span))
      propose(finding, report.removals().of_statement(span));
  }
}

void report_weights_unused_at_rest(PlantReport& report) {
  for (const Written& written : as_written(report, find_weights_unused_at_rest(report.analysis()))) {
    auto& finding = report.add(
        Code::unused_weight, report.at(written.first),
        "the weight of the transition from " + ends(report, written.first) + " of " + report.name(written.instances) +
            " has no effect while all controls are idle: no other transition is enabled then, so this one is certain");
    if (!report.all(written.instances)) finding.severity = grammar::Severity::note;
    finding.suggestion = "give the alternative outcomes: `-> { … with 0.9, … with 0.1 }`";
  }
}

void report_unused_weights(PlantReport& report) {
  for (const Written& written : as_written(report, find_unused_weights(report.analysis()))) {
    const bool timed = report[written.first].timing.has_value();
    auto& finding = report.add(
        Code::unused_weight, report.at(written.first),
        "the weight of the transition from " + ends(report, written.first) + " of " + report.name(written.instances) +
            (timed ? " has no effect: a timed transition competes with others only by its time"
                   : " has no effect: no other transition is ever enabled together with this one, so it is certain"));
    if (!report.all(written.instances)) finding.severity = grammar::Severity::note;
    finding.suggestion =
        timed ? "to give alternative outcomes at one time, write `-> { … with 0.9, … with 0.1 } in [ … ]`"
              : "give the alternative outcomes: `-> { … with 0.9, … with 0.1 }`";
  }
}

void report_late_guards(PlantReport& report, const std::vector<Shadow>& shadows) {
  std::vector<PlantTransition> found = find_late_guards(report.analysis());
  std::erase_if(found, [&](const PlantTransition& late) {  // told as never taken
    return std::any_of(shadows.begin(), shadows.end(), [&](const Shadow& shadow) {
      return PlantTransition{shadow.component, shadow.transition} == late;
    });
  });
  for (const Written& written : as_written(report, found)) {
    const automata::Transition& transition = report[written.first];
    const automata::Timing& timing = *transition.timing;
    auto& finding = report.add(Code::late_guard, report.at(written.first),
                               "the time bounds of the transition from " + ends(report, written.first) + " of " +
                                   report.name(written.instances) + " count from the entry into " +
                                   report.mode({written.first.component, transition.from}) +
                                   ": if the guard begins to hold after " + automata::format_seconds(timing.upper) +
                                   " s, the transition is taken without delay");
    // A lower bound alone says from when on something is obeyed.
    if (timing.lower == timing.upper || !report.all(written.instances)) finding.severity = grammar::Severity::note;
    finding.suggestion =
        "for a delay after the guard, add a mode: let the guard lead to it, and put the time bounds on its exit";
  }
}

}  // namespace

void report_guards(PlantReport& report) {
  const std::vector<Shadow> shadows = find_shadowed_transitions(report.analysis());
  report_impossible_guards(report);
  report_overlaps(report);
  report_shadows(report, shadows);
  report_idle(report);
  report_unused_weights(report);
  report_weights_unused_at_rest(report);
  report_late_guards(report, shadows);
}

}  // namespace rmpl::compiler
