// A program is drawn by itself; its variables follow those of the plant, and some are the same.
// SPDX-License-Identifier: MIT
#include "tests/property/generate_software.hpp"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <utility>

#include "tests/property/draw.hpp"
#include "tests/property/generate_model_program.hpp"

namespace rmpl::property {
namespace {

using automata::Formula;
using automata::ModelProgram;
using automata::PlantWithModels;
using automata::ValueId;
using automata::VariableId;

void shift(Formula& formula, std::size_t offset) {
  formula.variable = VariableId(formula.variable.index() + offset);
  formula.other = VariableId(formula.other.index() + offset);
  for (Formula& operand : formula.operands) shift(operand, offset);
}

void shift(std::vector<automata::GuardedArc>& arcs, std::size_t offset) {
  for (automata::GuardedArc& arc : arcs) {
    for (automata::Condition& guard : arc.guard) shift(guard.constraint, offset);
  }
}

}  // namespace

std::vector<std::vector<automata::Assignment>> all_assignments(const automata::Variables& variables,
                                                               const std::vector<VariableId>& of) {
  std::vector<std::vector<automata::Assignment>> all{{}};
  for (const VariableId variable : of) {
    std::vector<std::vector<automata::Assignment>> longer;
    for (const auto& values : all) {
      for (std::size_t v = 0; v < variables[variable].values.size(); ++v) {
        longer.push_back(values);
        longer.back().push_back({variable, ValueId(v)});
      }
    }
    all = std::move(longer);
  }
  return all;
}

void add_software(PlantWithModels& whole, const std::string& name) {
  ModelProgram program = (*model_programs(4)).program;
  const std::size_t offset = whole.plant.variables.size();
  for (const automata::Variable& variable : program.variables) {
    whole.plant.variables.add({name + "." + variable.name, variable.values});
  }
  for (automata::ModelLocation& location : program.locations) {
    shift(location.told, offset);
    shift(location.maintenance.constraint, offset);
    shift(location.arcs, offset);
    for (automata::TransitionFunction& function : location.functions) shift(function.arcs, offset);
  }
  for (automata::Interconnection& q : program.constraints) {
    shift(q.constraint, offset);
    whole.plant.interconnections.push_back(q);
  }
  for (const automata::CommandedVariable& control : program.controls) {
    whole.plant.controls.push_back({VariableId(control.variable.index() + offset), ValueId(0)});
  }
  const std::size_t commanded = program.controls.size();
  for (std::size_t v = 0; v < program.variables.size(); ++v) {
    const VariableId own(v + offset);
    whole.plant.observables.push_back(own);
    if (v < commanded) continue;
    std::vector<VariableId> like;
    for (std::size_t other = 0; other < offset; ++other) {
      const VariableId outer(other);
      const bool same = whole.plant.variables[outer].values.size() == whole.plant.variables[own].values.size();
      if (same && !whole.plant.component_of(outer)) like.push_back(outer);
    }
    if (like.empty() || !chance(60)) continue;
    const VariableId outer = like[up_to(0, like.size() - 1)];
    std::vector<Formula> ways;
    for (std::size_t value = 0; value < whole.plant.variables[own].values.size(); ++value) {
      ways.push_back(automata::equivalence(automata::is(own, ValueId(value)), automata::is(outer, ValueId(value))));
    }
    whole.plant.interconnections.emplace_back(automata::conjunction(std::move(ways)));
  }
  whole.models.push_back({name, std::move(program)});
}

LikeMarkings::LikeMarkings(const automata::SoftwarePlant& plant, const std::vector<std::size_t>& offsets) {
  for (const automata::SoftwareThread& thread : plant.threads) {
    const auto located = [&](const automata::Marking& marking) {
      Marked result;
      for (const automata::LocationId l : marking)
        result.insert(automata::LocationId(l.index() + offsets[thread.model]));
      return result;
    };
    Thread& known = threads_.emplace_back();
    for (const std::vector<automata::Marking>& like : thread.markings) {
      for (const automata::Marking& marking : like) {
        known.first[located(marking)] = located(like.front());
        known.all.merge(located(marking));
      }
    }
  }
}

std::set<automata::LocationId> LikeMarkings::first(const std::set<automata::LocationId>& marked) const {
  Marked result;
  for (const Thread& thread : threads_) {
    Marked own;
    std::set_intersection(marked.begin(), marked.end(), thread.all.begin(), thread.all.end(),
                          std::inserter(own, own.end()));
    result.merge(Marked(thread.first.at(own)));
  }
  return result;
}

}  // namespace rmpl::property
