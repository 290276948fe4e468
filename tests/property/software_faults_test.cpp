// Faults of software, told by modes, against the improbable draws of the program.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <vector>

#include "automata/fault_step.hpp"
#include "automata/logic/theory.hpp"
#include "automata/software/as_components.hpp"
#include "automata/software/threads.hpp"
#include "automata/step/marking_rules.hpp"
#include "automata/step/plant_step.hpp"
#include "base/limit_error.hpp"
#include "base/product.hpp"
#include "tests/property/draw.hpp"
#include "tests/property/generate_software.hpp"
#include "tests/reference/plant_as_model.hpp"

namespace rmpl::property {
namespace {

using automata::Assignment;
using automata::Formula;
using automata::LocationId;
using automata::Marking;
using automata::ModelProgram;
using automata::Plant;
using automata::PlantWithModels;
using automata::ValueId;
using automata::VariableId;

const automata::Ticks second{automata::Ticks::per_second};

/// What is marked, with the fewest faults on the way there.
using Fewest = std::map<Marking, unsigned>;

/// The fewest faults on the ways to all that can be marked; `go_on(marking, visit)` visits what may follow, with the
/// faults of the step. Nothing where there is more than a test takes.
template <class State, class GoOn>
std::optional<std::map<State, unsigned>> fewest_faults(const std::vector<State>& start, const GoOn& go_on) {
  constexpr std::size_t most = 400;
  std::map<State, unsigned> fewest;
  std::vector<State> open = start;
  for (const State& state : start) fewest[state] = 0;
  while (!open.empty()) {
    const State state = open.back();
    open.pop_back();
    const unsigned so_far = fewest.at(state);
    go_on(state, [&](const State& next, unsigned faults) {
      const auto [known, fresh] = fewest.try_emplace(next, so_far + faults);
      if (!fresh && known->second <= so_far + faults) return;
      known->second = so_far + faults;
      open.push_back(next);
    });
    if (fewest.size() > most) return std::nullopt;
  }
  return fewest;
}

/// The markings of a program that stands alone: a step of a thread with an improbable draw is a fault of it.
class DrawsOfTheProgram {
 public:
  DrawsOfTheProgram(const ModelProgram& program, const std::map<LocationId, std::size_t>& threads)
      : program_(program), threads_(threads), rules_(program), theory_(program.variables) {
    for (const automata::Interconnection& q : program.constraints) theory_.tell(q.constraint);
    std::vector<VariableId> controls;
    for (const auto& control : program.controls) controls.push_back(control.variable);
    commands_ = all_assignments(program.variables, controls);
  }

  std::optional<Fewest> run() {
    std::vector<Marking> start;
    visit(rules_.initial(), [&](const Marking& marking, unsigned) { start.push_back(marking); });
    return fewest_faults(start, [&](const Marking& marking, const auto& next) {
      for (const auto& command : commands_) {
        std::vector<Formula> store{told(marking)};
        for (const Assignment& a : command) store.push_back(automata::is(a.variable, a.value));
        const Formula all = automata::conjunction(std::move(store));
        if (!theory_.allows({}, theory_.encode(all))) continue;
        visit(
            rules_.moves(marking,
                         [&](std::size_t c) {
                           const automata::Condition& condition = rules_.conditions()[c];
                           const Formula fails = automata::conjunction({all, automata::negation(condition.constraint)});
                           return theory_.allows({}, theory_.encode(fails)) != condition.entailed;
                         }),
            next);
      }
    });
  }

 private:
  [[nodiscard]] Formula told(const Marking& marking) const {
    std::vector<Formula> parts;
    for (const LocationId l : marking) parts.push_back(program_.locations[l.index()].told);
    return automata::conjunction(std::move(parts));
  }

  template <class Visit>
  void visit(const automata::MarkingMoves& moves, const Visit& visit) {
    base::for_each_combination(moves.parts, [&](const std::vector<automata::MarkingOutcome>& outcomes) {
      std::vector<const automata::MarkingOutcome*> taken;
      for (const automata::MarkingOutcome& outcome : outcomes) taken.push_back(&outcome);
      const Marking marking = automata::united(moves, taken);
      if (!theory_.allows({}, theory_.encode(told(marking)))) return;
      std::set<std::size_t> faulty;
      for (std::size_t p = 0; p < outcomes.size(); ++p) {
        if (outcomes[p].improbable > 0)
          faulty.insert(thread_of(moves.parts[p]).value_or(program_.locations.size() + p));
      }
      visit(marking, static_cast<unsigned>(faulty.size()));
    });
  }

  /// Nothing where all that it may mark is impossible.
  std::optional<std::size_t> thread_of(const std::vector<automata::MarkingOutcome>& part) const {
    for (const automata::MarkingOutcome& outcome : part) {
      for (const LocationId marked : outcome.marked) {
        if (const auto known = threads_.find(marked); known != threads_.end()) return known->second;
      }
    }
    return std::nullopt;
  }

  const ModelProgram& program_;
  const std::map<LocationId, std::size_t>& threads_;
  automata::MarkingRules rules_;
  automata::Theory theory_;
  std::vector<std::vector<Assignment>> commands_;
};

RC_GTEST_PROP(Software, CountsImprobableDrawsAsTheProgramDoes, ()) {
  PlantWithModels whole;
  add_software(whole, "s");
  if (chance(30)) add_software(whole, "t");
  std::optional<automata::SoftwarePlant> made;
  try {
    made.emplace(automata::with_software(whole));
  } catch (const base::LimitError&) {
    return;
  }
  const Plant& plant = made->plant;
  const ModelProgram program = reference::as_model_program(whole.plant, whole.models);
  std::vector<std::size_t> offsets{1};
  for (const automata::ModelComponent& model : whole.models) {
    offsets.push_back(offsets.back() + model.program.locations.size());
  }
  std::map<LocationId, std::size_t> threads;
  const auto marked = [&](const automata::Modes& modes) {
    Marking marking;
    for (std::size_t t = 0; t < made->threads.size(); ++t) {
      const automata::SoftwareThread& thread = made->threads[t];
      for (const LocationId l : thread.markings[modes[t].index()].front()) {
        marking.emplace_back(l.index() + offsets[thread.model]);
      }
    }
    std::sort(marking.begin(), marking.end());
    return marking;
  };
  std::size_t number = 0;
  for (std::size_t m = 0; m < whole.models.size(); ++m) {
    ModelProgram own = whole.models[m].program;
    own.variables = whole.plant.variables;
    own.constraints = whole.plant.interconnections;
    for (const automata::Thread& thread : automata::threads_of(own)) {
      ++number;
      for (const automata::ThreadMarking& marking : thread.markings) {
        for (const LocationId l : marking.marked) threads[LocationId(l.index() + offsets[m])] = number;
      }
    }
  }
  const auto expected = DrawsOfTheProgram(program, threads).run();
  if (!expected) return;

  automata::PlantStep step(plant);
  std::vector<VariableId> controls;
  for (const automata::Control& control : plant.controls) controls.push_back(control.variable);
  std::vector<automata::ControlAction> commands;
  for (const auto& given : all_assignments(plant.variables, controls)) {
    automata::ControlAction& action = commands.emplace_back();
    for (const Assignment& a : given) action.push_back(a.value);
  }
  const auto visit = [&](const std::vector<std::vector<automata::Move>>& moves, const auto& each) {
    base::for_each_combination(moves, [&](const std::vector<automata::Move>& taken) {
      automata::Modes modes;
      for (const automata::Move& move : taken) modes.push_back(move.mode);
      if (step.possible(modes)) each(modes);
    });
  };
  std::vector<automata::Modes> start;
  visit(step.initial_moves(), [&](const automata::Modes& modes) { start.push_back(modes); });
  const auto by_modes = fewest_faults(start, [&](const automata::Modes& from, const auto& next) {
    for (const automata::ControlAction& action : commands) {
      if (!step.consistent(from, action)) continue;
      const std::vector<automata::Ticks> clocks(from.size());
      const auto moves = step.moves({from, clocks}, action, {}, second);
      visit(moves, [&](const automata::Modes& to) {
        unsigned faults = 0;
        for (std::size_t c = 0; c < to.size(); ++c) {
          faults += automata::is_fault_step(plant.components[c], from[c], to[c]) ? 1 : 0;
        }
        next(to, faults);
      });
    }
  });
  if (!by_modes) return;
  Fewest found;
  for (const auto& [modes, faults] : *by_modes) {
    const auto [known, fresh] = found.try_emplace(marked(modes), faults);
    if (!fresh) known->second = std::min(known->second, faults);
  }
  const LikeMarkings like(*made, offsets);
  Fewest first;
  for (const auto& [marking, faults] : *expected) {
    const std::set<LocationId> known_by = like.first({marking.begin(), marking.end()});
    const auto [known, fresh] = first.try_emplace(Marking(known_by.begin(), known_by.end()), faults);
    if (!fresh) known->second = std::min(known->second, faults);
  }
  RC_ASSERT(found == first);
  const auto has_faults = [](const auto& one) { return one.second > 0; };
  RC_CLASSIFY(std::any_of(found.begin(), found.end(), has_faults), "faults on the way");
  RC_CLASSIFY(by_modes->size() > found.size(), "markings with several modes");
}

}  // namespace
}  // namespace rmpl::property
