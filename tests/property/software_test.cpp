// Threads as components: what they ask of the store, and the belief over them, against the program as a whole.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "automata/software/as_components.hpp"
#include "automata/software/untold.hpp"
#include "automata/step/plant_step.hpp"
#include "automata/store/plain_store.hpp"
#include "base/limit_error.hpp"
#include "runtime/reasoning/estimate/estimator.hpp"
#include "runtime/reasoning/estimate/marking/marking_estimator.hpp"
#include "tests/property/draw.hpp"
#include "tests/property/generate.hpp"
#include "tests/property/generate_software.hpp"
#include "tests/reference/plant_as_model.hpp"

namespace rmpl::property {
namespace {

using automata::Assignment;
using automata::Formula;
using automata::LocationId;
using automata::ModelProgram;
using automata::Plant;
using automata::PlantWithModels;
using automata::ValueId;
using automata::VariableId;

const automata::Ticks second{automata::Ticks::per_second};

RC_GTEST_PROP(Software, AsksOfModesAndCommandsWhatIsNotTold, ()) {
  const Plant plant = (*models({.max_components = 3, .timed = false, .open = chance(60)})).plant;
  std::vector<VariableId> attributes;
  for (std::size_t v = 0; v < plant.variables.size(); ++v) {
    if (!plant.component_of(VariableId(v))) attributes.emplace_back(v);
  }
  if (attributes.empty()) return;
  const Formula asked = *formulas(plant.variables, attributes, 2);
  std::vector<VariableId> modes, controls;
  for (const automata::Component& component : plant.components) modes.push_back(component.mode);
  for (const automata::Control& control : plant.controls) controls.push_back(control.variable);
  automata::Untold untold(plant);
  automata::Theory theory(plant.variables);
  for (const automata::Interconnection& q : plant.interconnections) theory.tell(q.constraint);
  for (const automata::Component& component : plant.components) {
    for (std::size_t m = 0; m < component.modes.size(); ++m) {
      theory.tell_if({component.mode, ValueId(m)}, component.modes[m].constraint);
    }
  }
  for (const auto& told_modes : all_assignments(plant.variables, modes)) {
    for (const auto& command : all_assignments(plant.variables, controls)) {
      std::vector<Assignment> store = told_modes;
      store.insert(store.end(), command.begin(), command.end());
      if (!theory.consistent(store)) continue;
      const Formula answer = untold.of(asked, store.front());
      const bool told = theory.entails(store, theory.encode(asked));
      RC_ASSERT(theory.entails(store, theory.encode(answer)) == !told);
      RC_ASSERT(theory.entails(store, theory.encode(negation(answer))) == told);
      RC_ASSERT(untold.possible(told ? asked : answer, store.front()));
    }
  }
}

/// Rates as what they come to in a step.
void put_in_steps(Plant& plant) {
  for (automata::Component& component : plant.components) {
    for (automata::Transition& t : component.transitions) {
      if (t.weight.kind != automata::Weight::Kind::rate) continue;
      t.weight = {automata::Weight::Kind::probability, t.weight.fault_probability(second)};
    }
  }
}

/// What a state is: the modes of the plant's own components, and what is marked.
using State = std::pair<automata::Modes, std::set<LocationId>>;

RC_GTEST_PROP(Software, HasTheBeliefOfTheWholeProgram, ()) {
  PlantWithModels whole;
  if (chance(70)) {
    whole.plant = (*models({.max_components = 2, .max_attributes = 3, .timed = false, .open = chance(40)})).plant;
    put_in_steps(whole.plant);
  }
  const std::size_t own = whole.plant.components.size();
  add_software(whole, "s");
  if (chance(30)) add_software(whole, "t");
  std::optional<automata::SoftwarePlant> made;
  try {
    made.emplace(automata::with_software(whole));
  } catch (const base::LimitError&) {
    return;
  }
  const Plant& plant = made->plant;
  if (plant.components.empty()) return;
  const ModelProgram program = reference::as_model_program(whole.plant, whole.models);
  std::vector<std::size_t> offsets;  // of the programs' locations
  std::size_t offset = 1;
  for (std::size_t c = 0; c < own; ++c) offset += 1 + plant.components[c].modes.size();
  for (const automata::ModelComponent& model : whole.models) {
    offsets.push_back(offset);
    offset += model.program.locations.size();
  }
  automata::PlantStep step(plant);
  if (!step.theory().consistent({})) return;
  const auto markings = runtime::make_marking_estimator(program, {.kind = runtime::MarkingOptions::Kind::exact});
  if (!markings->estimate().possible) return;
  const auto components = runtime::make_exact_estimator(step, {});
  const LikeMarkings like(*made, offsets);
  const auto compare = [&] {
    std::map<State, double> expected, found;
    for (const auto& entry : components->belief()) {
      State state;
      for (std::size_t c = 0; c < own; ++c) state.first.push_back(entry.state.modes[c]);
      for (std::size_t t = 0; t < made->threads.size(); ++t) {
        const automata::SoftwareThread& thread = made->threads[t];
        for (const LocationId l : thread.markings[entry.state.modes[own + t].index()].front()) {
          state.second.insert(LocationId(l.index() + offsets[thread.model]));
        }
      }
      found[state] += entry.probability;
    }
    for (const auto& entry : markings->belief()) {
      State state;
      for (std::size_t c = 0; c < own; ++c) {
        const std::size_t first = program.initial[c].choice.index() + 1;
        for (const LocationId l : entry.marking) {
          if (l.index() < first || l.index() >= first + plant.components[c].modes.size()) continue;
          state.first.emplace_back(l.index() - first);
        }
      }
      state.second = like.first({entry.marking.begin(), entry.marking.end()});
      expected[state] += entry.probability;
    }
    RC_ASSERT(found.size() == expected.size());
    for (const auto& [state, probability] : expected) {
      RC_ASSERT(found.contains(state));
      RC_ASSERT(std::abs(found.at(state) - probability) < 1e-12);
    }
  };
  compare();
  automata::Ticks now;
  for (std::size_t i = up_to(1, 4); i > 0; --i) {
    const automata::ControlAction action = *actions_of(plant);
    const automata::Observation seen = (*logs(plant, 1)).lines.front().observation;
    for (const auto& entry : components->belief()) {
      if (!step.consistent(entry.state.modes, action)) return;  // enables every guard of a plant
    }
    components->update(action, seen, now += second);
    if (!markings->update(automata::Command(action.begin(), action.end()), seen).possible) return;
    if (!components->estimate().consistent || !markings->estimate().explained) return;  // groups set readings aside
    compare();
    RC_CLASSIFY(true, "a step compared");
    RC_CLASSIFY(own > 0, "a step beside hardware");
    RC_CLASSIFY(components->belief().size() > 1, "several states");
  }
}

}  // namespace
}  // namespace rmpl::property
