// The sequencer against Fig. 5-3 as it is printed.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "automata/step/program_step.hpp"
#include "base/bounded_cache.hpp"
#include "tests/property/generate.hpp"
#include "tests/reference/sequencer.hpp"

namespace rmpl::property {
namespace {

using automata::Ticks;

/// Runs both sequencers side by side; `fast` and `slow` are about the same program and model.
void compare(automata::ProgramStep& fast, reference::Sequencer& slow,
             const std::vector<std::vector<automata::Assignment>>& knowledge) {
  fast.reset();
  for (std::size_t cycle = 0; cycle + 1 < knowledge.size(); ++cycle) {
    const automata::Marking marking(slow.marking().begin(), slow.marking().end());
    RC_ASSERT(fast.marking() == marking);
    const Ticks now{static_cast<std::int64_t>(cycle) * Ticks::per_second / 2};
    const automata::Asserted& asserted = fast.begin({knowledge[cycle]}, now);
    const reference::Sequencer::Goal goal = slow.begin(knowledge[cycle], now);
    RC_ASSERT(asserted.conflicts.empty() != goal.contradictory);
    if (!goal.contradictory)
      RC_ASSERT(asserted.goal == std::vector<automata::Assignment>(goal.assignments.begin(), goal.assignments.end()));
    RC_ASSERT(fast.clocks() == slow.clocks());
    fast.finish({knowledge[cycle + 1]});
    slow.finish(knowledge[cycle + 1]);
  }
}

void compare_with_a_plant() {
  const Model model = *models();
  const RandomProgram program = *programs(model.plant);
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
  const RandomProgram program = *programs(model.plant);
  const auto knowledge = *knowledge_of(model.plant, 12);
  automata::ProgramStep fast(program.program);
  const reference::Models entailment(program.program.variables);
  reference::Sequencer slow(program.program, entailment);
  compare(fast, slow, knowledge);
}

}  // namespace
}  // namespace rmpl::property
