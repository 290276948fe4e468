// Exported timed automata, explored unit by unit, against the verifier.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <set>
#include <tuple>
#include <vector>

#include "tests/property/draw.hpp"
#include "tests/property/generate.hpp"
#include "verifier/export/timed_automaton.hpp"
#include "verifier/plant/check.hpp"

namespace rmpl::property {
namespace {

using verifier::ClockRange;
using verifier::Edge;
using verifier::TimedAutomaton;
using verifier::Units;

/// The slow twin: location by location and unit by unit. Whole units suffice, as all bounds are weak; a clock beyond
/// every constant counts no further.
class Explorer {
 public:
  explicit Explorer(const TimedAutomaton& automaton) : automaton_(automaton) {
    for (const auto& location : automaton.locations) note(location.invariant);
    for (const Edge& edge : automaton.edges) note(edge.guard);
  }

  bool reaches_target() {
    for (const std::size_t l : automaton_.initial) add({l, 0, std::vector<Units>(automaton_.clocks.size(), 0)});
    while (!waiting_.empty()) {
      const State state = waiting_.back();
      waiting_.pop_back();
      const auto& [location, faults, clocks] = state;
      if (automaton_.locations[location].target) return true;
      if (!automaton_.locations[location].urgent) {
        std::vector<Units> later = clocks;
        for (Units& clock : later) clock = std::min(clock + 1, greatest_ + 1);
        add({location, faults, later});
      }
      for (const Edge& edge : automaton_.edges) {
        if (edge.from != location || faults + edge.faults > automaton_.faults || !within(clocks, edge.guard)) continue;
        std::vector<Units> next = clocks;
        for (const std::size_t reset : edge.resets) next[reset] = 0;
        add({edge.to, faults + edge.faults, next});
      }
    }
    return false;
  }

 private:
  using State = std::tuple<std::size_t, unsigned, std::vector<Units>>;

  void note(const std::vector<ClockRange>& ranges) {
    for (const auto& [clock, range] : ranges) {
      greatest_ = std::max(greatest_, range.lower);
      if (range.upper != verifier::unbounded) greatest_ = std::max(greatest_, range.upper);
    }
  }
  static bool within(const std::vector<Units>& clocks, const std::vector<ClockRange>& ranges) {
    return std::all_of(ranges.begin(), ranges.end(),
                       [&](const ClockRange& r) { return r.range.contains(clocks[r.clock]); });
  }
  void add(const State& state) {
    if (!within(std::get<2>(state), automaton_.locations[std::get<0>(state)].invariant)) return;
    if (seen_.insert(state).second) waiting_.push_back(state);
  }

  const TimedAutomaton& automaton_;
  Units greatest_ = 0;
  std::set<State> seen_;
  std::vector<State> waiting_;
};

RC_GTEST_PROP(Export, ReachesWhatThePlantReaches, ()) {
  const Model model = *models();
  const auto& plant = model.plant;
  const verifier::ExportQuestion question{*formulas(plant.variables, all_variables(plant), 1),
                                          chance(30),
                                          static_cast<unsigned>(up_to(0, 2)),
                                          chance(50) ? verifier::Commands::one : verifier::Commands::any,
                                          {}};
  automata::PlantStep step(plant);
  verifier::Slices slices(plant);
  const TimedAutomaton automaton = verifier::unfold(step, question, {});
  verifier::CheckOptions options;
  options.faults = question.faults;
  options.commands = question.commands;
  options.entailed = question.entailed;
  const verifier::Answer result =
      verifier::check(slices, verifier::Reachability{question.target, {}, false}, options, {});
  RC_ASSERT(Explorer(automaton).reaches_target() == (result.verdict == verifier::Verdict::holds));
}

}  // namespace
}  // namespace rmpl::property
