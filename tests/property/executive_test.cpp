// What the reconfigurer says beside what the rules allow, in any state of random plants.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <map>

#include "tests/property/advice.hpp"
#include "tests/property/draw.hpp"

namespace rmpl::property {
namespace {

/// One or two parts, as programs ask for.
reference::Executive::Goal draw_goal(const automata::Plant& plant) {
  std::map<automata::VariableId, automata::ValueId> parts;
  for (std::size_t i = up_to(1, 2); i > 0; --i) {
    const automata::Component& component = pick(plant.components);
    parts[component.mode] = automata::ValueId(up_to(0, component.modes.size() - 1));
  }
  reference::Executive::Goal goal;
  for (const auto& [variable, value] : parts) goal.push_back({variable, value});
  return goal;
}

RC_GTEST_PROP(Executive, DoesWhatIsAllowed, ()) {
  Shape shape;
  shape.max_components = chance(30) ? 3 : 2;
  shape.max_attributes = 3;
  shape.commanded = chance(50);
  shape.tangled = chance(50);
  shape.rewards = chance(50);
  const Model model = *models(shape);
  const reference::Step slow(model.plant);
  reference::Executive executive(slow);
  automata::PlantStep step(model.plant);
  const auto reconfigurer = runtime::make_reconfigurer(step);
  int choices = 0;
  for (int question = 0; question < 6; ++question) {
    const automata::Modes modes = *modes_of(model.plant);
    const auto goal = draw_goal(model.plant);
    if (!slow.possible(modes)) continue;
    advised(executive, *reconfigurer, model.plant, modes, goal);
    choices += executive.allowed(modes, goal).size() > 1 ? 1 : 0;
  }
  RC_CLASSIFY(choices == 0);
  RC_CLASSIFY(choices > 3);
}

}  // namespace
}  // namespace rmpl::property
