// Evidence of diagnoses: right, and minimal, as a store that knows nothing else says.
// SPDX-License-Identifier: MIT
#include "runtime/reasoning/explain/evidence.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "tests/property/draw.hpp"
#include "tests/property/generate.hpp"
#include "tests/property/parts.hpp"
#include "tests/reference/step.hpp"

namespace rmpl::property {
namespace {

/// A part of what evidence lists, as a formula.
std::vector<automata::Formula> parts_of(const runtime::Evidence& evidence, const automata::Plant& plant) {
  std::vector<automata::Formula> parts;
  for (const automata::Assignment& reading : evidence.readings) {
    parts.push_back(automata::is(reading.variable, reading.value));
  }
  for (const automata::ComponentId c : evidence.modes) {
    const automata::ModeId mode = evidence.story[c.index()];
    parts.push_back(automata::conjunction(
        {automata::is(plant[c].mode, automata::ValueId(mode.index())), plant[c].modes[mode.index()].constraint}));
  }
  for (const std::size_t i : evidence.interconnections) parts.push_back(plant.interconnections[i].constraint);
  return parts;
}

RC_GTEST_PROP(Evidence, RefutesAndNothingOfItCanBeSpared, ()) {
  const Model model = *models({.open = chance(50)});
  const automata::Plant& plant = model.plant;
  const reference::Step slow(plant);
  runtime::Evidences evidences(plant);
  const Log log = *logs(plant, 6);
  for (const LogLine& line : log.lines) {
    const automata::Modes story = *modes_of(plant);
    const automata::Modes estimate = *modes_of(plant);
    const automata::ComponentId component(up_to(0, plant.components.size() - 1));
    const runtime::Evidence evidence = evidences.of(component, estimate, story, line.observation);
    const bool refuted = evidence.kind == runtime::Evidence::Kind::refuted;
    RC_TAG(refuted ? "refuted" : "outweighed");
    RC_ASSERT(refuted == !slow.explains(story, line.observation));
    if (!refuted) {
      for (const automata::Assignment& reading : evidence.readings) {
        RC_ASSERT(slow.observation_factor(story, {reading}) < 1);
        RC_ASSERT(!slow.possible(estimate) || slow.observation_factor(estimate, {reading}) == 1);
      }
      continue;
    }
    const auto parts = parts_of(evidence, plant);
    RC_ASSERT(!consistent(plant, parts, parts.size()));
    for (std::size_t i = 0; i < parts.size(); ++i) RC_ASSERT(consistent(plant, parts, i));
  }
}

}  // namespace
}  // namespace rmpl::property
