// Random programs as automata, and what a sequencer may be told while it runs them.
// SPDX-License-Identifier: MIT
#include <algorithm>

#include "automata/json/document.hpp"
#include "tests/property/draw.hpp"
#include "tests/property/generate.hpp"
#include "tests/reference/step.hpp"

namespace rmpl::property {

using automata::Assignment;
using automata::ClockId;
using automata::Condition;
using automata::Formula;
using automata::Location;
using automata::LocationId;
using automata::Ticks;

namespace {

class ProgramDraw {
 public:
  /// `knows`: with branches of `each`, goals of any form and what conditions ask of the executive's knowledge.
  ProgramDraw(const automata::Plant& plant, bool knows) : plant_(plant), knows_(knows) {
    program_.name = "Random";
    program_.variables = plant.variables;
    program_.clocks = {"t0", "t1"};
  }

  automata::Program draw() {
    add_composite(std::nullopt, 2);
    for (Location& location : program_.locations) add_arcs(location);
    keep_own_clocks_inside();
    return std::move(program_);
  }

 private:
  void add_composite(std::optional<LocationId> parent, int depth) {
    const LocationId self(program_.locations.size());
    Location location;
    location.composite = true;
    location.parent = parent;
    location.start = !parent || chance(60);
    location.label = "composite";
    location.apart = knows_ && parent && chance(40);
    if (chance(40)) location.maintenance = condition();
    if (chance(30) && owned_ < program_.clocks.size()) location.own_clocks.emplace_back(owned_++);
    program_.locations.push_back(std::move(location));
    const std::size_t children = up_to(1, 4);
    const std::size_t first = program_.locations.size();
    for (std::size_t i = 0; i < children; ++i) {
      if (depth > 0 && chance(30))
        add_composite(self, depth - 1);
      else
        add_primitive(self);
    }
    program_.locations[first].start = true;
  }

  void add_primitive(LocationId parent) {
    Location location;
    location.parent = parent;
    location.start = chance(60);
    location.label = "primitive";
    if (chance(50)) location.goal.push_back(mode_assignment());
    if (knows_ && chance(20))
      location.goal_constraints.push_back(*formulas(program_.variables, all_variables(plant_), 1));
    if (chance(25)) location.clock_start = ClockId(up_to(0, program_.clocks.size() - 1));
    if (chance(15)) location.maintenance = condition();
    program_.locations.push_back(std::move(location));
  }

  void add_arcs(Location& location) {
    const std::size_t arcs = location.parent ? up_to(0, 3) : 0;
    for (std::size_t i = 0; i < arcs; ++i) {
      // Mostly to a sibling, as the compiler makes them; a tail call may lead anywhere but to the program itself.
      std::vector<LocationId> siblings;
      std::vector<LocationId> all;
      for (std::size_t target = 1; target < program_.locations.size(); ++target) {
        all.emplace_back(target);
        if (program_.locations[target].parent == location.parent) siblings.emplace_back(target);
      }
      location.arcs.push_back({chance(50) ? condition() : Condition{}, pick(chance(85) ? siblings : all)});
    }
  }

  /// Nothing outside of a definition can name its clock, so as to start it.
  void keep_own_clocks_inside() {
    for (std::size_t owner = 0; owner < program_.locations.size(); ++owner) {
      for (const ClockId own : program_.locations[owner].own_clocks) {
        for (Location& location : program_.locations) {
          if (location.clock_start == own && !is_inside(location, LocationId(owner))) location.clock_start.reset();
        }
      }
    }
  }

  [[nodiscard]] bool is_inside(const Location& location, LocationId owner) const {
    for (auto around = location.parent; around; around = program_.locations[around->index()].parent) {
      if (*around == owner) return true;
    }
    return false;
  }

  Condition condition() {
    Formula constraint = *formulas(program_.variables, all_variables(plant_), 1);
    if (chance(30)) {
      const auto comparison =
          pick<automata::Comparison>({automata::Comparison::at_least, automata::Comparison::less,
                                      automata::Comparison::at_most, automata::Comparison::greater});
      Formula clock = automata::clock_bound(ClockId(up_to(0, program_.clocks.size() - 1)), comparison,
                                            Ticks::of_seconds(static_cast<std::int64_t>(up_to(0, 3))));
      if (chance(30)) clock = automata::negation(std::move(clock));
      constraint = chance(50)   ? std::move(clock)
                   : chance(50) ? automata::conjunction({std::move(constraint), std::move(clock)})
                                : automata::disjunction({std::move(constraint), std::move(clock)});
    }
    if (knows_ && chance(40)) {
      constraint = chance(50) ? automata::conjunction({std::move(constraint), knowledge()})
                              : automata::disjunction({std::move(constraint), knowledge()});
    }
    return {chance(60), std::move(constraint)};
  }

  Formula knowledge() {
    using automata::Knowing;
    const automata::VariableId component = pick(plant_.components).mode;
    switch (up_to(0, 5)) {
      case 0:
        return automata::knowledge(Knowing::surprise);
      case 1:
        return automata::knowledge(Knowing::surprise, component);
      case 2:
        return automata::knowledge(Knowing::no_plan);
      case 3:
        return automata::knowledge(Knowing::no_plan, component);
      case 4:
        return automata::knowledge(Knowing::possible, *formulas(program_.variables, all_variables(plant_), 1), 0.25);
      default:
        return automata::knowledge(Knowing::likely, *formulas(program_.variables, all_variables(plant_), 1), 0.9);
    }
  }

  Assignment mode_assignment() {
    const automata::Component& component = pick(plant_.components);
    return {component.mode, automata::ValueId(up_to(0, component.modes.size() - 1))};
  }

  const automata::Plant& plant_;
  bool knows_;
  automata::Program program_;
  std::size_t owned_ = 0;  ///< how many of the clocks belong to a composite
};

}  // namespace

void showValue(const RandomProgram& program, std::ostream& out) { out << automata::to_json(program.program).dump(); }

rc::Gen<RandomProgram> programs(const automata::Plant& plant) {
  return rc::gen::exec([plant] { return RandomProgram{ProgramDraw(plant, false).draw()}; });
}

rc::Gen<RandomProgram> programs_that_know(const automata::Plant& plant) {
  return rc::gen::exec([plant] { return RandomProgram{ProgramDraw(plant, true).draw()}; });
}

rc::Gen<std::vector<std::vector<Assignment>>> knowledge_of(const automata::Plant& plant, std::size_t cycles) {
  return rc::gen::exec([plant, cycles] {
    std::vector<std::vector<Assignment>> result;
    automata::Modes modes = *modes_of(plant);
    for (std::size_t i = 0; i < cycles; ++i) {
      for (std::size_t j = 0; j < modes.size(); ++j)
        if (chance(30)) modes[j] = automata::ModeId(up_to(0, plant.components[j].modes.size() - 1));
      std::vector<Assignment> known = reference::assumptions_of(plant, modes);
      for (automata::VariableId variable : plant.observables)
        if (chance(40))
          known.push_back({variable, automata::ValueId(up_to(0, plant.variables[variable].values.size() - 1))});
      result.push_back(std::move(known));
    }
    return result;
  });
}

}  // namespace rmpl::property
