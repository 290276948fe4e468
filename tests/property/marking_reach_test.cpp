// What a model program by itself can come to, as the plant of its threads, against an enumeration of its markings.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "automata/software/as_components.hpp"
#include "base/limit_error.hpp"
#include "tests/property/draw.hpp"
#include "tests/property/generate.hpp"
#include "tests/property/generate_model_program.hpp"
#include "tests/reference/marking_reach.hpp"
#include "verifier/check/check.hpp"

namespace rmpl::property {
namespace {

using automata::ModelProgram;
using automata::Ticks;
using reference::MarkingLayer;
using verifier::Commands;

constexpr std::size_t most_steps = 6;
constexpr automata::Ticks period = automata::Ticks::of_seconds(2);

struct Question {
  automata::Formula formula;
  verifier::Window window;
  Commands commands = Commands::one;
  bool entailed = false;
  bool safety = false;
};

Question question_about(const ModelProgram& program) {
  Question question;
  question.safety = chance(50);
  std::vector<automata::VariableId> variables;
  for (std::size_t v = 0; v < program.variables.size(); ++v) variables.emplace_back(v);
  question.formula =
      automata::conjunction({*formulas(program.variables, variables, 1), *formulas(program.variables, variables, 1)});
  if (chance(30)) question.window.not_before = Ticks{static_cast<std::int64_t>(up_to(0, 7)) * Ticks::per_second};
  if (chance(50)) question.window.by = Ticks{static_cast<std::int64_t>(up_to(0, 9)) * Ticks::per_second};
  question.commands = pick(std::vector{Commands::none, Commands::one, Commands::any});
  question.entailed = chance(60);
  return question;
}

/// A control without an idle value is unknown, or has any value.
std::vector<reference::Commands> free_commands(const ModelProgram& program, Commands commands) {
  std::vector<reference::Commands> all;
  std::vector<std::optional<automata::ValueId>> chosen;
  const auto choose = [&](const auto& self, std::size_t busy) -> void {
    if (chosen.size() == program.controls.size()) {
      auto& known = all.emplace_back();
      for (std::size_t c = 0; c < chosen.size(); ++c) {
        if (chosen[c]) known.push_back({program.controls[c].variable, *chosen[c]});
      }
      return;
    }
    const automata::CommandedVariable& control = program.controls[chosen.size()];
    chosen.push_back(control.idle);
    self(self, busy);
    chosen.pop_back();
    if (commands == Commands::none || (commands == Commands::one && busy > 0)) return;
    for (std::size_t v = 0; v < program.variables[control.variable].values.size(); ++v) {
      if (control.idle == automata::ValueId(v)) continue;
      chosen.emplace_back(automata::ValueId(v));
      self(self, busy + 1);
      chosen.pop_back();
    }
  };
  choose(choose, 0);
  return all;
}

/// The steps that count, and the most that were looked at.
struct Steps {
  std::size_t first, last;
};

Steps steps_of(const verifier::Window& window) {
  Steps result{0, most_steps};
  while (window.not_before && static_cast<std::int64_t>(result.first) * period.count < window.not_before->count) {
    ++result.first;
  }
  while (window.by && static_cast<std::int64_t>(result.last) * period.count > window.by->count) --result.last;
  return result;
}

/// Whether nothing new came in the last layer, so that nothing ever will.
bool settled(const std::vector<MarkingLayer>& layers) {
  return std::all_of(layers.back().begin(), layers.back().end(), [&](const auto& one) {
    return std::any_of(layers.begin(), layers.end() - 1, [&](const auto& layer) { return layer.contains(one.first); });
  });
}

/// What is told never contradicts a command, which would enable every guard of the plant, and lead nowhere by itself.
bool tells_of_commands(const ModelProgram& program) {
  const auto speaks = [&](const automata::Formula& formula) {
    const auto variables = automata::variables_of(formula);
    return std::any_of(program.controls.begin(), program.controls.end(), [&](const auto& control) {
      return std::binary_search(variables.begin(), variables.end(), control.variable);
    });
  };
  return std::any_of(program.locations.begin(), program.locations.end(),
                     [&](const auto& location) { return speaks(location.told); }) ||
         std::any_of(program.constraints.begin(), program.constraints.end(),
                     [&](const auto& q) { return speaks(q.constraint); });
}

RC_GTEST_PROP(MarkingReach, IsTheEnumeration, ()) {
  const ModelProgram program = (*model_programs(4)).program;
  RC_PRE(!tells_of_commands(program));
  const Question question = question_about(program);
  std::optional<automata::SoftwarePlant> made;
  try {
    made.emplace(automata::with_software(automata::plant_of(program)));
  } catch (const base::LimitError&) {
    return;
  }
  const reference::ModelProgramStep slow(program);
  const auto layers = marking_layers(slow, free_commands(program, question.commands), most_steps);
  if (!question.window.by) RC_PRE(settled(layers) && !question.window.not_before);
  const Steps steps = steps_of(question.window);
  RC_PRE(steps.first <= steps.last);
  bool reached = false;
  for (std::size_t s = steps.first; s <= steps.last; ++s) {
    reached = reached || std::any_of(layers[s].begin(), layers[s].end(), [&](const auto& one) {
                return question.entailed ? slow.entails(one.first, question.formula)
                                         : slow.allows(one.first, question.formula);
              });
  }
  verifier::Slices slices(made->plant);
  verifier::CheckOptions options;
  options.period = period;
  options.faults = 1000;
  options.commands = question.commands;
  options.entailed = question.entailed;
  const verifier::Property property =
      question.safety ? verifier::Property(verifier::Safety{question.formula, question.window, false})
                      : verifier::Property(verifier::Reachability{question.formula, question.window, false});
  const verifier::Answer answer = verifier::check(slices, property, options, {});
  RC_ASSERT(answer.verdict == (reached == question.safety ? verifier::Verdict::violated : verifier::Verdict::holds));
  RC_CLASSIFY(reached, "reached");
  RC_CLASSIFY(!program.controls.empty(), "commanded");
}

}  // namespace
}  // namespace rmpl::property
