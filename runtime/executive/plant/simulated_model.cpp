// Listed ways are drawn from by weight; where they are too many, part by part, and again where the marking cannot be.
// SPDX-License-Identifier: MIT
#include "runtime/executive/plant/simulated_model.hpp"

#include <algorithm>
#include <string>

#include "base/error.hpp"
#include "base/limit_error.hpp"

namespace rmpl::runtime {

using automata::Assignment;
using automata::MarkingMoves;
using automata::MarkingOutcome;
using automata::MarkingStep;

namespace {

constexpr std::size_t most_tries = std::size_t{1} << 16;

}  // namespace

SimulatedModel::SimulatedModel(const automata::ModelProgram& program, std::uint64_t seed)
    : step_(program), moves_(seed, 1), readings_(seed, 2) {
  if (!draw(step_.rules().initial(), step_.initial())) throw base::InputError("no start is consistent");
}

void SimulatedModel::step(const automata::Command& command) {
  step_.command(command);
  if (!step_.permits(marking_))
    throw base::InputError("the command contradicts the constraints that the model program tells");
  if (!draw(step_.moves(marking_), step_.ways(marking_)))
    throw base::InputError("deadlock: no consistent marking can follow");
}

bool SimulatedModel::draw(const MarkingMoves& moves, const MarkingStep::Ways& ways) {
  if (ways) {
    if (ways->empty()) return false;
    marking_ = drawn(*ways, moves_.uniform()).target;
  } else {
    MarkingStep::Number reached = 0;
    std::size_t tries = 0;
    do {
      if (tries++ == most_tries) {
        throw base::LimitError("none of " + std::to_string(most_tries) + " draws led to a consistent marking");
      }
      std::vector<const MarkingOutcome*> outcomes;
      for (const auto& part : moves.parts) outcomes.push_back(&drawn(part, moves_.uniform()));
      reached = step_.number(united(moves, outcomes));
    } while (!step_.possible(reached));
    marking_ = reached;
  }
  if (step_.forget_but({marking_})) marking_ = 0;
  return true;
}

automata::Observation SimulatedModel::read() {
  const automata::ModelProgram& program = step_.program();
  automata::Observation result;
  for (const automata::VariableId variable : program.observables) {
    std::vector<Assignment> candidates;
    for (std::size_t v = 0; v < program.variables[variable].values.size(); ++v) {
      automata::Observation longer = result;
      longer.push_back({variable, automata::ValueId(v)});
      if (step_.store().factor(step_[marking_], longer) > 0) candidates.push_back(longer.back());
    }
    // What is entailed costs no draw, so that sensors which are sure do not shift those which are not.
    result.push_back(candidates[candidates.size() == 1 ? 0 : readings_.below(candidates.size())]);
  }
  std::sort(result.begin(), result.end());
  return result;
}

}  // namespace rmpl::runtime
