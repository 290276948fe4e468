// What the reconfigurer says beside what the game allows, along runs of plants as engineers write them.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "automata/step/plant_step.hpp"
#include "tests/property/advice.hpp"
#include "tests/property/draw.hpp"
#include "tests/property/engineered.hpp"
#include "tests/property/generate.hpp"
#include "tests/property/seconds.hpp"
#include "tests/reference/step.hpp"

namespace rmpl::property {
namespace {

/// All groups and rewards together: nothing forbidden is sent, what can be kept is kept, and *no plan* is said only
/// where there is no hope.
RC_GTEST_PROP(Executive, DoesWhatIsAllowed, ()) {
  const Engineered drawn = *engineered(2, 5);
  RC_LOG() << rc::toString(drawn) << std::endl;
  automata::PlantStep step(drawn.plant);
  const auto reconfigurer = runtime::make_reconfigurer(step, nullptr, automata::Ticks{automata::Ticks::per_second});
  reference::Executive executive(drawn.plant);
  automata::Modes modes = drawn.start;
  try {
    for (int cycle = 0; cycle < 8; ++cycle) {
      const reference::Advice chosen = told(reconfigurer->next(modes, drawn.goal));
      RC_LOG() << rc::toString(modes) << (chosen.no_plan ? ": no plan " : ": ") << rc::toString(chosen.action)
               << (chosen.for_reward ? " for reward" : "") << std::endl;
      RC_ASSERT(executive.fits(modes, drawn.goal, chosen));
      const auto next = executive.outcomes(modes, drawn.goal, chosen.action);
      if (next.empty()) break;
      modes = pick(next);
    }
  } catch (const reference::GameTooLarge&) {
    RC_DISCARD();
  }
}

/// Whatever was asked before.
RC_GTEST_PROP(Executive, AnswersTheQuestionAlone, ()) {
  Shape shape;
  shape.max_components = 3;
  shape.max_attributes = 4;
  shape.commanded = chance(50);
  shape.tangled = chance(50);
  shape.rewards = chance(50);
  const Model model = *models(shape);
  const reference::Step slow(model.plant);
  automata::PlantStep step(model.plant);
  const auto graph = runtime::reconfiguration_graph(model.plant);
  const auto reconfigurer = runtime::make_reconfigurer(step, graph);
  automata::Formula goal = automata::constant(true);
  for (int question = 0; question < 10; ++question) {
    const automata::Modes modes = *modes_of(model.plant);
    if (question % 5 == 0) {
      const automata::Component& component = pick(model.plant.components);
      goal = is(component.mode, automata::ValueId(up_to(0, component.modes.size() - 1)));
    }
    if (!slow.possible(modes)) continue;
    automata::PlantStep fresh_step(model.plant);
    const auto fresh = runtime::make_reconfigurer(fresh_step, graph);
    const runtime::Reconfiguration known = reconfigurer->next(modes, goal);
    const runtime::Reconfiguration alone = fresh->next(modes, goal);
    RC_LOG() << automata::to_text(goal, model.plant.variables) << " from " << rc::toString(modes) << ": "
             << rc::toString(known.action) << known.reason << ", alone " << rc::toString(alone.action) << alone.reason
             << std::endl;
    RC_ASSERT(known.outcome == alone.outcome);
    RC_ASSERT(known.action == alone.action);
    RC_ASSERT(known.expected == alone.expected);
    RC_ASSERT(known.goal_state == alone.goal_state);
    RC_ASSERT(known.why == alone.why);
    RC_ASSERT(known.reason == alone.reason);
  }
}

}  // namespace
}  // namespace rmpl::property
