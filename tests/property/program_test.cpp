// The closed loop, symbolically and tick by tick, in both readings of time.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "tests/property/draw.hpp"
#include "tests/property/generate.hpp"
#include "tests/reference/closed_loop.hpp"
#include "verifier/closed_loop/check.hpp"

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

void compare(std::optional<Ticks> period, bool chained = false) {
  Shape shape = small();
  shape.commanded = shape.commanded || chained;
  Model model = *models(shape);
  const RandomProgram program = chained ? RandomProgram{chain(model.plant)} : *programs(model.plant);
  reference::LoopQuestion question;
  question.faults = up_to(0, 1);
  question.period = period;
  question.unit = Ticks{Ticks::per_second / 2};
  question.formula = *formulas(model.plant.variables, all_variables(model.plant), 1);
  question.within = Ticks::of_seconds(static_cast<std::int64_t>(up_to(0, 4)));

  draw_rewards(model.plant);

  automata::PlantStep step(model.plant);
  const auto reconfigurer = runtime::make_reconfigurer(step);
  const auto adviser = [&](const automata::Modes& modes, const std::vector<automata::Assignment>& goal) {
    const auto answer = reconfigurer->next(modes, automata::conjunction_of(goal));
    const bool command = answer.outcome == runtime::Reconfiguration::Outcome::command;
    return reference::Advice{answer.outcome == runtime::Reconfiguration::Outcome::no_plan,
                             command ? answer.action : automata::idle_action(model.plant),
                             answer.why.purpose == runtime::Reason::Purpose::reward};
  };
  const reference::Step slow(model.plant);
  const reference::LoopAnswer expected = reference::explore_loop(program.program, slow, adviser, question);
  RC_PRE(!expected.too_many);

  const std::vector<verifier::Property> properties = {
      ProgramProperty{Kind::goal_conflict},
      ProgramProperty{Kind::no_plan},
      ProgramProperty{Kind::endless_wait},
      ProgramProperty{Kind::termination},
      ProgramProperty{Kind::never, question.formula},
      ProgramProperty{Kind::eventually, question.formula, question.within},
      ProgramProperty{Kind::finally, question.formula},
      ProgramProperty{Kind::stuck},
      ProgramProperty{Kind::undone}};
  verifier::CheckOptions options;
  options.period = period;
  options.faults = static_cast<unsigned>(question.faults);
  const std::vector<verifier::Answer> found = verifier::check(program.program, step, properties, options, {});
  const std::vector<bool> violated = {expected.conflict,      expected.no_plan, expected.waits_for_ever,
                                      expected.runs_for_ever, expected.holds,   expected.late,
                                      expected.ends_without,  expected.stops,   expected.undone};
  for (std::size_t p = 0; p < properties.size(); ++p) {
    RC_LOG() << verifier::name_of(properties[p]) << " is " << (violated[p] ? "" : "not ")
             << "violated tick by tick; formula " << automata::to_text(question.formula, model.plant.variables)
             << ", within " << question.within.count << ", faults " << question.faults << std::endl;
    RC_ASSERT(answers(found[p], violated[p]));
    // `eventually` looks on when the program has ended, and runs may stop there, which the twin does not look at.
    const bool looks_on = std::get<ProgramProperty>(properties[p]).kind == Kind::eventually;
    RC_ASSERT(expected.stops || looks_on || (!found[p].cut_off.stuck && !found[p].cut_off.still));
  }
  RC_CLASSIFY(expected.stops);
  RC_CLASSIFY(expected.undone);
  RC_TAG(expected.runs_for_ever ? "endless" : "ends");
}

RC_GTEST_PROP(ClosedLoop, DenseIsTheGrid, ()) { compare(std::nullopt); }

RC_GTEST_PROP(ClosedLoop, GoalsOneAfterAnother, ()) {
  compare(chance(50) ? std::nullopt : std::optional(Ticks{Ticks::per_second}), true);
}

RC_GTEST_PROP(ClosedLoop, SampledIsTheTicks, ()) {
  compare(pick<Ticks>({{Ticks::per_second}, {Ticks::per_second / 2}, {3 * Ticks::per_second / 4}}));
}

}  // namespace
}  // namespace rmpl::property
