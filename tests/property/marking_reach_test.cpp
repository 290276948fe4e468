// Reachability and safety of random model programs against enumeration.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <map>
#include <optional>
#include <vector>

#include "automata/step/marking_rules.hpp"
#include "tests/property/draw.hpp"
#include "tests/property/generate.hpp"
#include "tests/property/generate_model_program.hpp"
#include "tests/reference/marking_reach.hpp"
#include "verifier/marking/check.hpp"
#include "verifier/marking/commands.hpp"

namespace rmpl::property {
namespace {

using automata::ModelProgram;
using automata::Ticks;
using reference::MarkedSet;
using reference::MarkingLayer;
using verifier::MarkingAnswer;
using verifier::MarkingQuestion;

constexpr std::size_t most_steps = 6;

MarkingQuestion question_about(const ModelProgram& program) {
  MarkingQuestion question;
  question.kind = chance(50) ? MarkingQuestion::Kind::safety : MarkingQuestion::Kind::reachability;
  std::vector<automata::VariableId> variables;
  for (std::size_t v = 0; v < program.variables.size(); ++v) variables.emplace_back(v);
  question.formula =
      automata::conjunction({*formulas(program.variables, variables, 1), *formulas(program.variables, variables, 1)});
  question.period = Ticks::of_seconds(2);
  if (chance(30)) question.window.not_before = Ticks{static_cast<std::int64_t>(up_to(0, 7)) * Ticks::per_second};
  if (chance(50)) question.window.by = Ticks{static_cast<std::int64_t>(up_to(0, 9)) * Ticks::per_second};
  question.commands = pick(std::vector{verifier::Commands::none, verifier::Commands::one, verifier::Commands::any});
  if (chance(60)) question.improbable = static_cast<unsigned>(up_to(0, 3));
  question.fewest_improbable = chance(30);
  question.entailed = chance(60);
  return question;
}

/// The steps that count, and the most that were looked at.
struct Window {
  std::size_t first, last;
};

Window window_of(const MarkingQuestion& question) {
  const std::int64_t period = question.period.count;
  Window result{0, most_steps};
  while (question.window.not_before &&
         static_cast<std::int64_t>(result.first) * period < question.window.not_before->count) {
    ++result.first;
  }
  while (question.window.by && static_cast<std::int64_t>(result.last) * period > question.window.by->count)
    --result.last;
  return result;
}

struct Expected {
  std::optional<std::size_t> steps;  ///< of the soonest witness
  reference::Reached best;           ///< of those
  std::optional<unsigned> fewest;    ///< of any witness
  bool stuck = false;
};

Expected expected_of(const reference::ModelProgramStep& slow, const std::vector<MarkingLayer>& layers,
                     const std::vector<reference::Commands>& free, const MarkingQuestion& question) {
  Expected result;
  const Window window = window_of(question);
  for (std::size_t s = 0; s <= window.last; ++s) {
    for (const auto& [marking, reached] : layers[s]) {
      if (question.improbable && reached.improbable > *question.improbable) continue;
      bool goes_on = s == window.last;
      for (const auto& commands : free) {
        slow.for_each_next(marking, commands, [&](const MarkedSet&, double, unsigned) { goes_on = true; });
      }
      result.stuck = result.stuck || !goes_on;
      const bool holds =
          question.entailed ? slow.entails(marking, question.formula) : slow.allows(marking, question.formula);
      if (s < window.first || !holds) continue;
      if (!result.steps || (*result.steps == s && reached < result.best)) result.best = reached;
      if (!result.steps) result.steps = s;
      result.fewest = std::min(result.fewest.value_or(reached.improbable), reached.improbable);
    }
  }
  return result;
}

/// Whether nothing new came in the last layer, so that nothing ever will.
bool settled(const std::vector<MarkingLayer>& layers) {
  MarkingLayer before;
  for (std::size_t s = 0; s + 1 < layers.size(); ++s) {
    for (const auto& [marking, reached] : layers[s]) {
      const auto known = before.try_emplace(marking, reached).first;
      known->second = std::min(known->second, reached);
    }
  }
  return std::all_of(layers.back().begin(), layers.back().end(), [&](const auto& one) {
    const auto known = before.find(one.first);
    return known != before.end() && known->second.improbable <= one.second.improbable;
  });
}

std::size_t draws_in(const verifier::MarkingWitness& witness) {
  std::size_t result = 0;
  for (const auto& event : witness.events) result += event.draws.size();
  return result;
}

std::size_t commanded_in(const verifier::MarkingWitness& witness, const ModelProgram& program) {
  std::size_t result = 0;
  for (std::size_t e = 1; e < witness.events.size(); ++e) {
    const automata::Command& command = witness.events[e].command;
    for (std::size_t c = 0; c < command.size(); ++c) result += command[c] != program.controls[c].idle ? 1 : 0;
  }
  return result;
}

RC_GTEST_PROP(MarkingReach, IsTheEnumeration, ()) {
  const ModelProgram program = (*model_programs(4)).program;
  const MarkingQuestion question = question_about(program);
  const reference::ModelProgramStep slow(program);
  std::vector<reference::Commands> free;
  for (const automata::Command& command : verifier::free_commands(program, question.commands)) {
    auto& known = free.emplace_back();
    for (std::size_t c = 0; c < command.size(); ++c) {
      if (command[c]) known.push_back({program.controls[c].variable, *command[c]});
    }
  }
  const auto layers = marking_layers(slow, free, most_steps);
  if (!question.window.by) RC_PRE(settled(layers) && !question.window.not_before);
  const Expected expected = expected_of(slow, layers, free, question);
  const MarkingAnswer answer = check(program, question, {});
  RC_ASSERT(!answer.limit);
  RC_ASSERT(answer.witness.has_value() == expected.steps.has_value());
  const bool wanted = question.kind == MarkingQuestion::Kind::reachability;
  RC_ASSERT((answer.verdict == verifier::Verdict::holds) == (answer.witness.has_value() == wanted));
  RC_ASSERT(answer.startless == (layers.front().empty() && window_of(question).first <= window_of(question).last));
  if (!answer.witness) {
    if (window_of(question).first <= window_of(question).last) RC_ASSERT(answer.stuck == expected.stuck);
    return;
  }
  if (question.fewest_improbable) {
    RC_ASSERT(draws_in(*answer.witness) == *expected.fewest);
  } else {
    RC_ASSERT(answer.witness->events.size() == *expected.steps + 1);
    RC_ASSERT(draws_in(*answer.witness) == expected.best.improbable);
    RC_ASSERT(commanded_in(*answer.witness, program) == expected.best.commanded);
  }
}

}  // namespace
}  // namespace rmpl::property
