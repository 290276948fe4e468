// Model programs: the step and the estimators against enumeration.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "automata/step/marking_step.hpp"
#include "tests/property/draw.hpp"
#include "tests/property/generate_model_program.hpp"
#include "tests/reference/model_program.hpp"

namespace rmpl::property {
namespace {

using automata::Marking;
using automata::MarkingStep;
using automata::ModelProgram;
using reference::MarkedSet;
using reference::MarkingBelief;

MarkedSet set_of(const Marking& marking) { return {marking.begin(), marking.end()}; }

reference::Commands commands_of(const ModelProgram& program, const ModelInput& input) {
  reference::Commands result;
  for (std::size_t c = 0; c < input.command.size(); ++c) {
    if (input.command[c]) result.push_back({program.controls[c].variable, *input.command[c]});
  }
  return result;
}

void same(const MarkingBelief& found, const MarkingBelief& expected) {
  for (const auto& [marking, probability] : expected) {
    RC_ASSERT(found.contains(marking));
    RC_ASSERT(std::abs(found.at(marking) - probability) < 1e-12);
  }
  RC_ASSERT(found.size() == expected.size());
}

/// From marking to marking, every one that can be reached in a few steps.
RC_GTEST_PROP(ModelPrograms, TheStepIsTheEnumeration, ()) {
  const ModelProgram program = (*model_programs()).program;
  const std::vector<ModelInput> inputs = *model_inputs(program, 3);
  const reference::ModelProgramStep slow(program);
  MarkingStep fast(program);
  const auto belief_of = [&](const MarkingStep::Ways& ways) {
    RC_ASSERT(ways.has_value());
    MarkingBelief result;
    for (const auto& way : *ways) result[set_of(fast.rules().whole(fast[way.target]))] += way.probability;
    RC_ASSERT(result.size() == ways->size());
    return result;
  };
  const auto initial = fast.initial();
  same(belief_of(initial), slow.initial());
  std::set<MarkingStep::Number> reached;
  for (const auto& way : *initial) reached.insert(way.target);
  for (const ModelInput& input : inputs) {
    std::set<MarkingStep::Number> next;
    for (const MarkingStep::Number number : reached) {
      fast.command(input.command);
      fast.observe(input.observation);
      const MarkedSet marking = set_of(fast.rules().whole(fast[number]));
      same(belief_of(fast.ways(number)), slow.next(marking, commands_of(program, input)));
      RC_ASSERT(std::abs(fast.factor(number) - slow.factor(marking, input.observation)) < 1e-15);
      std::map<automata::VariableId, automata::ValueId> values;
      for (const auto& a : fast.store().values(fast[number])) values[a.variable] = a.value;
      RC_ASSERT(values == slow.values(marking));
      for (const auto& way : *fast.ways(number)) {
        if (next.size() < 12) next.insert(way.target);
      }
    }
    reached = next;
  }
}

}  // namespace
}  // namespace rmpl::property
