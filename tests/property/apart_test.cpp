// Parts that are asked by themselves, against a search of the whole plant.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <vector>

#include "tests/property/draw.hpp"
#include "tests/property/generate.hpp"
#include "tests/reference/step.hpp"
#include "verifier/check/check.hpp"

namespace rmpl::property {
namespace {

using automata::Ticks;

/// Two like halves, with what is free in a question about them.
struct Drawn {
  Model model;
  verifier::CheckOptions options;
};

Drawn draw() {
  Shape half{.max_components = 2, .max_modes = 4, .max_attributes = 3};
  half.tangled = chance(40);
  Drawn drawn{*mirrored(half), {}};
  drawn.options.faults = static_cast<unsigned>(up_to(0, 2));
  drawn.options.merge = chance(80);
  drawn.options.symmetry = chance(50);
  if (chance(50))
    drawn.options.commands = pick<verifier::Commands>({verifier::Commands::none, verifier::Commands::any});
  if (chance(40)) drawn.options.period = pick<Ticks>({Ticks::of_seconds(1), {3 * Ticks::per_second / 4}});
  return drawn;
}

void compare(const Drawn& drawn, const verifier::Property& property) {
  verifier::Limits limits;
  limits.states = 50000;
  const auto ask = [&](bool slice) {
    verifier::CheckOptions options = drawn.options;
    options.slice = slice;
    verifier::Slices slices(drawn.model.plant);
    return verifier::check(slices, property, options, limits);
  };
  const verifier::Answer whole = ask(false);
  const verifier::Answer apart = ask(true);
  RC_PRE(!whole.limit && !apart.limit);
  RC_CLASSIFY(whole.witness.has_value(), "a witness");
  for (const automata::Formula& one : verifier::formulas_of(property)) {
    RC_LOG() << to_text(one, drawn.model.plant.variables) << '\n';
  }
  RC_LOG() << verifier::name_of(property) << ", faults " << *drawn.options.faults << ", dense " << !drawn.options.period
           << ", commands " << static_cast<int>(drawn.options.commands) << ", whole " << static_cast<int>(whole.verdict)
           << ", cut off " << whole.cut_off.stuck << whole.cut_off.still << whole.cut_off.spent << ", apart "
           << static_cast<int>(apart.verdict) << ", cut off " << apart.cut_off.stuck << apart.cut_off.still
           << apart.cut_off.spent << '\n';
  // A cone is taken to be able to go on where the rest of the plant is stuck, or time stands still in it; and it goes
  // on where a fault of the rest is certain beyond the budget, up to where time stands still in the cone itself.
  if (whole.cut_off.ends() || whole.cut_off.spent || apart.cut_off.ends()) return;
  if (whole.witness && whole.witness->stop && !std::holds_alternative<verifier::Stuck>(property)) return;
  RC_ASSERT(apart.verdict == whole.verdict);
  RC_ASSERT(apart.witness.has_value() == whole.witness.has_value());
}

RC_GTEST_PROP(Apart, EachGoesOnAsAllDo, ()) { compare(draw(), verifier::Stuck{}); }

RC_GTEST_PROP(Apart, AResponseComesInItsPart, ()) {
  Drawn drawn = draw();
  const automata::Plant& plant = drawn.model.plant;
  const std::vector<automata::Assignment> modes = reference::assumptions_of(plant, *modes_of(plant));
  std::vector<automata::Formula> after;
  for (const automata::Assignment& mode : modes) {
    if (chance(70)) after.push_back(automata::is(mode.variable, mode.value));
  }
  if (after.empty()) after.push_back(automata::constant(true));
  const automata::Assignment then = pick(reference::assumptions_of(plant, *modes_of(plant)));
  drawn.options.entailed = chance(20);
  compare(drawn, verifier::Response{automata::conjunction(after), automata::is(then.variable, then.value),
                                    Ticks::of_seconds(static_cast<std::int64_t>(up_to(0, 8)))});
}

}  // namespace
}  // namespace rmpl::property
