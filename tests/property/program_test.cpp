// The closed loop, symbolically and tick by tick, in both readings of time.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <map>
#include <memory>
#include <utility>
#include <vector>

#include "base/bounded_cache.hpp"
#include "tests/property/advice.hpp"
#include "tests/property/draw.hpp"
#include "tests/property/generate.hpp"
#include "tests/property/rounds.hpp"
#include "tests/reference/closed_loop.hpp"
#include "verifier/closed_loop/check.hpp"
#include "verifier/closed_loop/each_fault.hpp"
#include "verifier/verdict/report.hpp"

namespace rmpl::property {
namespace {

using automata::Ticks;
using verifier::ProgramProperty;
using verifier::Verdict;
using Kind = ProgramProperty::Kind;

/// Small enough to be counted out tick by tick.
Shape small() {
  Shape shape;
  shape.max_components = 2;
  shape.max_attributes = 3;
  shape.commanded = chance(50);
  shape.tangled = chance(50);
  return shape;
}

/// Housekeeping needs something to gain.
void draw_rewards(automata::Plant& plant) {
  if (chance(30)) return;
  for (automata::Component& component : plant.components) {
    for (automata::Mode& mode : component.modes) mode.reward = static_cast<double>(up_to(0, 3));
  }
}

/// Where time stands still what does not end or come is violated, though no time shows it, and of all else that is not
/// nothing can be told.
bool answers(const verifier::Answer& found, bool violated) {
  if (violated) return found.verdict == Verdict::violated;
  if (found.witness) return found.witness->stop && found.witness->stop->still;
  return found.verdict == (found.cut_off.still ? Verdict::undecided : Verdict::holds);
}

/// One goal after another, each until it is achieved.
automata::Program chain(const automata::Plant& plant) {
  automata::Program program;
  program.name = "Chain";
  program.variables = plant.variables;
  const automata::LocationId root(std::size_t{0});
  program.locations.emplace_back();
  program.locations.front().composite = program.locations.front().start = true;
  const std::size_t goals = up_to(2, 3);
  for (std::size_t g = 1; g <= goals; ++g) {
    const automata::Component& component = pick(plant.components);
    automata::Location location;
    location.parent = root;
    location.start = g == 1;
    location.goal = {{component.mode, automata::ValueId(up_to(0, component.modes.size() - 1))}};
    const automata::Formula achieved = automata::conjunction_of(location.goal);
    location.arcs.push_back({{false, achieved}, automata::LocationId(g)});
    if (g < goals) location.arcs.push_back({{true, achieved}, automata::LocationId(g + 1)});
    program.locations.push_back(std::move(location));
  }
  return program;
}

/// A program whose conditions ask of the executive's knowledge; its goals are modes, all asked for together.
automata::Program that_knows(const automata::Plant& plant) {
  automata::Program program = (*programs_that_know(plant)).program;
  for (automata::Location& location : program.locations) {
    location.apart = false;
    location.goal_constraints.clear();
  }
  return program;
}

enum class Programs { any, chained, knowing };

void compare(std::optional<Ticks> period, Programs kind = Programs::any) {
  Shape shape = small();
  shape.commanded = shape.commanded || kind == Programs::chained;
  Model model = *models(shape);
  const RandomProgram program = kind == Programs::chained   ? RandomProgram{chain(model.plant)}
                                : kind == Programs::knowing ? RandomProgram{that_knows(model.plant)}
                                                            : *programs(model.plant);
  reference::LoopQuestion question;
  question.faults = up_to(0, 1);
  question.period = period;
  question.unit = Ticks{Ticks::per_second / 2};
  question.formula = *formulas(model.plant.variables, all_variables(model.plant), 1);
  question.then = *formulas(model.plant.variables, all_variables(model.plant), 1);
  question.within = Ticks::of_seconds(static_cast<std::int64_t>(up_to(0, 4)));

  draw_rewards(model.plant);

  automata::PlantStep step(model.plant);
  const auto reconfigurer = runtime::make_reconfigurer(step, nullptr, period.value_or(Ticks{0}));
  const reference::Step slow(model.plant);
  const reference::Adviser adviser = adviser_of(*reconfigurer);
  const reference::LoopAnswer expected = reference::explore_loop(program.program, slow, adviser, question);
  RC_PRE(!expected.too_many);

  const std::vector<verifier::Property> properties = {
      ProgramProperty{Kind::goal_conflict},
      ProgramProperty{Kind::no_plan},
      ProgramProperty{Kind::endless_wait},
      ProgramProperty{Kind::termination},
      ProgramProperty{Kind::never, question.formula},
      ProgramProperty{Kind::eventually, question.formula, question.within},
      ProgramProperty{
          .kind = Kind::response, .formula = question.formula, .within = question.within, .then = question.then},
      ProgramProperty{Kind::finally, question.formula},
      ProgramProperty{Kind::stuck},
      ProgramProperty{Kind::undone},
      ProgramProperty{Kind::eventually, question.formula, Ticks::infinite()},
      ProgramProperty{
          .kind = Kind::response, .formula = question.formula, .within = Ticks::infinite(), .then = question.then}};
  verifier::CheckOptions options;
  options.period = period;
  options.faults = static_cast<unsigned>(question.faults);
  RC_LOG() << "formula " << automata::to_text(question.formula, model.plant.variables) << ", within "
           << question.within.count << ", faults " << question.faults << std::endl;
  const std::vector<verifier::Answer> found = verifier::check(program.program, step, properties, options, {});
  const std::vector<bool> violated = {expected.conflict,      expected.no_plan,      expected.waits_for_ever,
                                      expected.runs_for_ever, expected.holds,        expected.late,
                                      expected.missed,        expected.ends_without, expected.stops,
                                      expected.undone,        expected.never_comes,  expected.never_answered};
  for (std::size_t p = 0; p < properties.size(); ++p) {
    RC_LOG() << verifier::name_of(properties[p]) << " is " << (violated[p] ? "" : "not ") << "violated tick by tick"
             << std::endl;
    RC_ASSERT(answers(found[p], violated[p]));
    // These look on when the program has ended, and runs may stop there, which the twin does not look at.
    const Kind asked = std::get<ProgramProperty>(properties[p]).kind;
    const bool looks_on = asked == Kind::eventually || asked == Kind::response;
    RC_ASSERT(expected.stops || looks_on || (!found[p].cut_off.stuck && !found[p].cut_off.still));
  }
  RC_CLASSIFY(expected.stops);
  RC_CLASSIFY(expected.undone);
  RC_TAG(expected.runs_for_ever ? "endless" : "ends");
}

RC_GTEST_PROP(ClosedLoop, DenseIsTheGrid, ()) { compare(std::nullopt); }

RC_GTEST_PROP(ClosedLoop, GoalsOneAfterAnother, ()) {
  compare(chance(50) ? std::nullopt : std::optional(Ticks{Ticks::per_second}), Programs::chained);
}

RC_GTEST_PROP(ClosedLoop, ConditionsOnKnowledgeAreJudgedByTheTruth, ()) {
  compare(chance(50) ? std::nullopt : std::optional(Ticks{Ticks::per_second}), Programs::knowing);
}

RC_GTEST_PROP(ClosedLoop, SampledIsTheTicks, ()) {
  compare(pick<Ticks>({{Ticks::per_second}, {Ticks::per_second / 2}, {3 * Ticks::per_second / 4}}));
}

/// A dense proof is about the limit of ever shorter cycles: cycles that are short against all bounds, of which the
/// least is a second, bear it out, unless it rests on rounds that take no time.
RC_GTEST_PROP(ClosedLoop, ShortCyclesBearOutThatNothingGetsStuck, ()) {
  Shape shape = small();
  shape.tangled = true;
  Model model = *models(shape);
  // A fault that is certain within less than a cycle is drawn in no cycle, as none ends there.
  for (automata::Component& component : model.plant.components) {
    for (automata::Transition& t : component.transitions) {
      if (component.is_fault(t) && t.timing && t.timing->upper.count < Ticks::per_second) t.timing.reset();
    }
  }
  const RandomProgram program = *programs(model.plant);
  automata::PlantStep step(model.plant);
  verifier::CheckOptions options;
  options.faults = static_cast<unsigned>(up_to(0, 1));
  verifier::Limits limits;
  limits.states = 20'000;
  const auto ask = [&](std::optional<Ticks> period) {
    options.period = period;
    return verifier::check(program.program, step, {ProgramProperty{Kind::stuck}}, options, limits).front();
  };
  const verifier::Answer dense = ask(std::nullopt);
  RC_CLASSIFY(dense.witness.has_value());
  for (const Ticks cycle : {Ticks{Ticks::per_second / 8}, Ticks{Ticks::per_second / 1000}}) {
    const verifier::Answer sampled = ask(cycle);
    RC_CLASSIFY(sampled.witness.has_value());
    RC_LOG() << "cycle " << automata::format_seconds(cycle) << " s" << std::endl;
    if (dense.verdict != Verdict::holds) continue;
    RC_ASSERT(sampled.verdict != Verdict::violated || goes_round_at_once(model.plant));
  }
}

std::optional<Ticks> some_period() { return chance(50) ? std::nullopt : std::optional(Ticks{Ticks::per_second}); }

/// Something that does not hold from the start on, as often as not.
automata::Formula some_modes(const automata::Plant& plant, const automata::Component& component) {
  std::vector<automata::Formula> modes;
  for (std::size_t m = 0; m < component.modes.size(); ++m) {
    if (component.modes[m].fault || chance(30)) {
      modes.push_back(
          automata::conjunction_of(std::vector{automata::Assignment{component.mode, automata::ValueId(m)}}));
    }
  }
  return modes.empty() ? *formulas(plant.variables, all_variables(plant), 1) : automata::disjunction(std::move(modes));
}

/// The soonest violation is one at its own time, and there is none before.
RC_GTEST_PROP(ClosedLoop, TheSoonestViolationIsTheFirstInAnyWindow, ()) {
  Model model = *models(small());
  const RandomProgram program = *programs(model.plant);
  draw_rewards(model.plant);
  automata::PlantStep step(model.plant);
  verifier::CheckOptions options;
  options.period = some_period();
  options.faults = static_cast<unsigned>(up_to(0, 1));
  ProgramProperty never{Kind::never, some_modes(model.plant, pick(model.plant.components))};
  const auto ask = [&] { return verifier::check(program.program, step, {never}, options, {}).front(); };
  const verifier::Answer any = ask();
  never.fastest = true;
  const verifier::Answer soonest = ask();
  RC_ASSERT(any.witness.has_value() == soonest.witness.has_value());
  RC_PRE(soonest.witness.has_value());
  const Ticks time = soonest.witness->events.back().time;
  RC_LOG() << "soonest at " << automata::format_seconds(time) << " s" << std::endl;
  RC_ASSERT(time <= any.witness->events.back().time);
  never.fastest = false;
  never.window.by = time;
  RC_ASSERT(ask().witness.has_value());
  never.window.not_before = time;
  RC_ASSERT(ask().witness.has_value());
  RC_CLASSIFY(Ticks{0} < time);
  if (time == Ticks{0}) return;
  never.window = {std::nullopt, time - Ticks{1}};
  RC_ASSERT(!ask().witness);
}

/// Each set of fault modes, by itself, leads there or not: the cut sets are the smallest that do.
RC_GTEST_PROP(ClosedLoop, CutSetsAreTheSmallestThatLeadThere, ()) {
  Model model = *models(small());
  const RandomProgram program = *programs(model.plant);
  draw_rewards(model.plant);
  using FaultMode = std::pair<std::size_t, automata::ModeId>;
  std::vector<FaultMode> faults;
  for (std::size_t c = 0; c < model.plant.components.size(); ++c) {
    const auto& modes = model.plant.components[c].modes;
    for (std::size_t m = 0; m < modes.size(); ++m) {
      if (modes[m].fault) faults.emplace_back(c, automata::ModeId(m));
    }
  }
  RC_PRE(!faults.empty() && faults.size() <= 3);
  reference::LoopQuestion question;
  question.faults = up_to(1, 2);
  question.period = some_period();
  question.unit = Ticks{Ticks::per_second / 2};
  std::vector<automata::Formula> both;
  for (const automata::Component& component : model.plant.components)
    both.push_back(some_modes(model.plant, component));
  question.formula = chance(50) ? automata::conjunction(std::move(both)) : automata::disjunction(std::move(both));
  automata::PlantStep step(model.plant);
  const auto reconfigurer = runtime::make_reconfigurer(step, nullptr, question.period.value_or(Ticks{0}));
  const reference::Step slow(model.plant);
  const reference::Adviser adviser = adviser_of(*reconfigurer);
  std::vector<std::set<FaultMode>> expected;
  for (std::size_t size = 0; size <= faults.size(); ++size) {
    for (std::size_t chosen = 0; chosen < std::size_t{1} << faults.size(); ++chosen) {
      std::set<FaultMode> set;
      for (std::size_t f = 0; f < faults.size(); ++f) {
        if ((chosen >> f & 1U) != 0) set.insert(faults[f]);
      }
      const bool smaller = std::any_of(expected.begin(), expected.end(), [&](const std::set<FaultMode>& known) {
        return std::includes(set.begin(), set.end(), known.begin(), known.end());
      });
      if (set.size() != size || smaller) continue;
      question.faults_allowed = set;
      const reference::LoopAnswer answer = reference::explore_loop(program.program, slow, adviser, question);
      RC_PRE(!answer.too_many);
      if (answer.holds) expected.push_back(set);
    }
  }
  verifier::CheckOptions options;
  options.period = question.period;
  options.faults = static_cast<unsigned>(question.faults);
  options.cut_sets = true;
  const std::vector<verifier::Property> never = {ProgramProperty{Kind::never, question.formula}};
  const verifier::Answer found = verifier::check(program.program, step, never, options, {}).front();
  const auto sets_of = [](const verifier::Answer& answer) {
    std::vector<std::set<FaultMode>> sets;
    for (const verifier::CutSet& cut : answer.cut_sets) {
      sets.emplace_back();
      for (const verifier::Fault& fault : cut.faults) sets.back().emplace(fault.component.index(), fault.mode);
    }
    std::sort(sets.begin(), sets.end());
    return sets;
  };
  std::sort(expected.begin(), expected.end());
  RC_ASSERT(sets_of(found) == expected);
  verifier::Limits limits;
  limits.states = *rc::gen::inRange<std::size_t>(1, 2 + found.progress.states);
  const auto cut_short = sets_of(verifier::check(program.program, step, never, options, limits).front());
  RC_ASSERT(std::includes(expected.begin(), expected.end(), cut_short.begin(), cut_short.end()));
  RC_ASSERT(found.witness.has_value() == !expected.empty());
  RC_TAG(expected.empty() ? "none" : expected.front().empty() ? "no fault needed" : "faults");
}

/// Everything that can be asked, of one formula.
std::vector<verifier::Property> all_about(const automata::Formula& formula, Ticks within) {
  std::vector<verifier::Property> result;
  for (const Kind kind : {Kind::goal_conflict, Kind::no_plan, Kind::endless_wait, Kind::termination, Kind::stuck,
                          Kind::undone, Kind::never, Kind::eventually, Kind::finally}) {
    result.emplace_back(ProgramProperty{kind, formula, within});
  }
  result.emplace_back(ProgramProperty{.kind = Kind::response, .formula = formula, .within = within});
  return result;
}

/// What a question was answered, but for what it has cost.
std::string without_statistics(nlohmann::ordered_json json) {
  json.erase("statistics");
  return json.dump(1);
}

/// What one search leaves for the next changes no verdict, no witness and no number of states.
RC_GTEST_PROP(ClosedLoop, WhatIsRememberedChangesNothing, ()) {
  Model model = *models(small());
  const RandomProgram program = *programs(model.plant);
  draw_rewards(model.plant);
  const verifier::Subject subject{model.plant, &program.program};
  const auto properties = all_about(some_modes(model.plant, pick(model.plant.components)),
                                    Ticks::of_seconds(static_cast<std::int64_t>(up_to(0, 4))));
  verifier::CheckOptions options;
  options.period = some_period();
  options.faults = static_cast<unsigned>(up_to(0, 2));
  options.fewest_faults = chance(50);
  const auto ask = [&] {
    automata::PlantStep step(model.plant);
    const verifier::FaultTable table = verifier::check_each_fault(program.program, step, properties, options, {});
    const auto answers = verifier::check(program.program, step, properties, options, {});
    const verifier::ProgramQuestion question{properties, options};
    return std::tuple(without_statistics(verifier::to_json(subject, question, table)), table.progress.states,
                      without_statistics(verifier::to_json(subject, question, answers)),
                      answers.back().progress.states);
  };
  const auto remembered = ask();
  const base::WithoutCaches off;
  RC_ASSERT(ask() == remembered);
}

}  // namespace
}  // namespace rmpl::property
