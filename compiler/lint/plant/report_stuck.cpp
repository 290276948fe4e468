// Told: plants that get stuck.
// SPDX-License-Identifier: MIT
#include "automata/time/time.hpp"
#include "compiler/lint/plant/report.hpp"

namespace rmpl::compiler {

using automata::Assignment;
using automata::ValueId;
using grammar::Code;

void report_stuck(PlantReport& report) {
  for (const StuckState& stuck : find_stuck_states(report.plant())) {
    const auto assignments = [&](const std::vector<automata::ModeId>& modes) {
      std::vector<Assignment> result;
      for (std::size_t i = 0; i < modes.size(); ++i) {
        result.push_back({report.plant()[stuck.components[i]].mode, ValueId(modes[i].index())});
      }
      return result;
    };
    const std::vector<Assignment> next = assignments(stuck.next);
    Contradiction why = report.analysis().blame_at_large().of(next, automata::constant(true));
    const grammar::Span span = why.interconnections.empty()
                                   ? report.declarations().plant
                                   : report.at(report.plant().interconnections[why.interconnections.front()].origin);
    auto& finding = report.add(Code::stuck_plant, span,
                               "the plant deadlocks with " + report.list(assignments(stuck.modes)) + " after " +
                                   std::to_string(stuck.cycles) + (stuck.cycles == 1 ? " cycle" : " cycles") + " of " +
                                   automata::format_seconds(stuck.period) +
                                   " s: whatever is commanded, every next state is contradictory");
    if (!why.interconnections.empty()) why.interconnections.erase(why.interconnections.begin());
    finding.notes.push_back(
        {report.declarations().plant, "with all controls idle, the next cycle leads to " + report.list(why.assumed)});
    why.assumed.clear();
    report.blame(finding, why);
  }
}

}  // namespace rmpl::compiler
