// Model programs that say the same in other words mean the same: random texts, compiled, and all that can happen in a
// few steps (semantics 8).
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "automata/step/marking_step.hpp"
#include "compiler/session/compiler.hpp"
#include "compiler/session/provider.hpp"
#include "grammar/source/render.hpp"
#include "tests/property/draw.hpp"

namespace rmpl::property {
namespace {

using automata::Assignment;
using automata::MarkingStep;

std::string constraint() {
  return pick<std::string>({"x = a", "x = b", "y = a", "y = b", "x = a & y = b", "x = a | y = a"});
}

std::string step(int depth);

/// A step that tells nothing at once, as a branch of a `choose`.
std::string quiet(int depth) {
  switch (depth == 0 ? 0 : up_to(0, 6)) {
    case 1:
      return "if " + constraint() + " thennext " + step(depth - 1) + " elsenext " + step(depth - 1);
    case 2:
      return "unless " + constraint() + " thennext " + step(depth - 1);
    case 3:
      return "{ " + quiet(depth - 1) + ", " + quiet(depth - 1) + " }";
    case 4:
      return "{ " + quiet(depth - 1) + "; " + step(depth - 1) + " }";
    case 5:
      return "{ do " + quiet(depth - 1) + " watching " + constraint() + " }";
    case 6:
      return "always " + quiet(depth - 1);
    default:
      return "next " + step(depth == 0 ? 0 : depth - 1);
  }
}

std::string chosen(int depth) { return "choose { " + quiet(depth) + " with 0.25, " + quiet(depth) + " with 0.75 }"; }

std::string step(int depth) {
  switch (depth == 0 ? 0 : up_to(0, 7)) {
    case 1:
      return "{ " + step(depth - 1) + ", " + step(depth - 1) + " }";
    case 2:
      return "{ " + step(depth - 1) + "; " + step(depth - 1) + " }";
    case 3:
      return "{ do " + step(depth - 1) + " watching " + constraint() + " }";
    case 4:
      return "when " + constraint() + " donext " + step(depth - 1);
    case 5:
      return quiet(depth);
    case 6:
      return chosen(depth - 1);
    case 7:
      return "always next " + step(depth - 1);
    default:
      return constraint();
  }
}

/// What is known of the variables, step by step, with its probability.
using Histories = std::map<std::vector<std::vector<Assignment>>, double>;

Histories histories(const std::string& body) {
  const std::string file = "model.rmpl";
  compiler::Memory texts;
  texts.put(file, "variable x, y : { a, b };\nmodel Main() :: { " + body + " }\n");
  const compiler::Compilation compiled = compiler::compile({&file, 1}, {}, texts);
  RC_LOG() << body << '\n' << grammar::render_text(compiled.findings(), false);
  RC_ASSERT(compiled.ok());
  MarkingStep steps(compiled.document().models.front());
  using State = std::pair<std::vector<std::vector<Assignment>>, MarkingStep::Number>;
  std::map<State, double> now;
  const MarkingStep::Ways initial = steps.initial();
  RC_PRE(initial.has_value());
  for (const MarkingStep::Way& way : *initial) now[{{steps.values(way.target)}, way.target}] += way.probability;
  steps.command({});
  for (std::size_t s = 0; s < 4; ++s) {
    std::map<State, double> next;
    for (const auto& [state, probability] : now) {
      const MarkingStep::Ways ways = steps.ways(state.second);
      RC_PRE(ways.has_value() && next.size() < 4000);
      for (const MarkingStep::Way& way : *ways) {
        auto history = state.first;
        history.push_back(steps.values(way.target));
        next[{std::move(history), way.target}] += probability * way.probability;
      }
    }
    now = std::move(next);
  }
  Histories result;
  for (const auto& [state, probability] : now) result[state.first] += probability;
  return result;
}

void same(const std::string& one, const std::string& other) {
  const Histories found = histories(one);
  const Histories expected = histories(other);
  RC_ASSERT(found.size() == expected.size());
  for (const auto& [history, probability] : expected) {
    const auto at = found.find(history);
    RC_ASSERT(at != found.end());
    RC_ASSERT(std::abs(at->second - probability) < 1e-12);
  }
}

RC_GTEST_PROP(ModelSource, AChoiceOfOneIsThatOne, ()) {
  const std::string branch = quiet(3);
  same("always choose { " + branch + " with 1 }", "always " + branch);
  same("next choose { " + branch + " with 1 }", "next " + branch);
}

RC_GTEST_PROP(ModelSource, ChoicesAreDistributed, ()) {
  const std::string a = quiet(2), b = quiet(2), c = quiet(2);
  const std::string before = pick<std::string>({"next ", "always ", ""});
  same(before + "choose { " + a + " with 0.5, choose { " + b + " with 0.25, " + c + " with 0.75 } with 0.5 }",
       before + "choose { " + a + " with 0.5, " + b + " with 0.125, " + c + " with 0.375 }");
}

RC_GTEST_PROP(ModelSource, AChoiceBesideAnotherThreadOfItsBranch, ()) {
  const std::string a = quiet(2), b = quiet(2), c = quiet(2);
  const std::string before = pick<std::string>({"next ", ""});
  same(before + "choose { { " + a + ", choose { " + b + " with 0.25, " + c + " with 0.75 } } with 1 }",
       before + "choose { { " + a + ", " + b + " } with 1, { " + a + ", " + c + " } with 3 }");
}

RC_GTEST_PROP(ModelSource, WhatIsDrawnBeforeTheStartMayTellAtOnce, ()) {
  const std::string a = step(2), b = step(2);
  const Histories both = histories("choose { " + a + " with 0.25, " + b + " with 0.75 }");
  Histories expected;
  for (const auto& [history, probability] : histories(a)) expected[history] += 0.25 * probability;
  for (const auto& [history, probability] : histories(b)) expected[history] += 0.75 * probability;
  RC_ASSERT(both.size() == expected.size());
  for (const auto& [history, probability] : expected) RC_ASSERT(std::abs(both.at(history) - probability) < 1e-12);
}

RC_GTEST_PROP(ModelSource, RecursionIsAlways, ()) {
  const std::string a = step(2);
  const std::string name = "P() } model P() :: { ";
  same("always " + a, name + "{ " + a + " }, next P()");
}

}  // namespace
}  // namespace rmpl::property
