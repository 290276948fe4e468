// The sequencer against Fig. 5-3 as it is printed.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

#include "automata/step/program_step.hpp"
#include "base/bounded_cache.hpp"
#include "runtime/reasoning/reconfigure/several_goals.hpp"
#include "tests/property/draw.hpp"
#include "tests/property/generate.hpp"
#include "tests/reference/sequencer.hpp"

namespace rmpl::property {
namespace {

using automata::Ticks;

void same(const automata::Goals& found, const reference::Sequencer::Goal& expected) {
  RC_ASSERT(found.goal == std::vector<automata::Assignment>(expected.assignments.begin(), expected.assignments.end()));
  RC_ASSERT(found.constraints.size() == expected.constraints.size());
  for (std::size_t c = 0; c < found.constraints.size(); ++c)
    RC_ASSERT(found.constraints[c].formula == expected.constraints[c]);
}

/// Runs both sequencers side by side; `fast` and `slow` are about the same program and model.
void compare(automata::ProgramStep& fast, reference::Sequencer& slow,
             const std::vector<std::vector<automata::Assignment>>& knowledge) {
  const auto know = [&](std::size_t cycle) {
    automata::Knowledge told{knowledge[cycle]};
    std::vector<automata::Formula> so;
    for (const automata::Formula& atom : fast.asked()) {
      told.answers.push_back(chance(50));
      if (told.answers.back()) so.push_back(atom);
    }
    slow.know(std::move(so));
    return told;
  };
  automata::Knowledge told = know(0);
  fast.reset();
  for (std::size_t cycle = 0; cycle + 1 < knowledge.size(); ++cycle) {
    const automata::Marking marking(slow.marking().begin(), slow.marking().end());
    RC_ASSERT(fast.marking() == marking);
    const Ticks now{static_cast<std::int64_t>(cycle) * Ticks::per_second / 2};
    const automata::Asserted& asserted = fast.begin(told, now);
    std::vector<reference::Sequencer::Goal> goals = slow.begin(knowledge[cycle], now);
    const bool contradictory = std::any_of(goals.begin(), goals.end(), [](const auto& g) { return g.contradictory; });
    RC_ASSERT(asserted.conflicts.empty() != contradictory);
    if (!contradictory) {
      std::erase_if(goals, [](const auto& goal) { return goal.empty(); });
      const std::vector<automata::Goals> found = runtime::goals_of(asserted);
      RC_ASSERT(found.size() == goals.size());
      for (std::size_t g = 0; g < goals.size(); ++g) same(found[g], goals[g]);
    }
    RC_ASSERT(fast.clocks() == slow.clocks());
    told = know(cycle + 1);
    fast.finish(told);
    slow.finish(knowledge[cycle + 1]);
  }
}

void compare_with_a_plant() {
  const Model model = *models();
  const RandomProgram program = chance(50) ? *programs_that_know(model.plant) : *programs(model.plant);
  const auto knowledge = *knowledge_of(model.plant, 12);
  automata::ProgramStep fast(program.program, model.plant);
  const reference::Models entailment(model.plant);
  reference::Sequencer slow(program.program, entailment);
  compare(fast, slow, knowledge);
}

RC_GTEST_PROP(Sequencer, IsFigure5_3WithAPlant, ()) { compare_with_a_plant(); }

RC_GTEST_PROP(Sequencer, IsFigure5_3WithoutCaches, ()) {
  const base::WithoutCaches forgetful;
  compare_with_a_plant();
}

RC_GTEST_PROP(Sequencer, IsFigure5_3Alone, ()) {
  const Model model = *models();
  const RandomProgram program = chance(50) ? *programs_that_know(model.plant) : *programs(model.plant);
  const auto knowledge = *knowledge_of(model.plant, 12);
  automata::ProgramStep fast(program.program);
  const reference::Models entailment(program.program.variables);
  reference::Sequencer slow(program.program, entailment);
  compare(fast, slow, knowledge);
}

}  // namespace
}  // namespace rmpl::property
