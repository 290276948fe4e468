// Exported networks of timed automata, explored unit by unit, against the verifier.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <set>
#include <tuple>
#include <vector>

#include "automata/controls.hpp"
#include "automata/logic/truth_table.hpp"
#include "base/product.hpp"
#include "tests/property/draw.hpp"
#include "tests/property/generate.hpp"
#include "verifier/check/check.hpp"
#include "verifier/export/round_process.hpp"

namespace rmpl::property {
namespace {

using verifier::Units;

/// The slow twin: round by round, and unit by unit between them. Whole units suffice, as all bounds are weak; a clock
/// beyond every constant counts no further.
class NetworkExplorer {
 public:
  /// `briefly`: with what components do in several modes told once.
  NetworkExplorer(const automata::Plant& plant, const verifier::Network& network, bool briefly)
      : plant_(plant), network_(network) {
    for (std::size_t c = 0; c < plant.components.size(); ++c) {
      const automata::ComponentId id(c);
      processes_.push_back(briefly ? verifier::in_rounds(plant, id, network.processes[c])
                                   : as_it_is(plant, id, network.processes[c]));
      for (const verifier::RoundRest& rest : processes_.back().rests) note(rest.clock);
      for (const verifier::RoundStep& step : processes_.back().steps) note(step.clock);
    }
  }

  bool reaches_target() {
    std::vector<std::vector<automata::ModeId>> initial;
    for (const verifier::ComponentProcess& process : network_.processes) initial.push_back(process.initial);
    base::for_each_combination(
        initial, [&](const automata::Modes& modes) { settle(modes, std::vector<Units>(modes.size(), 0), 0); });
    while (!waiting_.empty() && !reached_) {
      const State state = waiting_.back();
      waiting_.pop_back();
      wait(state);
      const std::optional<State> awake = woken(state);
      if (!awake) continue;
      verifier::for_each_action(plant_, network_.commands, [&](const automata::ControlAction& action) {
        automata::Modes next;
        std::vector<Units> clocks = awake->clocks;
        step(*awake, action, next, clocks, awake->faults);
      });
    }
    return reached_;
  }

 private:
  struct State {
    automata::Modes modes;
    std::vector<Units> clocks;
    unsigned faults;
    std::vector<int> rests;  ///< by component, the one that it is in; -1: it is stopped
    auto operator<=>(const State&) const = default;
  };

  static verifier::RoundProcess as_it_is(const automata::Plant& plant, automata::ComponentId id,
                                         const verifier::ComponentProcess& process) {
    const auto within = [&](automata::ModeId mode, const automata::Formula& where) {
      return automata::conjunction({automata::is(plant[id].mode, automata::ValueId(mode.index())), where});
    };
    verifier::RoundProcess result;
    for (const verifier::ProcessStep& step : process.steps) {
      result.steps.push_back({within(step.from, step.where), step.clock, step.to, step.fault, step.restarts});
    }
    for (const verifier::ProcessRest& rest : process.rests) {
      result.rests.push_back({within(rest.mode, rest.where), rest.clock, rest.urgent, rest.restarts});
    }
    return result;
  }

  void note(const verifier::Interval& clock) {
    greatest_ = std::max(greatest_, clock.lower);
    if (clock.upper != verifier::unbounded) greatest_ = std::max(greatest_, clock.upper);
  }

  bool holds(const automata::Formula& where, const automata::Modes& modes,
             const automata::ControlAction* action = nullptr) const {
    return automata::evaluate(where, [&](automata::VariableId variable) {
      if (const auto component = plant_.component_of(variable)) {
        return automata::ValueId(modes[component->index()].index());
      }
      return (*action)[*automata::control_of(plant_, variable)];
    });
  }

  void wait(State state) {
    for (std::size_t c = 0; c < state.modes.size(); ++c) {
      if (state.rests[c] < 0) return;
      state.clocks[c] = std::min(state.clocks[c] + 1, greatest_ + 1);
      if (processes_[c].rests.empty()) continue;
      const auto& rest = processes_[c].rests[static_cast<std::size_t>(state.rests[c])];
      if (rest.restarts) {
        state.clocks[c] = 1;  // however long
      } else if (state.clocks[c] > rest.clock.upper) {
        return;
      }
    }
    add(std::move(state));
  }

  /// As a round begins; none where a clock that restarts has not waited for a unit.
  std::optional<State> woken(State state) const {
    for (std::size_t c = 0; c < state.modes.size(); ++c) {
      if (state.rests[c] < 0 || processes_[c].rests.empty()) continue;
      if (!processes_[c].rests[static_cast<std::size_t>(state.rests[c])].restarts) continue;
      if (state.clocks[c] < 1) return std::nullopt;
      state.clocks[c] = 0;
    }
    return state;
  }

  void step(const State& from, const automata::ControlAction& action, automata::Modes& next, std::vector<Units>& clocks,
            unsigned faults) {
    const std::size_t c = next.size();
    if (c == from.modes.size()) return settle(next, clocks, faults);
    for (const verifier::RoundStep& one : processes_[c].steps) {
      if (!one.clock.contains(from.clocks[c]) || !holds(one.where, from.modes, &action)) continue;
      if (faults + (one.fault ? 1U : 0U) > network_.faults) continue;
      next.push_back(one.to.value_or(from.modes[c]));
      if (one.restarts) clocks[c] = 0;
      step(from, action, next, clocks, faults + (one.fault ? 1U : 0U));
      clocks[c] = from.clocks[c];
      next.pop_back();
    }
  }

  void settle(const automata::Modes& modes, const std::vector<Units>& clocks, unsigned faults) {
    const auto is_so = [&](const automata::Formula& one) { return holds(one, modes); };
    if (!std::all_of(network_.possible.begin(), network_.possible.end(), is_so)) return;
    reached_ = reached_ || is_so(network_.target);
    State state{modes, clocks, faults, {}};
    rest(state);
  }

  void rest(State& state) {
    const std::size_t c = state.rests.size();
    if (c == state.modes.size()) return add(state);
    const auto& rests = processes_[c].rests;
    const auto go_on = [&](int with) {
      state.rests.push_back(with);
      rest(state);
      state.rests.pop_back();
    };
    if (rests.empty()) go_on(0);
    for (std::size_t r = 0; r < rests.size(); ++r) {
      if (!holds(rests[r].where, state.modes)) continue;
      if (!rests[r].clock.contains(state.clocks[c])) continue;
      const Units clock = state.clocks[c];
      if (rests[r].restarts) state.clocks[c] = 0;
      go_on(rests[r].urgent ? -1 : static_cast<int>(r));
      state.clocks[c] = clock;
    }
  }

  void add(State state) {
    if (seen_.insert(state).second) waiting_.push_back(std::move(state));
  }

  const automata::Plant& plant_;
  const verifier::Network& network_;
  std::vector<verifier::RoundProcess> processes_;
  Units greatest_ = 0;
  bool reached_ = false;
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
  verifier::CheckOptions options;
  options.faults = question.faults;
  options.commands = question.commands;
  options.entailed = question.entailed;
  const verifier::Answer result =
      verifier::check(slices, verifier::Reachability{question.target, {}, false}, options, {});
  const bool reachable = result.verdict == verifier::Verdict::holds;
  const verifier::Network network = verifier::network_of(step, question, {}, chance(50) ? 0 : 4096);
  RC_ASSERT(NetworkExplorer(plant, network, false).reaches_target() == reachable);
  RC_ASSERT(NetworkExplorer(plant, network, true).reaches_target() == reachable);
}

RC_GTEST_PROP(Export, TablesHoldWhereTheirRowsDo, ()) {
  automata::Variables variables;
  std::vector<automata::VariableId> columns;
  std::vector<std::vector<automata::ValueId>> lists;
  for (std::size_t c = 0; c < up_to(0, 4); ++c) {
    columns.push_back(variables.add({"v" + std::to_string(c), {"a", "b", "c"}}));
    lists.push_back(
        {automata::ValueId(std::size_t{0}), automata::ValueId(std::size_t{1}), automata::ValueId(std::size_t{2})});
  }
  automata::TruthTable table(columns);
  std::vector<std::pair<std::vector<automata::ValueId>, bool>> rows;
  base::for_each_combination(lists, [&](const std::vector<automata::ValueId>& values) {
    if (chance(20)) return;
    rows.emplace_back(values, chance(40));
    table.add(values, rows.back().second);
  });
  const automata::Formula formula = table.formula();
  for (const auto& row : rows) {
    const auto value_of = [&](automata::VariableId variable) {
      return row.first[static_cast<std::size_t>(std::find(columns.begin(), columns.end(), variable) - columns.begin())];
    };
    RC_ASSERT(automata::evaluate(formula, value_of) == row.second);
  }
}

}  // namespace
}  // namespace rmpl::property
