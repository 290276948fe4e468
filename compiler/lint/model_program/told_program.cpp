// Components first, then the model programs, in their order.
// SPDX-License-Identifier: MIT
#include "compiler/lint/model_program/told_program.hpp"

#include <cstddef>
#include <utility>
#include <vector>

#include "automata/step/transition_rules.hpp"

namespace rmpl::compiler {

using automata::Component;
using automata::Control;
using automata::GuardedArc;
using automata::InitialBranch;
using automata::InitialDraw;
using automata::LocationId;
using automata::ModeId;
using automata::ModelComponent;
using automata::ModelLocation;
using automata::ModelProgram;
using automata::Plant;
using automata::Transition;
using automata::TransitionFunction;

namespace {

class Joined {
 public:
  ModelProgram run(const automata::PlantWithModels& whole) {
    const Plant& plant = whole.plant;
    made_.name = plant.name;
    made_.variables = plant.variables;
    made_.observables = plant.observables;
    made_.constraints = plant.interconnections;
    for (const Control& control : plant.controls) made_.controls.push_back({control.variable, control.idle});
    ModelLocation& root = made_.locations.emplace_back();
    root.composite = true;
    root.label = plant.name;
    for (const Component& component : plant.components) add(component);
    for (const ModelComponent& model : whole.models) add(model);
    return std::move(made_);
  }

 private:
  static void shift(LocationId& location, std::size_t offset) { location = LocationId(location.index() + offset); }
  static void shift(std::vector<GuardedArc>& arcs, std::size_t offset) {
    for (GuardedArc& arc : arcs) shift(arc.target, offset);
  }

  void add(const Component& component) {
    InitialDraw& draw = made_.initial.emplace_back();
    draw.choice = LocationId(made_.locations.size());
    ModelLocation& choice = made_.locations.emplace_back();
    choice.parent = LocationId(0);
    choice.functions.emplace_back();
    choice.label = component.name + ": initial";
    choice.origin = component.origin;
    const LocationId first(made_.locations.size());
    for (std::size_t m = 0; m < component.modes.size(); ++m) {
      ModelLocation& location = made_.locations.emplace_back();
      location.parent = LocationId(0);
      location.told =
          automata::conjunction({automata::is(component.mode, automata::ValueId(m)), component.modes[m].constraint});
      add_arcs(component, ModeId(m), first, location.functions.emplace_back());
      location.label = component.name + " = " + component.modes[m].name;
      location.origin = component.modes[m].origin;
      if (component.initial[m] > 0) draw.branches.push_back({component.initial[m], {LocationId(first.index() + m)}});
    }
  }

  static void add_arcs(const Component& component, ModeId mode, LocationId first, TransitionFunction& function) {
    const auto location_of = [&](ModeId m) { return LocationId(first.index() + m.index()); };
    function.arcs.push_back({{}, location_of(mode)});
    for (const Transition& t : component.transitions) {
      if (t.from == mode && can_ever_be_taken(t)) function.arcs.push_back({{{true, t.guard}}, location_of(t.to)});
    }
  }

  void add(const ModelComponent& model) {
    const std::size_t offset = made_.locations.size();
    for (ModelLocation location : model.program.locations) {
      if (location.parent) {
        shift(*location.parent, offset);
      } else {
        location.parent = LocationId(0);
        location.start = true;
      }
      shift(location.arcs, offset);
      for (TransitionFunction& function : location.functions) {
        for (LocationId& started : function.started) shift(started, offset);
        shift(function.arcs, offset);
      }
      location.label = model.name + ": " + location.label;
      made_.locations.push_back(std::move(location));
    }
    for (InitialDraw draw : model.program.initial) {
      shift(draw.choice, offset);
      for (InitialBranch& branch : draw.branches) {
        for (LocationId& started : branch.started) shift(started, offset);
      }
      made_.initial.push_back(std::move(draw));
    }
  }

  ModelProgram made_;
};

}  // namespace

ModelProgram told_program(const automata::PlantWithModels& whole) { return Joined().run(whole); }

}  // namespace rmpl::compiler
