// Model programs: the step and the estimators against enumeration.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

#include "automata/step/marking_step.hpp"
#include "automata/step/plant_step.hpp"
#include "runtime/reasoning/estimate/estimator.hpp"
#include "runtime/reasoning/estimate/marking/marking_estimator.hpp"
#include "tests/property/draw.hpp"
#include "tests/property/generate.hpp"
#include "tests/property/generate_model_program.hpp"
#include "tests/reference/model_program.hpp"
#include "tests/reference/plant_as_model.hpp"

namespace rmpl::property {
namespace {

using automata::Marking;
using automata::MarkingStep;
using automata::ModelProgram;
using reference::MarkedSet;
using reference::MarkingBelief;

MarkedSet set_of(const Marking& marking) { return {marking.begin(), marking.end()}; }

reference::Commands commands_of(const ModelProgram& program, const ModelInput& input) {
  reference::Commands result;
  for (std::size_t c = 0; c < input.command.size(); ++c) {
    if (input.command[c]) result.push_back({program.controls[c].variable, *input.command[c]});
  }
  return result;
}

void same(const MarkingBelief& found, const MarkingBelief& expected) {
  for (const auto& [marking, probability] : expected) {
    RC_ASSERT(found.contains(marking));
    RC_ASSERT(std::abs(found.at(marking) - probability) < 1e-12);
  }
  RC_ASSERT(found.size() == expected.size());
}

/// From marking to marking, every one that can be reached in a few steps.
RC_GTEST_PROP(ModelPrograms, TheStepIsTheEnumeration, ()) {
  const ModelProgram program = (*model_programs()).program;
  const std::vector<ModelInput> inputs = *model_inputs(program, 3);
  const reference::ModelProgramStep slow(program);
  MarkingStep fast(program);
  const auto belief_of = [&](const MarkingStep::Ways& ways) {
    RC_ASSERT(ways.has_value());
    MarkingBelief result;
    for (const auto& way : *ways) result[set_of(fast.rules().whole(fast[way.target]))] += way.probability;
    RC_ASSERT(result.size() == ways->size());
    return result;
  };
  const auto initial = fast.initial();
  same(belief_of(initial), slow.initial());
  std::set<MarkingStep::Number> reached;
  for (const auto& way : *initial) reached.insert(way.target);
  for (const ModelInput& input : inputs) {
    std::set<MarkingStep::Number> next;
    for (const MarkingStep::Number number : reached) {
      fast.command(input.command);
      fast.observe(input.observation);
      const MarkedSet marking = set_of(fast.rules().whole(fast[number]));
      same(belief_of(fast.ways(number)), slow.next(marking, commands_of(program, input)));
      RC_ASSERT(std::abs(fast.factor(number) - slow.factor(marking, input.observation)) < 1e-15);
      std::map<automata::VariableId, automata::ValueId> values;
      for (const auto& a : fast.store().values(fast[number])) values[a.variable] = a.value;
      RC_ASSERT(values == slow.values(marking));
      for (const auto& way : *fast.ways(number)) {
        if (next.size() < 12) next.insert(way.target);
      }
    }
    reached = next;
  }
}

using runtime::MarkingOptions;

MarkingBelief belief_of(runtime::MarkingEstimator& estimator) {
  MarkingBelief result;
  double before = 1;
  for (const runtime::MarkingEntry& entry : estimator.belief()) {
    RC_ASSERT(entry.probability <= before * (1 + 1e-11));
    before = entry.probability;
    result[set_of(entry.marking)] = entry.probability;
  }
  return result;
}

/// The k most probable, and whether no tie makes that unclear.
std::pair<MarkingBelief, bool> best_of(const MarkingBelief& belief, std::size_t k) {
  std::vector<std::pair<double, MarkedSet>> all;
  for (const auto& [marking, probability] : belief) all.emplace_back(probability, marking);
  std::stable_sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
  const bool clear = all.size() <= k || all[k - 1].first > all[k].first * (1 + 1e-9);
  if (all.size() > k) all.resize(k);
  MarkingBelief result;
  double sum = 0;
  for (const auto& [probability, marking] : all) sum += probability;
  for (const auto& [probability, marking] : all) result[marking] = probability / sum;
  return {result, clear};
}

/// Several programs side by side, which share nothing.
ModelProgram beside(const ModelProgram& a, const ModelProgram& b) {
  ModelProgram both;
  both.name = "Both";
  both.locations.emplace_back().composite = true;
  for (const ModelProgram* part : {&a, &b}) {
    const std::size_t variables = both.variables.size();
    const std::size_t locations = both.locations.size();
    const auto variable = [&](automata::VariableId v) { return automata::VariableId(v.index() + variables); };
    const auto formula = [&](automata::Formula& f) {
      f = renamed(f, variable, [](automata::VariableId, automata::ValueId value) { return value; });
    };
    const auto location = [&](automata::LocationId& l) { l = automata::LocationId(l.index() + locations); };
    const auto arcs = [&](std::vector<automata::GuardedArc>& some) {
      for (automata::GuardedArc& arc : some) {
        location(arc.target);
        for (automata::Condition& guard : arc.guard) formula(guard.constraint);
      }
    };
    for (automata::Variable v : part->variables) {
      v.name += part == &a ? "a" : "b";
      both.variables.add(v);
    }
    for (const auto& c : part->controls) both.controls.push_back({variable(c.variable), c.idle});
    for (const auto v : part->observables) both.observables.push_back(variable(v));
    for (automata::Interconnection told : part->constraints) {
      formula(told.constraint);
      both.constraints.push_back(told);
    }
    for (automata::ModelLocation l : part->locations) {
      if (l.parent) location(*l.parent);
      if (!l.parent) {
        l.parent = automata::LocationId(0);
        l.start = true;
      }
      formula(l.told);
      formula(l.maintenance.constraint);
      arcs(l.arcs);
      for (automata::TransitionFunction& function : l.functions) {
        for (automata::LocationId& s : function.started) location(s);
        arcs(function.arcs);
      }
      both.locations.push_back(std::move(l));
    }
    for (automata::InitialDraw draw : part->initial) {
      location(draw.choice);
      for (auto& branch : draw.branches) {
        for (automata::LocationId& s : branch.started) location(s);
      }
      both.initial.push_back(std::move(draw));
    }
  }
  return both;
}

ModelProgram one_or_two() {
  const ModelProgram one = (*model_programs(5)).program;
  if (chance(60)) return one;
  return beside((*model_programs(2)).program, (*model_programs(3)).program);
}

/// An estimator that keeps all, beside the twin.
void is_exact(const MarkingOptions& options) {
  const ModelProgram program = one_or_two();
  const std::vector<ModelInput> inputs = *model_inputs(program, 5);
  const reference::ModelProgramStep slow(program);
  const auto fast = runtime::make_marking_estimator(program, options);
  reference::MarkingUpdate expected = reference::start(slow, {});
  RC_ASSERT(fast->estimate().possible == expected.possible);
  if (!expected.possible) return;
  if (chance(50)) {
    expected = reference::start(slow, inputs.front().observation);
    RC_ASSERT(fast->start(inputs.front().observation).set_aside == expected.set_aside);
  }
  same(belief_of(*fast), expected.belief);
  for (const ModelInput& input : inputs) {
    expected = reference::update(slow, expected.belief, commands_of(program, input), input.observation);
    const runtime::MarkingEstimate estimate = fast->update(input.command, input.observation);
    RC_ASSERT(estimate.possible == expected.possible);
    if (!expected.possible) return;  // groups in which a step is possible go on, which the twin does not know
    RC_ASSERT(estimate.set_aside == expected.set_aside);
    RC_ASSERT(estimate.explained == expected.set_aside.empty());
    same(belief_of(*fast), expected.belief);
  }
}

RC_GTEST_PROP(ModelPrograms, ExactIsTheSum, ()) { is_exact({.kind = MarkingOptions::Kind::exact}); }

RC_GTEST_PROP(ModelPrograms, KBestThatKeepsAllIsExact, ()) {
  is_exact({.kind = MarkingOptions::Kind::k_best, .k = 100'000, .most_summed = chance(50) ? 1u : 0u});
}

/// What k-best, or the beam, says at most to be missing, and the exact belief beside it.
RC_GTEST_PROP(ModelPrograms, NoMoreIsMissingThanIsSaid, ()) {
  const ModelProgram program = one_or_two();
  const std::vector<ModelInput> inputs = *model_inputs(program, 6);
  const auto kind = chance(70) ? MarkingOptions::Kind::k_best : MarkingOptions::Kind::beam;
  const auto fast = runtime::make_marking_estimator(program, {.kind = kind,
                                                              .k = up_to(1, 4),
                                                              .candidates = chance(30) ? up_to(1, 4) : 100'000,
                                                              .most_summed = chance(50) ? 1u : 0u});
  const auto all = runtime::make_marking_estimator(program, {.kind = MarkingOptions::Kind::exact});
  if (!fast->estimate().possible) return;
  const auto compare = [&] {
    const MarkingBelief exact = belief_of(*all);
    double kept = 0, listed = 0;
    for (const auto& [marking, probability] : belief_of(*fast)) {
      listed += probability;
      const auto known = exact.find(marking);
      if (known != exact.end()) kept += known->second;
    }
    // What a product of groups lists may be less than what they keep.
    const double missing = 1 - (1 - fast->estimate().missing_total) * std::min(1.0, listed);
    RC_ASSERT(1 - kept <= missing + 1e-9);
    RC_ASSERT(fast->estimate().missing_mass >= 0);
    RC_ASSERT(fast->estimate().missing_mass <= 1);
  };
  if (chance(50)) {
    all->start(inputs.front().observation);
    fast->start(inputs.front().observation);
  }
  compare();
  for (const ModelInput& input : inputs) {
    all->update(input.command, input.observation);
    fast->update(input.command, input.observation);
    if (!all->estimate().possible) return;  // the beam, which has no groups, stays as a whole
    compare();
  }
}

/// From belief to belief: the k most probable of the posterior that follows from those that were kept.
RC_GTEST_PROP(ModelPrograms, KBestKeepsTheBest, ()) {
  const ModelProgram program = (*model_programs()).program;
  const std::vector<ModelInput> inputs = *model_inputs(program, 5);
  const std::size_t k = up_to(1, 4);
  const reference::ModelProgramStep slow(program);
  const auto fast = runtime::make_marking_estimator(
      program, {.kind = MarkingOptions::Kind::k_best, .k = k, .most_summed = chance(70) ? 1u : 0u});
  if (!fast->estimate().possible || fast->groups() > 1) return;
  for (const ModelInput& input : inputs) {
    const MarkingBelief before = belief_of(*fast);
    RC_ASSERT(before.size() <= k);
    const auto all = reference::update(slow, before, commands_of(program, input), input.observation);
    const runtime::MarkingEstimate estimate = fast->update(input.command, input.observation);
    RC_ASSERT(estimate.possible == all.possible);
    if (!all.possible) return;  // readings of what nothing tells of are no group's
    RC_ASSERT(estimate.set_aside == all.set_aside);
    const auto [expected, clear] = best_of(all.belief, k);
    if (clear) same(belief_of(*fast), expected);
  }
}

RC_GTEST_PROP(ModelPrograms, TheBeamIsThePapers, ()) {
  const ModelProgram program = one_or_two();
  const std::vector<ModelInput> inputs = *model_inputs(program, 5);
  const std::size_t k = up_to(1, 4);
  const reference::ModelProgramStep slow(program);
  const auto fast = runtime::make_marking_estimator(
      program, {.kind = MarkingOptions::Kind::beam, .k = k, .most_summed = chance(70) ? 1u : 0u});
  if (!fast->estimate().possible) return;
  for (const ModelInput& input : inputs) {
    bool clear = true;
    const auto expected =
        reference::beam(slow, belief_of(*fast), commands_of(program, input), input.observation, k, clear);
    const runtime::MarkingEstimate estimate = fast->update(input.command, input.observation);
    RC_ASSERT(estimate.set_aside == expected.set_aside);
    RC_ASSERT(estimate.possible == expected.possible);
    if (clear) same(belief_of(*fast), expected.belief);
  }
}

/// What a window sets out from: the estimator's beliefs, until one does not explain what is read and the histories of
/// the window do; from there on what these come to, by the exact belief from where the window sets out.
class SetOut {
 public:
  SetOut(const reference::ModelProgramStep& step, MarkingBelief start, std::size_t updates, std::size_t k)
      : step_(step), updates_(updates), k_(k), from_{std::move(start)} {}

  /// False where a tie leaves open what is kept.
  bool update(const reference::Told& told, const MarkingBelief& belief, std::size_t set_aside) {
    told_.push_back(told);
    MarkingBelief last = belief;
    std::size_t missed = set_aside;
    bool clear = true;
    if (own_) {
      const auto next = reference::update(step_, *own_, told.first, told.second);
      missed = next.set_aside.size();
      std::tie(*own_, clear) = best_of(next.belief, k_);
      last = *own_;
    }
    from_.push_back(last);
    if (told_.size() > updates_) {
      told_.erase(told_.begin());
      from_.erase(from_.begin());
    }
    if (missed == 0 || !clear) return clear;
    std::vector<MarkingBelief> forward{from_.front()};
    std::size_t histories = 0;
    for (const reference::Told& one : told_) {
      const auto next = reference::update(step_, forward.back(), one.first, one.second);
      forward.push_back(next.belief);
      histories = next.set_aside.size();
    }
    if (histories < missed) {
      from_ = forward;
      std::tie(own_.emplace(), clear) = best_of(forward.back(), k_);
    } else if (set_aside < missed && own_) {
      own_.reset();
      from_.back() = belief;
    }
    return clear;
  }

  [[nodiscard]] const MarkingBelief& from() const { return from_.front(); }
  [[nodiscard]] const std::vector<reference::Told>& told() const { return told_; }

 private:
  const reference::ModelProgramStep& step_;
  std::size_t updates_, k_;
  std::vector<MarkingBelief> from_;
  std::vector<reference::Told> told_;
  std::optional<MarkingBelief> own_;
};

/// With few markings kept, and readings that they often do not explain.
RC_GTEST_PROP(ModelPrograms, NoWindowSetsOutFromWhatWasRefuted, ()) {
  const ModelProgram program = (*model_programs(4)).program;
  const std::vector<ModelInput> inputs = *model_inputs(program, 6);
  const std::size_t updates = up_to(1, 4);
  const std::size_t k = up_to(1, 3);
  const reference::ModelProgramStep slow(program);
  const auto fast =
      runtime::make_marking_estimator(program, {.kind = MarkingOptions::Kind::k_best, .k = k, .window = updates});
  if (!fast->estimate().possible || fast->groups() > 1) return;
  SetOut set_out(slow, belief_of(*fast), updates, k);
  for (const ModelInput& input : inputs) {
    const std::size_t set_aside = fast->update(input.command, input.observation).set_aside.size();
    if (!set_out.update({commands_of(program, input), input.observation}, belief_of(*fast), set_aside)) return;
    const auto all = reference::trajectories(slow, set_out.from(), set_out.told());
    const auto found = fast->history();
    RC_ASSERT(found.size() == std::min(k, all.size()));
    std::vector<double> probabilities;
    for (const auto& [trajectory, probability] : all) probabilities.push_back(probability);
    std::sort(probabilities.begin(), probabilities.end(), std::greater<>());
    for (std::size_t i = 0; i < found.size(); ++i) {
      reference::MarkingTrajectory trajectory;
      for (const Marking& marking : found[i].markings) trajectory.push_back(set_of(marking));
      RC_ASSERT(all.contains(trajectory));
      RC_ASSERT(std::abs(all.at(trajectory) - found[i].probability) < 1e-12);
      RC_ASSERT(std::abs(probabilities[i] - found[i].probability) < 1e-12);
    }
  }
}

/// All trajectories from the belief that many updates ago, every time anew.
RC_GTEST_PROP(ModelPrograms, TheWindowIsTheBestOfAllTrajectories, ()) {
  const ModelProgram program =
      chance(60) ? (*model_programs(4)).program : beside((*model_programs(2)).program, (*model_programs(2)).program);
  const std::vector<ModelInput> inputs = *model_inputs(program, 4);
  const std::size_t updates = up_to(1, 4);
  const std::size_t k = up_to(1, 6);
  const bool exact = chance(50);
  const reference::ModelProgramStep slow(program);
  const auto fast = runtime::make_marking_estimator(
      program, {.kind = exact ? MarkingOptions::Kind::exact : MarkingOptions::Kind::k_best,
                .k = exact ? k : std::max<std::size_t>(k, 40),
                .window = updates});
  if (!fast->estimate().possible) return;
  std::vector<MarkingBelief> beliefs{belief_of(*fast)};
  std::vector<reference::Told> told;
  for (const ModelInput& input : inputs) {
    if (!fast->update(input.command, input.observation).possible) return;  // groups stay by themselves
    beliefs.push_back(belief_of(*fast));
    told.emplace_back(commands_of(program, input), input.observation);
    const std::size_t length = std::min(updates, told.size());
    const MarkingBelief& from = beliefs[told.size() - length];
    if (!exact && from.size() >= 40) return;  // not all is kept
    const auto all =
        reference::trajectories(slow, from, {told.end() - static_cast<std::ptrdiff_t>(length), told.end()});
    std::vector<double> probabilities;
    for (const auto& [trajectory, probability] : all) probabilities.push_back(probability);
    std::sort(probabilities.begin(), probabilities.end(), std::greater<>());
    const auto found = fast->history();
    RC_ASSERT(found.size() == std::min(exact ? k : std::max<std::size_t>(k, 40), all.size()));
    std::set<reference::MarkingTrajectory> distinct;
    for (std::size_t i = 0; i < found.size(); ++i) {
      reference::MarkingTrajectory trajectory;
      for (const Marking& marking : found[i].markings) trajectory.push_back(set_of(marking));
      RC_ASSERT(all.contains(trajectory));
      RC_ASSERT(std::abs(all.at(trajectory) - found[i].probability) < 1e-12);
      RC_ASSERT(std::abs(probabilities[i] - found[i].probability) < 1e-12);
      RC_ASSERT(distinct.insert(trajectory).second);
    }
  }
}

/// With the probabilities that rates have in a step of that length.
automata::Plant in_steps_of(automata::Plant plant, automata::Ticks step) {
  for (automata::Component& component : plant.components) {
    for (automata::Transition& transition : component.transitions) {
      if (transition.weight.kind != automata::Weight::Kind::rate) continue;
      transition.weight = {automata::Weight::Kind::probability, transition.weight.fault_probability(step)};
    }
  }
  return plant;
}

RC_GTEST_PROP(ModelPrograms, AnUntimedPlantHasTheSameBelief, ()) {
  const automata::Ticks second{automata::Ticks::per_second};
  const Model model = *models({.timed = false, .open = chance(40)});
  const ModelProgram program = reference::as_model_program(in_steps_of(model.plant, second), {});
  automata::PlantStep step(model.plant);
  const auto plant = runtime::make_exact_estimator(step, {});
  const auto markings = runtime::make_marking_estimator(program, {.kind = MarkingOptions::Kind::exact});
  automata::Ticks now;
  for (std::size_t i = up_to(1, 5); i > 0; --i) {
    const automata::ControlAction action = *actions_of(model.plant);
    automata::Observation seen = (*logs(model.plant, 1)).lines.front().observation;
    for (const auto& entry : plant->belief()) {
      if (!step.consistent(entry.state.modes, action)) return;  // enables every guard of a plant
    }
    plant->update(action, seen, now += second);
    // A group without a step stays as it is, and the groups are not the same.
    if (!markings->update(automata::Command(action.begin(), action.end()), seen).possible) return;
    RC_ASSERT(plant->estimate().consistent == markings->estimate().explained);
    std::map<automata::Modes, double> expected, found;
    for (const auto& entry : plant->belief()) expected[entry.state.modes] += entry.probability;
    for (const auto& entry : markings->belief()) {
      automata::Modes modes;
      for (std::size_t c = 0; c < program.initial.size(); ++c) {
        const std::size_t first = program.initial[c].choice.index() + 1;
        for (const automata::LocationId l : entry.marking) {
          if (l.index() >= first && l.index() < first + model.plant.components[c].modes.size()) {
            modes.emplace_back(l.index() - first);
          }
        }
      }
      found[modes] += entry.probability;
    }
    RC_ASSERT(found.size() == expected.size());
    for (const auto& [modes, probability] : expected) {
      RC_ASSERT(found.contains(modes));
      RC_ASSERT(std::abs(found[modes] - probability) < 1e-12);
    }
  }
}

}  // namespace
}  // namespace rmpl::property
