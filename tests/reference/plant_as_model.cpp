// The moves of a mode depend on which guards hold, the draw does not: [0, 1] is cut where the moves under any guards
// are cut, and each piece is a function with an arc for whatever the guards may say.
// SPDX-License-Identifier: MIT
#include "tests/reference/plant_as_model.hpp"

#include <algorithm>
#include <cstddef>
#include <set>
#include <vector>

#include "automata/step/transition_rules.hpp"

namespace rmpl::reference {

using automata::Component;
using automata::Condition;
using automata::Control;
using automata::Enabled;
using automata::Formula;
using automata::GuardedArc;
using automata::InitialBranch;
using automata::InitialDraw;
using automata::LocationId;
using automata::ModeId;
using automata::ModelComponent;
using automata::ModelLocation;
using automata::ModelProgram;
using automata::Move;
using automata::Plant;
using automata::Ticks;
using automata::Transition;
using automata::TransitionFunction;
using automata::TransitionId;
using automata::ValueId;

namespace {

/// The guards out of a mode that are to be asked for, each once.
std::vector<Formula> guards_of(const Component& component, ModeId mode) {
  std::vector<Formula> result;
  for (const Transition& transition : component.transitions) {
    if (transition.from != mode || !can_ever_be_taken(transition) || transition.guard.is_true()) continue;
    if (std::find(result.begin(), result.end(), transition.guard) == result.end()) result.push_back(transition.guard);
  }
  return result;
}

/// The functions of the location of a mode.
class Functions {
 public:
  Functions(const Component& component, ModeId mode, LocationId first)
      : first_(first), guards_(guards_of(component, mode)) {
    for (std::size_t held = 0; held < (std::size_t{1} << guards_.size()); ++held) {
      const Enabled enabled = enabled_in(component, mode, [&](TransitionId t) {
        const Formula& guard = component.transitions[t.index()].guard;
        const auto place = std::find(guards_.begin(), guards_.end(), guard) - guards_.begin();
        return guard.is_true() || (held >> place & 1) != 0;
      });
      auto& moves = moves_.emplace_back(moves_of(component, mode, enabled, {}, Ticks::of_seconds(1)));
      // The least likely first: behind a likelier one it would be lost to rounding.
      std::stable_sort(moves.begin(), moves.end(),
                       [](const Move& a, const Move& b) { return a.probability < b.probability; });
    }
  }

  std::vector<TransitionFunction> run() {
    std::set<double> cuts;
    for (const std::vector<Move>& moves : moves_) {
      double sum = 0;
      for (std::size_t m = 0; m + 1 < moves.size(); ++m) cuts.insert(sum += moves[m].probability);
    }
    cuts.insert(1.0);
    std::vector<TransitionFunction> result;
    double before = 0;
    for (const double cut : cuts) {
      TransitionFunction& function = result.emplace_back();
      function.probability = cut - before;
      add_arcs(0, guards_.size(), (before + cut) / 2, {}, function.arcs);
      before = cut;
    }
    return result;
  }

 private:
  [[nodiscard]] ModeId target(std::size_t held, double drawn) const {
    double sum = 0;
    for (const Move& move : moves_[held]) {
      sum += move.probability;
      if (sum >= drawn) return move.mode;
    }
    return moves_[held].back().mode;
  }

  /// Arcs for all guards that agree with `held` from guard `open` on; what does not matter is not asked.
  void add_arcs(std::size_t held, std::size_t open, double drawn, const std::vector<Condition>& guard,
                std::vector<GuardedArc>& arcs) const {
    const ModeId first = target(held, drawn);
    bool same = true;
    for (std::size_t more = 1; more < (std::size_t{1} << open); ++more)
      same = same && target(held | more, drawn) == first;
    if (same) {
      arcs.push_back({guard, LocationId(first_.index() + first.index())});
      return;
    }
    for (const bool holds : {false, true}) {
      std::vector<Condition> longer = guard;
      longer.push_back({holds, guards_[open - 1]});
      add_arcs(held | (holds ? std::size_t{1} << (open - 1) : 0), open - 1, drawn, longer, arcs);
    }
  }

  LocationId first_;  ///< of the component's modes
  std::vector<Formula> guards_;
  std::vector<std::vector<Move>> moves_;  ///< by which guards hold
};

class Embedding {
 public:
  ModelProgram run(const Plant& plant, std::span<const ModelComponent> models) {
    made_.name = plant.name;
    made_.variables = plant.variables;
    made_.observables = plant.observables;
    made_.constraints = plant.interconnections;
    for (const Control& control : plant.controls) made_.controls.push_back({control.variable, control.idle});
    ModelLocation& root = made_.locations.emplace_back();
    root.composite = true;
    root.label = plant.name;
    for (const Component& component : plant.components) add(component);
    for (const ModelComponent& model : models) add(model);
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
      location.told = automata::conjunction({is(component.mode, ValueId(m)), component.modes[m].constraint});
      location.functions = Functions(component, ModeId(m), first).run();
      location.label = component.name + " = " + component.modes[m].name;
      location.origin = component.modes[m].origin;
      if (component.initial[m] > 0) draw.branches.push_back({component.initial[m], {LocationId(first.index() + m)}});
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

ModelProgram as_model_program(const Plant& plant, std::span<const ModelComponent> models) {
  return Embedding().run(plant, models);
}

}  // namespace rmpl::reference
