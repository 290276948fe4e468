// The verifier's symbolic search against explicit search, tick by tick, in both readings of time.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "tests/property/draw.hpp"
#include "tests/property/generate.hpp"
#include "tests/reference/reachability.hpp"
#include "verifier/property/property.hpp"

namespace property {
namespace {

using automata::Ticks;

struct Drawn {
  reference::Question question;
  verifier::CheckOptions options;
};

Drawn draw_question(const automata::Plant& plant) {
  Drawn drawn;
  drawn.question.target = chance(30) ? *formulas(plant.variables, all_variables(plant), 1)
                                     : automata::conjunction_of(reference::assumptions_of(plant, *modes_of(plant)));
  drawn.question.entailed = drawn.options.entailed = chance(30);
  drawn.question.faults = up_to(0, 2);
  drawn.options.faults = static_cast<unsigned>(drawn.question.faults);
  switch (up_to(0, 3)) {
    case 0:
      drawn.question.commands = reference::Question::Commands::none;
      drawn.options.commands = verifier::Commands::none;
      break;
    case 1:
      drawn.question.commands = reference::Question::Commands::any;
      drawn.options.commands = verifier::Commands::any;
      break;
    default:
      break;
  }
  return drawn;
}

/// How many steps of a trace change a mode.
std::size_t changes(const verifier::Trace& trace) {
  std::size_t count = 0;
  for (std::size_t i = 1; i < trace.size(); ++i) count += trace[i].modes != trace[i - 1].modes;
  return count;
}

void compare(const Model& model, const Drawn& drawn, const std::optional<std::size_t>& fewest) {
  automata::PlantStep step(model.plant);
  const verifier::Result reached =
      verifier::check(step, verifier::Reachability{.target = drawn.question.target, .window = {}}, drawn.options, {});
  RC_ASSERT(reached.verdict == (fewest ? verifier::Verdict::holds : verifier::Verdict::violated));
  RC_ASSERT(reached.trace.has_value() == fewest.has_value());
  if (fewest) RC_ASSERT(changes(*reached.trace) == *fewest);

  const verifier::Result safe =
      verifier::check(step, verifier::Safety{.never = drawn.question.target, .window = {}}, drawn.options, {});
  RC_ASSERT(safe.verdict == (fewest ? verifier::Verdict::violated : verifier::Verdict::holds));
}

void compare_response(const Model& model, const Drawn& drawn, const std::optional<std::size_t>& missed) {
  automata::PlantStep step(model.plant);
  const reference::Response& asked = *drawn.question.response;
  const verifier::Result result =
      verifier::check(step, verifier::Response{asked.after, asked.then, asked.within}, drawn.options, {});
  RC_ASSERT(result.verdict == (missed ? verifier::Verdict::violated : verifier::Verdict::holds));
}

Drawn draw_response(const automata::Plant& plant) {
  Drawn drawn = draw_question(plant);
  const auto formula = [&] { return *formulas(plant.variables, all_variables(plant), 0); };
  drawn.question.response = {formula(), formula(), Ticks::of_seconds(static_cast<std::int64_t>(up_to(0, 4)))};
  return drawn;
}

RC_GTEST_PROP(Reachability, DenseResponseIsTheGrid, ()) {
  const Model model = *models();
  const Drawn drawn = draw_response(model.plant);
  const reference::Step slow(model.plant);
  compare_response(model, drawn, reference::fewest_steps_dense(slow, drawn.question, Ticks::of_seconds(1)));
}

RC_GTEST_PROP(Reachability, SampledResponseIsTheTicks, ()) {
  const Model model = *models();
  Drawn drawn = draw_response(model.plant);
  const Ticks period = pick<Ticks>({{Ticks::per_second}, {Ticks::per_second / 2}, {3 * Ticks::per_second / 4}});
  drawn.options.period = period;
  const reference::Step slow(model.plant);
  compare_response(model, drawn, reference::fewest_steps_sampled(slow, drawn.question, period));
}

RC_GTEST_PROP(Reachability, DenseIsTheGrid, ()) {
  const Model model = *models();
  const Drawn drawn = draw_question(model.plant);
  const reference::Step slow(model.plant);
  compare(model, drawn, reference::fewest_steps_dense(slow, drawn.question, Ticks::of_seconds(1)));
}

/// Small halves: the twin explores their product.
constexpr Shape half{.max_components = 2, .max_modes = 3, .max_attributes = 3, .densities = false};

RC_GTEST_PROP(Reachability, SymmetricDenseIsTheGrid, ()) {
  const Model model = *mirrored(half);
  const Drawn drawn = draw_question(model.plant);
  const reference::Step slow(model.plant);
  compare(model, drawn, reference::fewest_steps_dense(slow, drawn.question, Ticks::of_seconds(1)));
}

RC_GTEST_PROP(Reachability, SymmetricDenseResponseIsTheGrid, ()) {
  const Model model = *mirrored(half);
  const Drawn drawn = draw_response(model.plant);
  const reference::Step slow(model.plant);
  compare_response(model, drawn, reference::fewest_steps_dense(slow, drawn.question, Ticks::of_seconds(1)));
}

RC_GTEST_PROP(Reachability, SymmetricSampledIsTheTicks, ()) {
  const Model model = *mirrored(half);
  Drawn drawn = draw_question(model.plant);
  drawn.options.period = Ticks::of_seconds(1);
  const reference::Step slow(model.plant);
  compare(model, drawn, reference::fewest_steps_sampled(slow, drawn.question, Ticks::of_seconds(1)));
}

RC_GTEST_PROP(Reachability, SampledIsTheTicks, ()) {
  const Model model = *models();
  Drawn drawn = draw_question(model.plant);
  const Ticks period = pick<Ticks>({{Ticks::per_second}, {Ticks::per_second / 2}, {3 * Ticks::per_second / 4}});
  drawn.options.period = period;
  const reference::Step slow(model.plant);
  compare(model, drawn, reference::fewest_steps_sampled(slow, drawn.question, period));
}

}  // namespace
}  // namespace property
